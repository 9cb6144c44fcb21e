#include "reference/media/media_depth.h"

#include "geometry/media_needs.h"
#include "reference/media/start_media.h"
#include "reference/world.h"
#include "scene/model/bounds.h"

#include "shaders/shared/random.h"

#include <algorithm>
#include <optional>
#include <string>

namespace hyalite::reference {

namespace {

constexpr std::uint32_t kPlaces = 64; // looked at in each box

bool meet(const Bounds& a, const Bounds& b) {
    return glm::all(glm::lessThanEqual(a.low, b.high)) && glm::all(glm::lessThanEqual(b.low, a.high));
}

glm::dvec3 placeIn(const Bounds& box, std::uint32_t number) {
    const auto unit = [&](std::uint32_t i) { return shared::hash(3 * number + i) / 4294967296.0; };
    return box.low + (box.high - box.low) * glm::dvec3(unit(0), unit(1), unit(2));
}

} // namespace

void checkMediaDepth(const Scene& scene) {
    const std::size_t capacity = mediaCapacity(scene);
    std::vector<const Object*> objects;
    std::vector<Bounds> boxes;
    for (const Object& object : scene.objects) {
        if (isDielectric(scene, object)) {
            objects.push_back(&object);
            boxes.push_back(worldBounds(scene, object));
        }
    }
    std::optional<World> world;
    for (std::size_t i = 0; objects.size() > capacity && i < objects.size(); ++i) {
        const auto around = static_cast<std::size_t>(
            std::ranges::count_if(boxes, [&](const Bounds& box) { return meet(boxes[i], box); }));
        if (around <= capacity || !isFinite(boxes[i])) {
            continue;
        }
        if (!world) {
            world = prepareWorld(scene);
        }
        for (std::uint32_t place = 0; place < kPlaces; ++place) {
            const std::size_t depth = mediaAt(*world, placeIn(boxes[i], place)).list().size();
            if (depth > capacity) {
                throw Error(ExitCode::BadInput, objects[i]->where,
                            std::to_string(depth) + " dielectrics are nested here, and a path keeps " +
                                std::to_string(capacity),
                            "with fewer materials in the scene it keeps more");
            }
        }
    }
}

} // namespace hyalite::reference
