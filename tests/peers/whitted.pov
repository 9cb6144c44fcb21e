// whitted.yaml for POV-Ray 3.7. Metres, y up; x is turned round in the camera, since POV-Ray is left-handed.
#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 5 }

// A point light of I W/sr lights a diffuse surface of albedo a to the radiance a I cos / (pi d^2). POV-Ray's light of colour
// c with fading has a c cos 2 / (1 + (d / fade_distance)^2): the same for fade_distance much less than d, and this c.
#declare Intensity = 400;
#declare Fade = 0.01;
light_source {
  <-4, 8, 6>
  color rgb Intensity / (pi * 2 * Fade * Fade)
  fade_distance Fade
  fade_power 2
}
camera {
  location <0, 3.4, 9>
  up y
  right -x * 4 / 3
  direction z * 0.5 / tan(radians(17)) // a vertical field of view of 34 degrees
  look_at <0, 0.9, 0>
}

#declare Matte = finish { ambient 0 diffuse 1 }
#declare Blue = texture { pigment { rgb <0.1, 0.25, 0.62> } finish { Matte } }
#declare Amber = texture { pigment { rgb <0.85, 0.5, 0.08> } finish { Matte } }
#declare Red = texture { pigment { rgb <0.7, 0.12, 0.1> } finish { Matte } }
#declare Green = texture { pigment { rgb <0.15, 0.5, 0.18> } finish { Matte } }
#declare Silver = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 0.9 } }
#declare Glass = texture {
  pigment { rgbt <1, 1, 1, 1> }
  finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
}

plane { y, 0 texture { pigment { checker rgb 0.15, rgb 0.8 translate -y * 0.5 } finish { Matte } } }
plane { z, -6 texture { pigment { rgb <0.4, 0.5, 0.6> } finish { Matte } } }
sphere { <-1.3, 1, -1.5>, 1 texture { Silver } }
sphere { <0.9, 0.7, 1.6>, 0.7 texture { Glass } interior { ior 1.5 } }
cylinder { <2.6, 0, 0.6>, <2.6, 1.3, 0.6>, 0.45 texture { Green } }
cone { <-2.6, 0, 1.2>, 0.55, <-2.6, 1.5, 1.2>, 0 texture { Red } }
sphere { 0, 1 scale <0.6, 0.4, 0.4> translate <-0.6, 0.4, 2.6> texture { Amber } }
intersection {
  quadric { <4, -1, 4>, <0, 0, 0>, <0, 0, 0>, -0.5 }
  box { <-1, -0.8, -1>, <1, 0.8, 1> }
  texture { Blue }
  translate <3.3, 0.8, -2>
}
difference {
  intersection {
    box { -0.6, 0.6 texture { Blue } }
    sphere { 0, 0.8 texture { Amber } }
  }
  union {
    cylinder { -x, x, 0.35 }
    cylinder { -y, y, 0.35 }
    cylinder { -z, z, 0.35 }
    texture { Red }
  }
  rotate y * 30 // against the left hand's sense: the axes of both programs are the same
  translate <0.9, 0.6, -0.6>
}
difference {
  box { -0.6, 0.6 texture { Green } }
  sphere { 0.35, 0.65 texture { Amber } }
  rotate y * -15
  translate <-3.2, 0.6, -1.2>
}
