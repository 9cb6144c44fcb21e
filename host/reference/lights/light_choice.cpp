// Three ways to pick, mixed: by the lights' pmf; by importance among the far lights; and down the tree, at each node to
// one of two children by importance. A node's importance is the irradiance that its lights would bring at most, had
// they all the direction and place that suits the receiver best: intensity over squared distance, faded by the angle.
// Of few lights the importance of each is summed instead, and one number decides.
#include "reference/lights/light_choice.h"

#include "reference/world.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

namespace {

// Keeps quotients of importances defined where both underflow in single precision.
constexpr double kTiny = 1e-30;

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double importance(const LightExtent& lights, const glm::dvec3& receiver) {
    const glm::dvec3 way = receiver - lights.center;
    const double distance = glm::length(way);
    if (lights.isFar) {
        const double across = glm::length(way - glm::dot(way, lights.axis) * lights.axis);
        const double ratio = lights.radius > 0 && across > lights.radius ? lights.radius / across : 1;
        return lights.intensity * ratio * ratio;
    }
    double fade = 1;
    if (distance > lights.radius) {
        const double seen = std::asin(lights.radius / distance); // half-angle under which the sphere is seen
        const double off = std::max(0.0, angleBetween(lights.axis, way) - lights.spread - seen);
        fade = (std::cos(off) - std::cos(lights.fade)) / (1 - std::cos(lights.fade));
    }
    const double nearest = std::max(distance * distance, lights.radius * lights.radius);
    return lights.intensity * std::max(double{shared::kLeastFade}, fade) /
           std::max(nearest, double{shared::kNearestLight2});
}

// The pick's alternatives at one receiver.
class Choice {
public:
    Choice(const World& world, const glm::dvec3& receiver)
        : world_(world), nodes_(world.lightTree.nodes), farCount_(world.lightTree.farCount), receiver_(receiver) {
        for (std::uint32_t node = 0; node < farCount_; ++node) {
            far_ += at(node);
        }
        far_ = std::max(far_, kTiny);
        near_ = importanceOfNear();
        if (farCount_ == world.lights.size()) {
            farShare_ = 1;
        } else if (farCount_ > 0) {
            constexpr double kEven = shared::kEvenPicks;
            farShare_ = kEven / 2 + (1 - kEven) * far_ / (far_ + near_);
        }
    }

    // Probability that the light is picked.
    [[nodiscard]] double probability(std::uint32_t light) const {
        constexpr double kByPmf = shared::kPicksByPmf;
        const std::uint32_t leaf = world_.lightTree.leafOf[light];
        const double inGroup = leaf < farCount_ ? at(leaf) / far_
                               : areFew()       ? at(leaf) / near_
                                                : probabilityOfDescent(leaf);
        const double byPlace = inGroup * (leaf < farCount_ ? farShare_ : 1 - farShare_);
        return kByPmf * world_.lights[light].pmf + (1 - kByPmf) * byPlace;
    }

    [[nodiscard]] std::uint32_t pick(glm::dvec2 uv) const {
        if (areFew()) {
            return pickAmongFew(uv.x);
        }
        const double group = (uv.y - double{shared::kPicksByPmf}) / (1 - double{shared::kPicksByPmf});
        if (group < 0) {
            return chooseLight(world_.lights, uv.x);
        }
        return group < farShare_ ? pickFar(uv.x) : descend(uv.x);
    }

private:
    [[nodiscard]] bool areFew() const { return world_.lights.size() <= shared::kFewLights; }

    [[nodiscard]] double importanceOfNear() const {
        if (!areFew()) {
            return farCount_ < world_.lights.size() ? at(farCount_) : 0;
        }
        double sum = 0;
        for (const std::uint32_t leaf : world_.lightTree.leafOf) {
            sum += leaf < farCount_ ? 0 : at(leaf);
        }
        return std::max(sum, kTiny);
    }

    [[nodiscard]] std::uint32_t pickAmongFew(double u) const {
        const auto last = static_cast<std::uint32_t>(world_.lights.size() - 1);
        std::uint32_t light = 0;
        for (double sum = probability(0); light < last && u >= sum; sum += probability(light)) {
            ++light;
        }
        return light;
    }

    [[nodiscard]] double at(std::uint32_t node) const { return importance(nodes_[node].extent, receiver_); }

    [[nodiscard]] double firstShare(std::uint32_t parent) const {
        const double first = at(parent + 1) + kTiny;
        return first / (first + at(nodes_[parent].second) + kTiny);
    }

    [[nodiscard]] std::uint32_t pickFar(double u) const {
        double sum = 0;
        std::uint32_t node = 0;
        while (node + 1 < farCount_ && u * far_ >= (sum += at(node))) {
            ++node;
        }
        return nodes_[node].light;
    }

    // The part of [0, 1) that leads to the present node is [low, low + width).
    [[nodiscard]] std::uint32_t descend(double u) const {
        double low = 0;
        double width = 1;
        std::uint32_t node = farCount_;
        while (nodes_[node].second != 0) {
            const double first = width * firstShare(node);
            if (u < low + first) {
                width = first;
                node = node + 1;
            } else {
                low += first;
                width -= first;
                node = nodes_[node].second;
            }
        }
        return nodes_[node].light;
    }

    [[nodiscard]] double probabilityOfDescent(std::uint32_t node) const {
        const std::uint32_t parent = nodes_[node].parent;
        if (parent == shared::kNone) {
            return 1;
        }
        const double share = firstShare(parent);
        return probabilityOfDescent(parent) * (node == parent + 1 ? share : 1 - share);
    }

    const World& world_;
    const std::vector<LightTree::Node>& nodes_;
    std::uint32_t farCount_;
    glm::dvec3 receiver_;
    double far_ = 0;      // importance of the far lights
    double near_ = 0;     // and of the others
    double farShare_ = 0; // of the picks that are not by pmf
};

} // namespace

LightPick pickLightAt(const World& world, const glm::dvec3& receiver, glm::dvec2 uv) {
    if (world.lights.size() == 1) {
        return {};
    }
    const Choice choice(world, receiver);
    const std::uint32_t light = choice.pick(uv);
    return {.light = light, .pmf = choice.probability(light)};
}

double pickProbability(const World& world, std::uint32_t light, const glm::dvec3& receiver) {
    return world.lights.size() == 1 ? 1 : Choice(world, receiver).probability(light);
}

} // namespace hyalite::reference
