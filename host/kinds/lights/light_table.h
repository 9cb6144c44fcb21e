// The scene's lights as the kernels read them.
#pragma once

#include "geometry/light_tree.h"
#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite::kinds {

// Lights in the order of their kinds (light_kinds.h), within a kind in the scene's order. A part kEvenPhotons of the
// pmf is proportional to the photon share, the rest to the mean of the flux's channels times the photon share. Until
// setAddresses, the array addresses of a light are byte offsets.
struct LightTable {
    std::vector<shared::LightRecord> lights;
    std::vector<double> shares;  // photon share of each light
    std::vector<double> weights; // the same times its mean flux [W]
    std::vector<shared::LightNode> nodes;
    std::uint32_t farCount = 0; // see shared::LightHierarchy
    std::vector<shared::LightTriangle> triangles;
    std::vector<glm::vec3> texels;  // environment, scaled [W/(m^2 sr)]
    std::vector<float> cdfs;        // see LightRecord
    std::uint32_t firstEmitter = 0; // index of the first light that is an emitting object

    void add(const shared::LightRecord& light, double photonShare);
};

[[nodiscard]] double channelMean(const glm::dvec3& color);

// Appends the inclusive prefix sums of the weights, divided by their total; a uniform CDF if all are 0. Returns the
// total.
double appendCdf(std::vector<float>& cdfs, const std::vector<double>& weights);

// Sets the disc where the light's photons start: its radius, and its `distance` from the light's position, against the
// direction of the light [m].
void setStartDisc(shared::LightRecord& light, double radius, double distance);

// A light of this type from beyond the scene; its photons start on discs that cover the scene.
[[nodiscard]] shared::LightRecord endlessLight(const Scene& scene, std::uint32_t type);

// Throws Error(BadInput) if an emitting object has a shape that cannot emit.
[[nodiscard]] LightTable buildLightTable(const Scene& scene);

// The probabilities of the lights for photons: see LightTable. `weights`, `shares`: as in LightTable.
[[nodiscard]] std::vector<double> photonPmf(const std::vector<double>& weights, const std::vector<double>& shares);

// The tree's nodes as the kernels read them.
[[nodiscard]] std::vector<shared::LightNode> nodeRecords(const LightTree& tree);

// Gives every light its place in the tree and a copy of its node.
void placeInTree(std::vector<shared::LightRecord>& lights, const LightTree& tree);

// Turns the byte offsets in the lights into device addresses.
void setAddresses(std::vector<shared::LightRecord>& lights, shared::LightTriangleArray triangles,
                  shared::RadianceArray texels, shared::CdfArray cdfs, shared::LightHierarchyArray hierarchy);

} // namespace hyalite::kinds
