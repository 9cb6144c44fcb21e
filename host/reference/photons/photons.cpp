// The photon pass: emission, flight, scattering.
#include "reference/photons/photons.h"

#include "base/parallel.h"
#include "reference/bsdf/bsdf.h"
#include "reference/bsdf/interface.h"
#include "reference/lib/sampling.h"
#include "reference/lights/lights.h"
#include "reference/media/boundary.h"
#include "reference/textures/texture.h"
#include "scene/model/render_seed.h"

#include <algorithm>

namespace hyalite::reference {

namespace {

bool isWanted(PhotonKind kind, const PhotonPass& pass) {
    return (pass.kinds & kindBit(kind)) != 0;
}

// Survives with probability p = the largest channel, at most 1, and then carries power * reflected / p, which keeps the
// mean.
bool survives(const glm::dvec3& reflected, double x, glm::dvec3& power) {
    const double p = std::min(1.0, std::max({reflected.x, reflected.y, reflected.z}));
    if (x >= p) {
        return false;
    }
    power *= reflected / p;
    return true;
}

constexpr double kMostSmoothing = 32; // bound on either factor below

// [Veach97, sec. 5.3] A receiver weights light by |wo . n|, n its shading normal; the photons that arrive are as many
// as |wo . ng| asks for, ng the geometric normal.
double arrivalFactor(const Surface& surface, const glm::dvec3& wo) {
    if (surface.normal == surface.geometricNormal) {
        return 1;
    }
    const double geometric = glm::dot(wo, surface.geometricNormal);
    const double shading = std::max(0.0, glm::dot(wo, surface.normal));
    return shading < kMostSmoothing * geometric ? shading / geometric : kMostSmoothing;
}

// The same where a photon leaves by a lobe: it spreads over |wi . ng|, and the lobe's weight has |wi . n|.
double lobeFactor(const Surface& surface, const glm::dvec3& wo, const glm::dvec3& wi) {
    if (surface.normal == surface.geometricNormal) {
        return 1;
    }
    const double above = std::abs(glm::dot(wo, surface.normal) * glm::dot(wi, surface.geometricNormal));
    const double below = std::abs(glm::dot(wo, surface.geometricNormal) * glm::dot(wi, surface.normal));
    return above < kMostSmoothing * below ? above / below : kMostSmoothing;
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
    return {.sequence = shared::photonSequence(renderSeed(world.render), shared::kGlobalPhotons, pass),
            .count = world.render.photons,
            .kinds = kindBit(PhotonKind::Indirect) | kindBit(PhotonKind::Caustic)};
}

PhotonScatter scatterPhoton(const World& world, const Ray& ray, const Hit& hit, const PhotonPath& started,
                            std::uint32_t depth, const PhotonPass& pass) {
    const Boundary surface = boundaryAt(world, ray, hit, started.media);
    PhotonPath path = started;
    path.power *= transmittance(world.materials, path.media, hit.t);
    PhotonScatter scatter{.stored = {}, .next = {}, .path = path};
    if (surface.material == nullptr) {
        return scatter;
    }
    const MaterialModel model = relativeTo(world.materials, world.indicesFromMedia, texturedModel(world, surface),
                                           {.before = path.media, .beyond = surface.beyond, .front = surface.front});
    const std::optional<DiffusePart> diffuse = diffusePart(model);
    const std::optional<Lobe> lobe = lobeOf(model, surface.front);
    if (diffuse && isWanted(path.kind, pass)) {
        scatter.stored = Photon{.position = surface.position,
                                .direction = -ray.direction,
                                .normal = surface.geometricNormal,
                                .power = path.power * arrivalFactor(surface, -ray.direction),
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
    const glm::dvec2 uv = sampleUnitSquare(sampler, shared::photonBounce(depth - 1));
    const double cosIn = incidentCosine(ray.direction, surface.normal);
    const double probability = lobeProbability(lobe, diffuse, cosIn);
    std::optional<BsdfSample> sample;
    double taken = 1 - probability; // of the chosen part
    if (xy.y < probability) {
        const ShadingNormals normals{surface.normal, surface.geometricNormal};
        const PickedLobe picked = pickLobe(*lobe, cosIn, xy.y / probability);
        sample = sampleLobe(picked.lobe, normals, -ray.direction, uv, xy.y, Transport::Flux);
        taken = probability * picked.probability;
        if (sample) {
            sample->weight *= lobeFactor(surface, -ray.direction, sample->direction);
        }
        if (path.kind == PhotonKind::Direct) { // it may become a caustic photon
            scatter.path.kind = PhotonKind::Caustic;
        }
    } else if (isWanted(PhotonKind::Indirect, pass)) {
        // f times the cosine at the geometric normal over the density, which is that cosine over pi; the flux that
        // arrived counts by the cosine at the smoothed normal
        const glm::dvec3 direction = cosineHemisphere(uv, surface.geometricNormal);
        const double cosOut = std::clamp(glm::dot(direction, surface.normal), 0.0, 1.0);
        const glm::dvec3 weight = arrivalFactor(surface, -ray.direction) * diffuseReflectance(*diffuse, cosIn, cosOut);
        sample = BsdfSample{.direction = direction, .weight = weight};
        scatter.path.kind = PhotonKind::Indirect;
    }
    if (sample && survives(sample->weight / taken, xy.x, scatter.path.power)) {
        scatter.next = Ray{.origin = leave(surface, sample->direction), .direction = sample->direction};
        if (sample->through) {
            scatter.path.media = surface.beyond;
        }
    }
    return scatter;
}

std::vector<Photon> tracePhotons(const World& world, const PhotonPass& pass) {
    // Each block of photons fills its own list; joined in order, the result does not depend on the threads.
    constexpr std::size_t kBlock = 1024;
    const std::size_t count = pass.count;
    std::vector<std::vector<Photon>> blocks((count + kBlock - 1) / kBlock);
    parallelFor(count, kBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto photon = static_cast<std::uint32_t>(i);
            const Emission emission = emitPhoton(world, photon, pass);
            tracePhoton(world, emission.ray,
                        {.power = emission.power,
                         .photon = photon,
                         .light = emission.light,
                         .media = world.lights[emission.light].media},
                        1, pass, blocks[begin / kBlock]);
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

} // namespace hyalite::reference
