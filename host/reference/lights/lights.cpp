// Sampling the lights from both ends: shadow rays from surfaces, photons from the lights.
#include "reference/lights/lights.h"

#include "reference/lights/light_choice.h"
#include "reference/lights/receiver.h"
#include "reference/lights/shadow.h"
#include "reference/photons/photons.h"
#include "reference/photons/projection_map.h"
#include "reference/world.h"

#include "shaders/shared/limits.h"

#include <utility>

namespace hyalite::reference {

namespace {

double channelMean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

void setProbabilities(std::vector<Light>& lights) {
    double total = 0;
    double shares = 0;
    for (const Light& light : lights) {
        total += channelMean(light.power) * light.share;
        shares += light.share;
    }
    constexpr double kEven = shared::kEvenPhotons;
    double cdf = 0;
    for (Light& light : lights) {
        const double byFlux = total > 0 ? channelMean(light.power) / total : 0;
        light.pmf = total > 0 ? light.share * ((1 - kEven) * byFlux + kEven / shares) : 0;
        cdf += light.pmf;
        light.cdf = cdf;
    }
    if (!lights.empty()) {
        lights.back().cdf = 1; // exactly, despite rounding
    }
}

} // namespace

std::vector<Light> makeLights(const Scene& scene) {
    std::vector<Light> lights;
    const LightSphere sphere = lightSphere(scene);
    const auto add = [&lights](auto shape, double share) {
        const glm::dvec3 flux = fluxOf(shape);
        lights.push_back({.shape = std::move(shape), .power = flux, .share = share});
    };
    if (scene.environment) {
        add(SurroundingLight{.map = EnvironmentLight(*scene.environment), .sphere = sphere},
            scene.environment->photonShare);
    }
    for (const PointLight& point : scene.lights) {
        add(point, point.photonShare);
    }
    for (const SpotLight& spot : scene.spots) {
        add(spot, spot.photonShare);
    }
    for (const DirectionalLight& light : scene.directionals) {
        add(makeParallel(light, sphere), light.photonShare);
    }
    for (const Object& object : scene.objects) {
        if (object.emission != glm::dvec3(0)) {
            add(makeAreaLight(scene, object), object.photonShare);
            lights.back().object = static_cast<std::uint32_t>(&object - scene.objects.data());
        }
    }
    setProbabilities(lights);
    return lights;
}

std::uint32_t chooseLight(const std::vector<Light>& lights, double x) {
    std::uint32_t light = 0;
    while (x >= lights[light].cdf) {
        ++light;
    }
    return light;
}

LightArrival sampleArrival(const World& world, const glm::dvec3& receiver, const LightChoice& choice) {
    const std::uint32_t vertex = choice.depth - 1;
    shared::Sampler sampler = shared::pathSampler(choice.samplerSeed, choice.pass);
    std::uint32_t light = 0;
    double pmf = 1;
    if (choice.light) {
        light = *choice.light;
        sampler.seed = shared::deriveSequence(sampler.seed, light);
    } else {
        const LightPick pick =
            pickLightAt(world, receiver, sampleUnitSquare(sampler, shared::cameraLightChoice(vertex), choice.shift));
        light = pick.light;
        pmf = pick.pmf;
    }
    const glm::dvec2 uv = sampleUnitSquare(sampler, shared::cameraLightPoint(vertex), choice.shift);
    const Light& chosen = world.lights[light];
    const Offer offer = std::visit([&](const auto& shape) { return offerTo(receiver, shape, uv); }, chosen.shape);
    return {.direction = glm::normalize(offer.toLight),
            .shadowEnd = offer.shadowEnd,
            .irradiance = offer.irradiance / pmf,
            .pdfW = pmf * offer.pdfW};
}

std::optional<LightSample> sampleLight(const World& world, const VisiblePoint& x, std::uint32_t pass,
                                       std::optional<std::uint32_t> light, double shift) {
    const LightArrival arrival =
        sampleArrival(world, x.position,
                      {.depth = x.depth, .samplerSeed = x.samplerSeed, .pass = pass, .light = light, .shift = shift});
    const double cosX = glm::dot(x.normal, arrival.direction);
    if (!(cosX > 0 && channelMean(arrival.irradiance) > 0)) {
        return std::nullopt;
    }
    const Receiver receiver = receiverAt(x);
    // whitted has no other rays that find a light behind glass; those of path find the lights that have a surface
    const CameraPathRules& rules = world.cameraPaths;
    const bool passes = rules.followsAllWays || (rules.bouncesAtDiffuse && arrival.pdfW == 0);
    return inMedia(world, {.from = x.shadowOrigin,
                           .to = arrival.shadowEnd,
                           .contribution = receiver.f * arrival.irradiance * (cosX * receiver.incident(cosX)),
                           .cosine = cosX,
                           .pdfW = arrival.pdfW,
                           .media = x.media,
                           .passes = passes && world.hasStraightGlass});
}

LightSample inMedia(const World& world, LightSample sample) {
    if (!sample.passes) {
        sample.contribution *= transmittance(world.materials, sample.media, glm::length(sample.to - sample.from));
    }
    return sample;
}

glm::dvec3 arriving(const World& world, const LightSample& sample) {
    if (!sample.passes) {
        return traceShadow(world, sample.from, sample.to) ? sample.contribution : glm::dvec3(0);
    }
    return sample.contribution * straightTransmittance(world, sample.from, sample.to, sample.media);
}

glm::dvec3 environmentRadiance(const World& world, const glm::dvec3& direction) {
    for (const Light& light : world.lights) {
        if (const auto* surrounding = std::get_if<SurroundingLight>(&light.shape)) {
            return surrounding->map.radiance(direction);
        }
    }
    return glm::dvec3(0);
}

double lightPdf(const Light& light, const glm::dvec3& /*receiver*/, const glm::dvec3& direction, double distance,
                const glm::dvec3& lightNormal) {
    return std::visit([&](const auto& shape) { return pdfToward(shape, direction, distance, lightNormal); },
                      light.shape);
}

LightRay emitFrom(const Light& light, glm::dvec2 uOrigin, glm::dvec2 uDirection) {
    LightRay ray = std::visit([&](const auto& shape) { return emitFrom(shape, uOrigin, uDirection); }, light.shape);
    ray.power = rayPower(light, ray.direction);
    return ray;
}

glm::dvec3 rayPower(const Light& light, const glm::dvec3& direction) {
    const auto* surrounding = std::get_if<SurroundingLight>(&light.shape);
    return surrounding != nullptr ? rayPower(*surrounding, direction) : light.power;
}

double emissionDensity(const Light& light, const glm::dvec3& normal, const glm::dvec3& direction) {
    return std::visit([&](const auto& shape) { return emissionDensity(shape, normal, direction); }, light.shape);
}

double emissionCosine(const Light& light) {
    return std::visit([](const auto& shape) { return emissionCosine(shape); }, light.shape);
}

double originDensity(const Light& light, const glm::dvec3& point, const glm::dvec3& direction) {
    const auto disc = std::visit([](const auto& shape) { return startDisc(shape); }, light.shape);
    return disc && disc->isPassed(point, direction) ? 1 / disc->area() : 0;
}

bool looksAt(const Light& light, const glm::dvec3& origin, const glm::dvec3& direction) {
    const auto* area = std::get_if<AreaLight>(&light.shape);
    return area != nullptr && looksAt(*area, origin, direction);
}

Emission emitPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass, double shift) {
    if (pass.aimed) {
        return emitAimedPhoton(world, photon, pass, shift);
    }
    const shared::Sampler sampler = shared::photonSampler(pass.sequence, photon);
    const std::uint32_t index = chooseLight(world.lights, sampleUnitSquare(sampler, shared::kPhotonLight, shift).x);
    const Light& light = world.lights[index];
    const LightRay ray = emitFrom(light, sampleUnitSquare(sampler, shared::kPhotonOrigin, shift),
                                  sampleUnitSquare(sampler, shared::kPhotonDirection, shift));
    return {.ray = {.origin = startOf(ray), .direction = ray.direction},
            .power = ray.power / (light.pmf * pass.count),
            .light = index};
}

} // namespace hyalite::reference
