// The scene's lights as the kernels read them.
#pragma once

#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::kinds {

// Lights in the order of their kinds (light_kinds.h), each in the scene's order; pmf in
// proportion to the mean of the flux's channels times the photon share. Until setAddresses, the arrays that a light
// names are byte offsets.
struct LightTable {
    std::vector<shared::LightRecord> lights;
    std::vector<double> weights; // of each light in the choice of lights: mean flux [W] times photon share
    std::vector<shared::LightTriangle> triangles;
    std::vector<glm::vec3> texels;  // environment, scaled [W/(m^2 sr)]
    std::vector<float> cdfs;        // see LightRecord
    std::uint32_t firstEmitter = 0; // the light that is the first emitting object

    void add(const shared::LightRecord& light, double photonShare);
};

[[nodiscard]] double channelMean(const glm::dvec3& color);

// Appends the sums of the weights up to and including each, over the sum of all; evenly where all are 0. Returns that
// sum.
double appendCdf(std::vector<float>& cdfs, const std::vector<double>& weights);

// The disc where photons of light from a disc start; `distance` of it from the light's position, against the light [m].
void setStartDisc(shared::LightRecord& light, double radius, double distance);

// A light of this type from beyond the scene: its photons start on discs that cover the scene.
[[nodiscard]] shared::LightRecord endlessLight(const Scene& scene, std::uint32_t type);

// Throws Error(BadInput) where an object emits that cannot.
[[nodiscard]] LightTable buildLightTable(const Scene& scene);

// Moves the arrays that the lights name to where these stand on the device.
void setAddresses(std::vector<shared::LightRecord>& lights, shared::LightTriangleArray triangles,
                  shared::RadianceArray texels, shared::CdfArray cdfs);

} // namespace hyalite::kinds
