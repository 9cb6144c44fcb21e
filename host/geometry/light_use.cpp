// See light_use.h.
#include "geometry/light_use.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hyalite {

std::uint32_t learningSide(std::size_t lights) {
    const double pixels = 131072.0 / (kLearningDepth * static_cast<double>(std::max<std::size_t>(lights, 1)));
    return static_cast<std::uint32_t>(std::clamp(std::floor(std::sqrt(pixels)), 4.0, 16.0));
}

std::vector<double> photonShares(const Scene& scene) {
    std::vector<double> shares;
    if (scene.environment) {
        shares.push_back(scene.environment->photonShare);
    }
    for (const PointLight& light : scene.lights) {
        shares.push_back(light.photonShare);
    }
    for (const SpotLight& light : scene.spots) {
        shares.push_back(light.photonShare);
    }
    for (const DirectionalLight& light : scene.directionals) {
        shares.push_back(light.photonShare);
    }
    for (const Object& object : scene.objects) {
        if (object.emission != glm::dvec3(0)) {
            shares.push_back(object.photonShare);
        }
    }
    return shares;
}

void scaleIntensities(LightTree& tree, const std::vector<LightUse>& uses) {
    struct Sums {
        double seen = 0;
        double unseen = 0;
        [[nodiscard]] double ofUnseen() const {
            return unseen > kUnseenIntensity * seen && seen > 0 ? kUnseenIntensity * seen / unseen : 1;
        }
    };
    std::array<Sums, 2> sums; // of the lights in the tree, and of far lights
    const auto sumsOf = [&](std::size_t node) -> Sums& { return sums.at(node < tree.farCount ? 1 : 0); };
    const auto isUnseen = [&](const LightTree::Node& leaf) { return uses.at(leaf.light).seen == 0; };
    for (const std::uint32_t at : tree.leafOf) {
        LightTree::Node& leaf = tree.nodes.at(at);
        const LightUse& use = uses.at(leaf.light);
        leaf.extent.intensity *= (use.seen + 1.0) / (use.tried + 2.0);
        (isUnseen(leaf) ? sumsOf(at).unseen : sumsOf(at).seen) += leaf.extent.intensity;
    }
    for (std::size_t at = tree.nodes.size(); at-- > 0;) { // children come after their parent
        LightTree::Node& node = tree.nodes[at];
        if (node.second != 0) {
            node.extent.intensity = tree.nodes[at + 1].extent.intensity + tree.nodes[node.second].extent.intensity;
        } else if (isUnseen(node)) {
            node.extent.intensity *= sumsOf(at).ofUnseen();
        }
    }
}

std::vector<double> learnedPmf(const std::vector<double>& pmf, const std::vector<double>& shares,
                               const std::vector<LightUse>& uses) {
    double total = 0;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        total += shares.at(i) * uses[i].brought;
    }
    if (!(total > 0)) {
        return pmf;
    }
    std::vector<double> learned;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        learned.push_back((1 - kLearnedPhotons) * pmf.at(i) + kLearnedPhotons * shares[i] * uses[i].brought / total);
    }
    return learned;
}

} // namespace hyalite
