// The scene's lights as the kernels read them.
#pragma once

#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::render {

// The environment, point lights, spots, directional lights, then emitting objects, each in the scene's order; pmf in
// proportion to the mean of the flux's channels times the photon share. Until setAddresses, the arrays that a light
// names are byte offsets.
struct LightTable {
    std::vector<shared::LightRecord> lights;
    std::vector<shared::LightTriangle> triangles;
    std::vector<glm::vec3> texels;  // environment, scaled [W/(m^2 sr)]
    std::vector<float> cdfs;        // see LightRecord
    std::uint32_t firstEmitter = 0; // the light that is the first emitting object
};

// Throws Error(BadInput) where an object emits that cannot.
[[nodiscard]] LightTable buildLightTable(const Scene& scene);

// Moves the arrays that the lights name to where these stand on the device.
void setAddresses(std::vector<shared::LightRecord>& lights, shared::LightTriangleArray triangles,
                  shared::RadianceArray texels, shared::CdfArray cdfs);

} // namespace hyalite::render
