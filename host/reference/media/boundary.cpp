#include "reference/media/boundary.h"

#include <algorithm>
#include <cmath>

namespace hyalite::reference {

namespace {

using glm::dvec3;

double scaleOf(const dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

bool isTransparent(const Surface& surface) {
    return surface.material != nullptr && surface.material->model.type == shared::kMaterialDielectric;
}

} // namespace

std::optional<Surface> touchingSurface(const World& world, const Neighbor& neighbor, const Surface& place) {
    const double near = kTouching * std::max(scaleOf(place.position), neighbor.extent);
    const double reach = 4 * near + 4 * place.offset;
    const Ray window{.origin = place.position + reach * place.geometricNormal,
                     .direction = -place.geometricNormal,
                     .tMax = 2 * reach};
    const std::optional<Hit> hit = traceObject(world, neighbor.object, window);
    if (!hit) {
        return std::nullopt;
    }
    const Surface surface = evaluateSurface(world, window, *hit);
    const double apart = std::abs(glm::dot(surface.position - place.position, place.geometricNormal));
    return apart <= near ? std::optional(surface) : std::nullopt;
}

Boundary boundaryAt(const World& world, const Ray& ray, const Hit& hit, const Media& media) {
    const Surface own = evaluateSurface(world, ray, hit);
    Boundary met{own, media, hit.object};
    if (world.neighbors.empty() || world.neighbors[hit.object].empty()) {
        if (own.material != nullptr) {
            met.beyond = behind(world.materials, materialNumber(world, own), own.front, media);
        }
        return met;
    }
    bool isOpaque = !isTransparent(own);
    double clear = own.offset;
    std::vector<std::uint32_t> entered;
    for (const Neighbor& neighbor : world.neighbors[hit.object]) {
        const std::optional<Surface> other =
            neighbor.object == hit.object ? std::optional(own) : touchingSurface(world, neighbor, own);
        if (!other) {
            continue;
        }
        clear = std::max(clear,
                         std::abs(glm::dot(other->position - own.position, own.geometricNormal)) + 2 * other->offset);
        if (!isTransparent(*other)) {
            if (!isOpaque) {
                met = {*other, media, neighbor.object};
            }
            isOpaque = true;
        } else if (other->material->model.thin == 0) {
            const auto material = static_cast<std::uint32_t>(materialNumber(world, *other));
            if (other->front) {
                entered.push_back(material);
            } else {
                met.beyond.leave(material);
            }
            if (!isOpaque && other->material->model.roughness > met.material->model.roughness) {
                met.material = other->material;
            }
        }
    }
    met.offset = clear + kTouching / 8 * scaleOf(own.position);
    if (isOpaque) {
        met.beyond = media;
        return met;
    }
    for (const std::uint32_t material : entered) {
        met.beyond.enter(material);
    }
    return met;
}

} // namespace hyalite::reference
