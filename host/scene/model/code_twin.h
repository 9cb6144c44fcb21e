// What a twin is: a function of a scene's own GLSL written again in C++, in double precision. A shared object that
// defines hyaliteTwin holds one; docs/experiments.md says how to write it. This header is all that it needs of hyalite.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace hyalite {

// Of a point of the world [m], its surface coordinates and the scene's parameters: share of the light reflected.
using TextureTwin = glm::dvec3 (*)(const glm::dvec3& position, const glm::dvec2& uv, const glm::dvec4& parameters);

// Of the cosine between the light and a facet's normal, and the scene's parameters: share of the light reflected.
using ReflectanceTwin = glm::dvec3 (*)(double cosine, const glm::dvec4& parameters);

struct CodeTwin {
    static constexpr std::uint32_t kLayout = 1; // another number whenever this struct changes

    std::uint32_t layout = kLayout;
    const char* function = nullptr; // its name in GLSL
    std::uint64_t codeHash = 0;     // fnv() of the bytes of the GLSL file that it was written after
    // One of the two.
    TextureTwin texture = nullptr;
    ReflectanceTwin reflectance = nullptr;
};

} // namespace hyalite

// Defined by each twin.
extern "C" const hyalite::CodeTwin hyaliteTwin;
