// A twin is the double-precision C++ version of a function in a scene's GLSL. A shared object that defines hyaliteTwin
// holds one; docs/experiments.md tells how to write it. It needs no other header of hyalite.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite {

// Fraction of light reflected at a world position [m] with surface coordinates (u, v), given the scene's parameters.
using TextureTwin = glm::dvec3 (*)(const glm::dvec3& position, const glm::dvec2& uv, const glm::dvec4& parameters);

// Fraction of light reflected, by the cosine between light and facet normal, given the scene's parameters.
using ReflectanceTwin = glm::dvec3 (*)(double cosine, const glm::dvec4& parameters);

struct CodeTwin {
    static constexpr std::uint32_t kLayout = 1; // increment whenever this struct changes

    std::uint32_t layout = kLayout;
    const char* function = nullptr; // its name in GLSL
    std::uint64_t codeHash = 0;     // fnv() of the bytes of the GLSL file that it reproduces
    // Exactly one is set.
    TextureTwin texture = nullptr;
    ReflectanceTwin reflectance = nullptr;
};

} // namespace hyalite

// Defined by each twin.
extern "C" const hyalite::CodeTwin hyaliteTwin;
