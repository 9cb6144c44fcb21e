#include "reference/photons/shadow_photons.h"

#include "base/parallel.h"
#include "reference/bsdf/bsdf.h"
#include "reference/photons/photons.h"
#include "reference/textures/texture.h"
#include "scene/model/render_seed.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <array>

namespace hyalite::reference {

namespace {

void castPhoton(const World& world, Ray ray, std::uint32_t photon, std::uint32_t light, std::vector<Photon>& photons) {
    PhotonKind kind = PhotonKind::Direct;
    for (std::uint32_t depth = 1; depth <= shared::kMaxDepth; ++depth) {
        const std::optional<Hit> hit = traceClosest(world, ray);
        if (!hit) {
            return;
        }
        const Surface surface = evaluateSurface(world, ray, *hit);
        if (surface.material != nullptr && diffusePart(texturedModel(world, surface))) {
            photons.push_back({.position = surface.position,
                               .direction = -ray.direction,
                               .normal = surface.geometricNormal,
                               .power = glm::dvec3(0),
                               .photon = photon,
                               .depth = depth,
                               .light = light,
                               .kind = kind});
        }
        kind = PhotonKind::Shadow;
        ray = {.origin = leave(surface, ray.direction), .direction = ray.direction};
    }
}

} // namespace

std::vector<Photon> castShadowPhotons(const World& world, std::uint32_t pass) {
    const PhotonPass photonPass{.sequence =
                                    shared::photonSequence(renderSeed(world.render), shared::kShadowPhotons, pass),
                                .count = world.render.photons};
    constexpr std::size_t kBlock = 1024;
    std::vector<std::vector<Photon>> blocks((photonPass.count + kBlock - 1) / kBlock);
    parallelFor(photonPass.count, kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto photon = static_cast<std::uint32_t>(i);
            const Emission emission = emitPhoton(world, photon, photonPass);
            castPhoton(world, emission.ray, photon, emission.light, blocks[begin / kBlock]);
        }
    });
    return joined(blocks);
}

Visibility classifyVisibility(const PhotonMap& map, const VisiblePoint& x, std::uint32_t lights, std::uint32_t agreeing,
                              double radius, double surfaceError) {
    const std::uint32_t nearest =
        std::min(agreeing * std::min(lights, shared::kMostClassifiedLights), shared::kMaxNearest);
    std::array<std::uint32_t, shared::kMostClassifiedLights> direct{};
    std::array<std::uint32_t, shared::kMostClassifiedLights> shadow{};
    const auto sameSide = [&](const Photon& photon) { return isOnSide(photon, x, surfaceError); };
    for (const PhotonMap::Neighbour& neighbour : map.nearest(x.position, nearest, radius, sameSide)) {
        const Photon& photon = map.photons()[neighbour.index];
        if (photon.light < shared::kMostClassifiedLights) {
            ++(photon.kind == PhotonKind::Direct ? direct : shadow).at(photon.light);
        }
    }
    Visibility visibility;
    for (std::uint32_t light = 0; light < std::min(lights, shared::kMostClassifiedLights); ++light) {
        if (direct.at(light) >= agreeing && shadow.at(light) == 0) {
            visibility.lit |= 1U << light;
        } else if (shadow.at(light) >= agreeing && direct.at(light) == 0) {
            visibility.shadowed |= 1U << light;
        }
    }
    return visibility;
}

} // namespace hyalite::reference
