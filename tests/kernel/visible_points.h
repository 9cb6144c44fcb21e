// Visible points of camera paths, from the device or constructed by tests, for the reference.
#pragma once

#include "kernel/kernel_support.h"
#include "reference/lights/receiver.h"
#include "reference/lights/rough_light.h"
#include "reference/textures/texture.h"

namespace hyalite::testing {

// The scene with two materials more, behind its own: white paint, and the same under a coat.
inline Scene withPaints(Scene scene) {
    reference::test::addMaterial(scene, Diffuse{dvec3(1)});
    reference::test::addMaterial(scene, MetallicRoughness{dvec3(1), 0, 0.5});
    return scene;
}

inline std::uint32_t paintOf(const Scene& scene, bool isCoated) {
    return static_cast<std::uint32_t>(scene.materials.size()) - (isCoated ? 1 : 2);
}

// A point seen straight on of a path with the throughput beta; `material`: of the scene, or kNone.
struct PointMade {
    vec3 position;
    std::uint32_t depth = 1;
    vec3 normal{0, 0, 1};
    std::uint32_t samplerSeed = 0;
    vec3 beta{1};
    std::uint32_t pixel = 0;
    std::uint32_t from = 0;
    std::uint32_t geometricNormal = 0x7fffU | 0x7fffU << 16U; // +z
    std::uint32_t material = shared::kNone;

    operator shared::VisiblePoint() const {
        return {position,        depth, normal, samplerSeed, position, from, normal,
                geometricNormal, beta,  pixel,  {},          material, 1.0F, shared::kNoMedia};
    }
};

inline MaterialModel materialAt(const BothSides& both, std::uint32_t material, const vec3& position,
                                const glm::vec2& uv) {
    reference::Surface surface{};
    surface.material = &both.world.materials.at(material);
    surface.position = dvec3(position);
    surface.uv = glm::dvec2(uv);
    return reference::texturedModel(both.world, surface);
}

// `geometricNormal`: what the point's stands for.
inline reference::VisiblePoint toReference(const BothSides& both, const shared::VisiblePoint& x,
                                           const dvec3& geometricNormal = glm::normalize(dvec3(-1, -1, 65533))) {
    return {.position = x.position,
            .shadowOrigin = x.position,
            .normal = x.normal,
            .geometricNormal = geometricNormal,
            .wo = glm::normalize(dvec3(x.wo)),
            .beta = dvec3(x.beta) / double{x.probability},
            .material = x.material == shared::kNone ? std::nullopt
                                                    : std::optional(materialAt(both, x.material, x.onSurface, x.uv)),
            .depth = x.depth,
            .samplerSeed = x.samplerSeed};
}

// Path throughput times the BSDF at the point, for light along its normal [1/sr].
inline dvec3 fAt(const BothSides& both, const shared::VisiblePoint& x) {
    return reference::receiverAt(toReference(both, x)).f;
}

inline reference::Lobe lobeAt(const BothSides& both, const shared::RoughPoint& x) {
    const MaterialModel model = materialAt(both, x.material, x.position, x.uv);
    return x.isCoat != 0 ? reference::coatOf(model).value()
                         : reference::lobeOf(model, (x.from & shared::kRayInside) == 0).value();
}

} // namespace hyalite::testing
