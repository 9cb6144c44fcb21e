// The projection map: caustic photons are aimed only at specular objects, through spheres that bound them [Jensen01,
// ch. 5]. Seen from a point of a light each sphere is a cone of directions; across parallel light it is a disc of
// origins. One is picked in proportion to its size and a ray sampled uniformly within it; where they overlap the
// density is the sum of theirs, so a photon's weight exactly cancels the gain in probability over unaimed emission.
#ifndef HYALITE_PROJECTION_GLSL
#define HYALITE_PROJECTION_GLSL
#include "lights/light.glsl"

// From a point inside a sphere, or this close to it, the sphere fills the view [radii].
const float kCloseToTarget = 1.0001;

// A sphere as a target from a point (a cone) or along a direction (a disc).
struct Aim {
    vec3 axis;     // unit, from the point to the centre; or the centre, across parallel light [m]
    float size;    // solid angle [sr], or area of the disc [m^2]
    float extent;  // 1 - cosine of the cone's half-angle; or squared radius of the disc [m^2]
    bool anywhere; // it covers everything the light emits into: the light's own sample is used
};

Aim aimFromPoint(TargetRecord target, LightRecord light, vec3 point) {
    vec3 way = target.center - point;
    float distance2 = dot(way, way);
    float sine2 = target.radius * target.radius / distance2;
    float extent = sine2 / (1.0 + sqrt(max(0.0, 1.0 - sine2))); // 1 - cosine, in a form that stays accurate in narrow cones
    float own = emissionExtent(light);
    if (!(sine2 * kCloseToTarget * kCloseToTarget < 1.0 && extent < own)) {
        return Aim(vec3(0.0), 2.0 * kPi * own, own, true);
    }
    return Aim(way / sqrt(distance2), 2.0 * kPi * extent, extent, false);
}

Aim aimAlong(TargetRecord target, LightRecord light) {
    if (target.radius >= light.radius) {
        return Aim(vec3(0.0), light.area, 0.0, true);
    }
    float radius2 = target.radius * target.radius;
    return Aim(target.center, kPi * radius2, radius2, false);
}

Aim aimAt(TargetRecord target, LightRecord light, bool parallel, vec3 point) {
    if (parallel) {
        return aimAlong(target, light);
    }
    return aimFromPoint(target, light, point);
}

// Picks the target in whose share of the summed sizes a choice in [0, 1) falls.
uint chooseTarget(TargetArray targets, uint count, LightRecord light, bool parallel, vec3 point, float total,
                  float choice) {
    float sum = 0.0;
    for (uint i = 0u; i + 1u < count; ++i) {
        sum += aimAt(targets.at[i], light, parallel, point).size;
        if (choice * total < sum) {
            return i;
        }
    }
    return count - 1u;
}

bool isWithin(Aim aim, bool parallel, LightRay ray) {
    if (parallel) {
        vec3 across = ray.origin - aim.axis;
        across -= dot(across, ray.direction) * ray.direction;
        return dot(across, across) <= aim.extent;
    }
    vec3 chord = ray.direction - aim.axis; // its square is 2 (1 - cosine)
    return dot(chord, chord) <= 2.0 * aim.extent;
}

// A ray towards the targets, and the share of the light's power that a photon along it carries.
struct AimedRay {
    vec3 origin;
    vec3 direction;
    vec3 power; // flux [W] of the light if all its photons were like this one
};

// `ray`: the light's own sample from the same numbers.
AimedRay aimRay(LightRecord light, TargetArray targets, uint count, LightRay ray, float choice, vec2 uOrigin,
                vec2 uDirection) {
    bool parallel = ray.pdfOrigin > 0.0;
    float total = 0.0;
    for (uint i = 0u; i < count; ++i) {
        total += aimAt(targets.at[i], light, parallel, ray.origin).size;
    }
    uint chosen = chooseTarget(targets, count, light, parallel, ray.origin, total, choice);
    Aim aim = aimAt(targets.at[chosen], light, parallel, ray.origin);
    if (!aim.anywhere && parallel) {
        vec3 q = aim.axis + fromLocal(vec3(sqrt(aim.extent) * concentricDisc(uOrigin), 0.0), ray.direction);
        ray.origin = q - dot(q - ray.origin, ray.direction) * ray.direction; // back to the plane where the light's rays start
    } else if (!aim.anywhere) {
        float below = uDirection.x * aim.extent; // 1 - z
        vec2 sc = sinCosTurns(uDirection.y);
        float sine = sqrt(below * (2.0 - below));
        ray.direction = normalize(fromLocal(vec3(sine * sc.y, sine * sc.x, 1.0 - below), aim.axis));
    }
    float own = parallel ? originDensity(light, ray.origin, ray.direction)
                         : emissionDensity(light, ray.normal, ray.direction);
    float density = 0.0; // times total
    for (uint i = 0u; i < count; ++i) {
        Aim other = aimAt(targets.at[i], light, parallel, ray.origin);
        if (other.anywhere) {
            density += other.size * own;
            continue;
        }
        density += i == chosen || isWithin(other, parallel, ray) ? 1.0 : 0.0; // the chosen one always, despite rounding
    }
    return AimedRay(startOf(ray), ray.direction, density > 0.0 ? ray.power * (own * total / density) : vec3(0.0));
}
#endif
