// See light_use.h.
#include "geometry/light_use.h"

#include <algorithm>
#include <cmath>

namespace hyalite {

std::uint32_t learningSide(std::size_t lights) {
    const double pixels = 131072.0 / (kLearningDepth * static_cast<double>(std::max<std::size_t>(lights, 1)));
    return static_cast<std::uint32_t>(std::clamp(std::floor(std::sqrt(pixels)), 4.0, 16.0));
}

std::vector<double> unoccludedParts(const std::vector<LightUse>& uses) {
    std::vector<double> parts;
    for (const LightUse& use : uses) {
        parts.push_back((use.seen + 1.0) / (use.tried + 2.0));
    }
    return parts;
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

void scaleIntensities(LightTree& tree, const std::vector<double>& factors) {
    for (auto node = tree.nodes.rbegin(); node != tree.nodes.rend(); ++node) { // children come after their parent
        if (node->second == 0) {
            node->extent.intensity *= factors.at(node->light);
        } else {
            const auto index = static_cast<std::size_t>(tree.nodes.rend() - node) - 1;
            node->extent.intensity = tree.nodes[index + 1].extent.intensity + tree.nodes[node->second].extent.intensity;
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
