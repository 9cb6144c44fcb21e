#include "reference/media/touching_objects.h"

#include "geometry/media_needs.h"
#include "reference/lib/sampling.h"
#include "reference/media/boundary.h"
#include "reference/world.h"
#include "scene/model/bounds.h"

#include "shaders/shared/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hyalite::reference {

namespace {

using glm::dvec3;

struct Pair {
    std::uint32_t a, b;
    Bounds region; // where their boxes meet, with a margin
    double extent; // see Neighbor
};

double largest(const Bounds& box) {
    const dvec3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
    return std::max({far.x, far.y, far.z});
}

// Where two boxes meet, enlarged by the distance at which surfaces still touch; not finite or empty: nowhere.
std::optional<Bounds> meeting(const Bounds& a, const Bounds& b) {
    Bounds region{glm::max(a.low, b.low), glm::min(a.high, b.high)};
    if (!isFinite(region)) {
        return std::nullopt;
    }
    const double margin = 2 * kTouching * largest(region); // at least what touchingSurface() allows
    region.low -= margin;
    region.high += margin;
    return glm::all(glm::lessThanEqual(region.low, region.high)) ? std::optional(region) : std::nullopt;
}

// The pairs of objects whose boxes meet, a dielectric in each.
std::vector<Pair> candidates(const Scene& scene) {
    std::vector<Bounds> boxes;
    std::vector<bool> isGlass;
    for (const Object& object : scene.objects) {
        boxes.push_back(worldBounds(scene, object));
        isGlass.push_back(isDielectric(scene, object));
    }
    std::vector<Pair> pairs;
    if (std::ranges::find(isGlass, true) == isGlass.end()) {
        return pairs;
    }
    std::vector<std::uint32_t> byLow(boxes.size());
    std::iota(byLow.begin(), byLow.end(), 0U);
    std::ranges::sort(byLow, {}, [&](std::uint32_t i) { return std::pair(boxes[i].low.x, i); });
    for (std::size_t i = 0; i < byLow.size(); ++i) {
        const std::uint32_t a = byLow[i];
        const double end = boxes[a].high.x + 4 * kTouching * std::max(std::abs(boxes[a].high.x), 0.0);
        for (std::size_t k = i + 1; k < byLow.size() && boxes[byLow[k]].low.x <= end; ++k) {
            const std::uint32_t b = byLow[k];
            if (!isGlass[a] && !isGlass[b]) {
                continue;
            }
            if (const auto region = meeting(boxes[a], boxes[b])) {
                pairs.push_back(
                    {std::min(a, b), std::max(a, b), *region, std::min(largest(boxes[a]), largest(boxes[b]))});
            }
        }
    }
    return pairs;
}

bool contains(const Bounds& box, const dvec3& p) {
    return glm::all(glm::lessThanEqual(box.low, p)) && glm::all(glm::lessThanEqual(p, box.high));
}

double unit(std::uint32_t number) {
    return shared::hash(number) / 4294967296.0;
}

// Do the surfaces of the two coincide in some part of the region?
bool touch(const World& world, const Pair& pair) {
    constexpr std::uint32_t kFirst = 64; // rays; if none hits a surface in the region, no more are tried
    constexpr std::uint32_t kMost = 512;
    const dvec3 size = pair.region.high - pair.region.low;
    bool hitAny = false;
    for (std::uint32_t i = 0; i < kMost && (i < kFirst || hitAny); ++i) {
        const dvec3 from = pair.region.low + size * dvec3(unit(5 * i), unit(5 * i + 1), unit(5 * i + 2));
        const double z = 2 * unit(5 * i + 3) - 1;
        const double angle = 2 * std::numbers::pi * unit(5 * i + 4);
        const double r = std::sqrt(1 - z * z);
        const Ray ray{
            .origin = from, .direction = {r * std::cos(angle), r * std::sin(angle), z}, .tMax = glm::length(size)};
        const std::optional<Hit> hit = traceObject(world, pair.a, ray);
        if (!hit || !contains(pair.region, ray.origin + hit->t * ray.direction)) {
            continue;
        }
        hitAny = true;
        if (touchingSurface(world, {pair.b, pair.extent}, evaluateSurface(world, ray, *hit))) {
            return true;
        }
    }
    return false;
}

Neighbors listsOf(const Scene& scene, const World& world, const std::vector<Pair>& pairs) {
    Neighbors neighbors;
    for (const Pair& pair : pairs) {
        if (touch(world, pair)) {
            neighbors.resize(scene.objects.size());
            neighbors[pair.a].push_back({pair.b, pair.extent});
            neighbors[pair.b].push_back({pair.a, pair.extent});
        }
    }
    const auto volume = [&](std::uint32_t object) {
        const dvec3 size = [&] {
            const Bounds box = worldBounds(scene, scene.objects[object]);
            return box.high - box.low;
        }();
        return size.x * size.y * size.z;
    };
    for (std::uint32_t object = 0; object < neighbors.size(); ++object) {
        std::vector<Neighbor>& list = neighbors[object];
        if (!list.empty()) {
            list.push_back({object, 0});
            std::ranges::sort(list, {}, [&](const Neighbor& n) { return std::pair(-volume(n.object), n.object); });
        }
    }
    return neighbors;
}

} // namespace

Neighbors touchingObjects(const Scene& scene, const World& world) {
    return listsOf(scene, world, candidates(scene));
}

Neighbors touchingObjects(const Scene& scene) {
    const std::vector<Pair> pairs = candidates(scene);
    return pairs.empty() ? Neighbors() : listsOf(scene, prepareWorld(scene), pairs);
}

} // namespace hyalite::reference
