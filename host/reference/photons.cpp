// The photon pass: emission, flight, scattering.
#include "reference/photons.h"

#include "base/parallel.h"
#include "reference/lights.h"
#include "reference/materials.h"
#include "reference/medium.h"
#include "reference/sampling.h"
#include "reference/texture.h"

#include <algorithm>

namespace hyalite::reference {

namespace {

bool isWanted(PhotonKind kind, const PhotonPass& pass) {
    return (pass.kinds & kindBit(kind)) != 0;
}

// Survives with probability p = the largest channel, and then carries power * reflected / p: right on average.
bool survives(const glm::dvec3& reflected, double x, glm::dvec3& power) {
    const double p = std::max({reflected.x, reflected.y, reflected.z});
    if (x >= p) {
        return false;
    }
    power *= reflected / p;
    return true;
}

void tracePhoton(const World& world, const Ray& ray, const PhotonPath& path, std::uint32_t depth,
                 const PhotonPass& pass, std::vector<Photon>& photons) {
    const std::optional<Hit> hit = traceClosest(world, ray);
    if (!hit) {
        return;
    }
    const PhotonScatter scatter = scatterPhoton(world, ray, *hit, path, depth, pass);
    if (scatter.stored) {
        photons.push_back(*scatter.stored);
    }
    if (scatter.next) {
        tracePhoton(world, *scatter.next, scatter.path, depth + 1, pass, photons);
    }
}

} // namespace

PhotonPass progressivePass(const World& world, std::uint32_t pass) {
    return {.sequence = shared::photonSequence(world.render.seed, shared::kGlobalPhotons, pass),
            .count = world.render.photons,
            .kinds = kindBit(PhotonKind::Indirect) | kindBit(PhotonKind::Caustic)};
}

PhotonScatter scatterPhoton(const World& world, const Ray& ray, const Hit& hit, const PhotonPath& started,
                            std::uint32_t depth, const PhotonPass& pass) {
    const Surface surface = evaluateSurface(world, ray, hit);
    PhotonPath path = started;
    path.power *= transmittance(path.medium, hit.t);
    PhotonScatter scatter{.stored = {}, .next = {}, .path = path};
    if (surface.material == nullptr) {
        return scatter;
    }
    const MaterialModel model = texturedModel(world, surface);
    const auto* diffuse = std::get_if<Diffuse>(&model);
    if (diffuse != nullptr && isWanted(path.kind, pass)) {
        scatter.stored = Photon{.position = surface.position,
                                .direction = -ray.direction,
                                .normal = surface.normal,
                                .power = path.power,
                                .photon = path.photon,
                                .depth = depth,
                                .light = path.light,
                                .kind = path.kind};
    }
    // A photon at depth j serves camera paths of depth k >= 1 with j + k <= maxDepth.
    if (depth + 1 >= world.render.maxDepth) {
        return scatter;
    }
    const shared::Sampler sampler = shared::photonSampler(pass.sequence, path.photon);
    const glm::dvec2 xy = sampleUnitSquare(sampler, shared::photonScatter(depth - 1));
    std::optional<glm::dvec3> direction;
    if (path.kind == PhotonKind::Direct) { // what a mirror or glass sends on may become a caustic
        scatter.path.kind = PhotonKind::Caustic;
    }
    if (diffuse != nullptr) {
        scatter.path.kind = PhotonKind::Indirect;
        if (isWanted(PhotonKind::Indirect, pass) && survives(diffuse->albedo, xy.x, scatter.path.power)) {
            const glm::dvec2 uv = sampleUnitSquare(sampler, shared::photonBounce(depth - 1));
            direction = cosineHemisphere(uv, surface.normal);
        }
    } else if (const auto* mirror = std::get_if<Mirror>(&model)) {
        if (survives(mirror->reflectance, xy.x, scatter.path.power)) {
            direction = reflect(ray.direction, surface.normal);
        }
    } else if (const auto* glass = std::get_if<Dielectric>(&model)) {
        const double eta = surface.front ? 1 / glass->ior : glass->ior;
        const double F = fresnelDielectric(incidentCosine(ray.direction, surface.normal), eta);
        direction = xy.y < F ? reflect(ray.direction, surface.normal) : refract(ray.direction, surface.normal, eta);
        if (xy.y >= F) {
            scatter.path.medium = surface.front ? surface.material : nullptr;
        }
    }
    if (direction) {
        scatter.next = Ray{.origin = leave(surface, *direction), .direction = *direction};
    }
    return scatter;
}

std::vector<Photon> tracePhotons(const World& world, const PhotonPass& pass) {
    // Each block of photons fills its own list: joined in order, they do not depend on the threads.
    constexpr std::size_t kBlock = 1024;
    const std::size_t count = pass.count;
    std::vector<std::vector<Photon>> blocks((count + kBlock - 1) / kBlock);
    parallelFor(count, kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto photon = static_cast<std::uint32_t>(i);
            const Emission emission = emitPhoton(world, photon, pass);
            tracePhoton(world, emission.ray, {.power = emission.power, .photon = photon, .light = emission.light}, 1,
                        pass, blocks[begin / kBlock]);
        }
    });
    return joined(blocks);
}

std::vector<Photon> joined(const std::vector<std::vector<Photon>>& blocks) {
    std::vector<Photon> photons;
    for (const std::vector<Photon>& block : blocks) {
        photons.insert(photons.end(), block.begin(), block.end());
    }
    return photons;
}

bool hasDiffusePart(const Material& material) {
    return std::holds_alternative<Diffuse>(material.model);
}

} // namespace hyalite::reference
