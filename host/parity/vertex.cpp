#include "parity/vertex.h"

namespace hyalite::parity {

std::string describeChoice(const Vertex& vertex) {
    if (vertex.object == shared::kNone) {
        return "leaves the scene";
    }
    std::string text;
    const auto add = [&](std::uint32_t bit, const char* word) {
        if ((vertex.choice & bit) != 0) {
            text += (text.empty() ? "" : ", ") + std::string(word);
        }
    };
    add(kDiffuse, (vertex.choice & kBounced) == 0 ? "ends on a diffuse surface" : "on a diffuse surface");
    add(kBounced, "cosine-weighted bounce");
    add(kStored, "stored");
    add(kReflected, "reflected");
    add(kTransmitted, "transmitted");
    return text.empty() ? "ends" : text;
}

void setSurface(Vertex& vertex, const Sides& sides, const reference::Hit& hit, const reference::Surface& surface) {
    vertex.position = surface.position;
    vertex.normal = surface.normal;
    vertex.front = surface.front;
    vertex.object = hit.object;
    vertex.primitive = hit.primitive;
    vertex.material = surface.material == nullptr
                          ? shared::kNone
                          : static_cast<std::uint32_t>(reference::materialNumber(sides.world(), surface));
}

std::uint32_t continuation(const reference::Surface& surface, const glm::dvec3& direction) {
    return glm::dot(direction, surface.geometricNormal) < 0 ? kTransmitted : kReflected;
}

} // namespace hyalite::parity
