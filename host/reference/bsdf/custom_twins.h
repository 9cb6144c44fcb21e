// Twins in C++ of textures and materials that scenes bring along as GLSL: those that the reference can render, and
// parity compare.
#pragma once

#include "scene/model/scene.h"

#include <glm/glm.hpp>
#include <string_view>

namespace hyalite::reference {

// Of a point of the world [m], its surface coordinates and the scene's parameters: share of the light reflected.
using CustomTextureTwin = glm::dvec3 (*)(const glm::dvec3& position, const glm::dvec2& uv,
                                         const glm::dvec4& parameters);

// Of the cosine between the light and a facet's normal, and the scene's parameters: share of the light reflected.
using CustomReflectanceTwin = glm::dvec3 (*)(double cosine, const glm::dvec4& parameters);

// The twin of the GLSL function of that name; nullptr: there is none.
[[nodiscard]] CustomTextureTwin customTextureTwin(std::string_view function);
[[nodiscard]] CustomReflectanceTwin customReflectanceTwin(std::string_view function);

// The first of the scene's textures, or materials, that has none; nullptr: all have.
[[nodiscard]] const CustomCode* textureWithoutTwin(const Scene& scene);
[[nodiscard]] const CustomCode* reflectanceWithoutTwin(const Scene& scene);

// The first code of the scene that has no twin; nullptr: all have. A filter never has one.
[[nodiscard]] const CustomCode* codeWithoutTwin(const Scene& scene);

} // namespace hyalite::reference
