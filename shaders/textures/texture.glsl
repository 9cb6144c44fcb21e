// Textures: their values at surface points, and the materials that they colour.
#ifndef HYALITE_TEXTURE_GLSL
#define HYALITE_TEXTURE_GLSL
#include "textures/custom_texture.glsl"
#include "lib/math.glsl"
#include "lib/specialization.glsl"
#include "lib/tables.glsl"

// Cells of a world-space checker are shifted by this share of a cell from the multiples of their edge: a surface in
// such a plane has one colour, whatever the rounding.
const float kCheckerShift = 0.0009765625; // 2^-10

bool isOdd(float whole) {
    return whole != 2.0 * floor(0.5 * whole);
}

// A texel of a repeating image; `at` is at most one image away.
vec3 imageTexel(uint first, ivec2 size, ivec2 at) {
    at += mix(ivec2(0), size, lessThan(at, ivec2(0))) - mix(ivec2(0), size, greaterThanEqual(at, size));
    return texelFetch(textureTable, int(first) + at.y * size.x + at.x).xyz;
}

// Bilinear interpolation between texel centres; row 0 is on top, v points up.
vec3 imageAt(uint first, ivec2 size, vec2 uv) {
    vec2 inImage = uv - floor(uv);
    vec2 place = vec2(inImage.x, 1.0 - inImage.y) * vec2(size) - 0.5;
    vec2 corner = floor(place);
    vec2 part = place - corner;
    ivec2 at = ivec2(corner);
    vec3 above = mix(imageTexel(first, size, at), imageTexel(first, size, at + ivec2(1, 0)), part.x);
    vec3 below = mix(imageTexel(first, size, at + ivec2(0, 1)), imageTexel(first, size, at + ivec2(1, 1)), part.x);
    return mix(above, below, part.y);
}

// `position`: on the surface, relative to the scene's origin [m].
vec3 textureAt(uint texture_, vec3 position, vec2 uv) {
    vec4 head = texelFetch(textureTable, int(kTexelsPerTexture * texture_));
    uvec4 bits = floatBitsToUint(head);
    if (bits.x == kTextureImage) {
        return imageAt(bits.y, ivec2(bits.zw), uv);
    }
    vec4 rest = texelFetch(textureTable, int(kTexelsPerTexture * texture_ + 1u));
    vec3 origin = texelFetch(textureTable, int(kTexelsPerTexture * texture_ + 2u)).xyz;
    if (bits.x == kTextureCustom) {
        return clamp(customTexture(bits.y, origin + position, uv, rest), 0.0, 1.0);
    }
    vec3 place =
        bits.x == kTextureCheckerWorld ? position * rest.x + (origin + kCheckerShift) : vec3(uv * rest.x, 0.0);
    vec3 cell = floor(place);
    return isOdd(cell.x + cell.y + cell.z) ? rest.yzw : head.yzw;
}

MaterialRecord texturedMaterial(MaterialRecord material, vec3 position, vec2 uv) {
    if (kTextures == 0u) {
        return material;
    }
    if (material.colorTexture != kNone) {
        material.color *= textureAt(material.colorTexture, position, uv);
    }
    if (material.roughnessTexture != kNone) {
        vec3 factors = textureAt(material.roughnessTexture, position, uv);
        material.roughness *= factors.g;
        material.metallic *= factors.b;
    }
    return material;
}
#endif
