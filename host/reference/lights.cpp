// Sampling the lights from both ends: shadow rays from surfaces, photons from the lights.
#include "reference/lights.h"

#include "reference/world.h"

#include <cmath>
#include <numbers>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

double channelMean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

double offsetOf(const Quad& quad) {
    return surfaceOffset(glm::length(quad.corner) + glm::length(quad.edge0) + glm::length(quad.edge1));
}

Light makeQuadLight(const Quad& quad, const glm::dvec3& radiance) {
    const glm::dvec3 n = glm::cross(quad.edge0, quad.edge1);
    const double area = glm::length(n);
    return {.shape = QuadLight{.quad = quad, .normal = n / area, .area = area, .radiance = radiance},
            .power = pi * area * radiance};
}

} // namespace

std::vector<Light> makeLights(const Scene& scene) {
    std::vector<Light> lights;
    for (const PointLight& point : scene.lights) {
        lights.push_back({.shape = point, .power = 4 * pi * point.intensity});
    }
    for (const Object& object : scene.objects) {
        if (object.emission == glm::dvec3(0)) {
            continue;
        }
        const auto* quad = std::get_if<Quad>(&object.shape);
        if (quad == nullptr) {
            throw Error(ExitCode::BadInput, object.where, "only quads emit light", "give the emission to a quad");
        }
        lights.push_back(makeQuadLight(*quad, object.emission));
    }
    double total = 0;
    for (const Light& light : lights) {
        total += channelMean(light.power);
    }
    double cdf = 0;
    for (Light& light : lights) {
        light.pmf = total > 0 ? channelMean(light.power) / total : 0;
        cdf += light.pmf;
        light.cdf = cdf;
    }
    if (!lights.empty()) {
        lights.back().cdf = 1; // not a rounding error less
    }
    return lights;
}

std::uint32_t chooseLight(const std::vector<Light>& lights, double x) {
    std::uint32_t light = 0;
    while (x >= lights[light].cdf) {
        ++light;
    }
    return light;
}

std::optional<LightSample> sampleLight(const World& world, const VisiblePoint& x, std::uint32_t pass,
                                       std::optional<std::uint32_t> light) {
    const std::uint32_t vertex = x.depth - 1;
    shared::Sampler sampler{.seed = x.samplerSeed, .index = pass};
    double pmf = 1;
    if (light) {
        sampler.seed = shared::hashCombine(sampler.seed, *light);
    } else {
        light = chooseLight(world.lights, sampleUnitSquare(sampler, shared::cameraLightChoice(vertex)).x);
        pmf = world.lights[*light].pmf;
    }
    const Light& chosen = world.lights[*light];

    // The point y on the light, and the intensity it sends towards x in place of a point light's I: a quad sends
    // Le cos(l) per area, and 1 / A is the density of y.
    const auto* quad = std::get_if<QuadLight>(&chosen.shape);
    const glm::dvec3 y = quad != nullptr
                             ? pointOnQuad(sampleUnitSquare(sampler, shared::cameraLightPoint(vertex)), quad->quad)
                             : std::get<PointLight>(chosen.shape).position;
    const glm::dvec3 way = y - x.position;
    const double distance2 = glm::dot(way, way);
    const glm::dvec3 wi = way / std::sqrt(distance2);
    const double cosX = glm::dot(x.normal, wi);
    const double cosLight = quad != nullptr ? -glm::dot(quad->normal, wi) : 1;
    if (!(cosX > 0 && cosLight > 0)) {
        return std::nullopt;
    }
    const glm::dvec3 intensity =
        quad != nullptr ? quad->radiance * cosLight * quad->area : std::get<PointLight>(chosen.shape).intensity;

    return LightSample{.from = x.shadowOrigin,
                       .to = quad != nullptr ? y + offsetOf(quad->quad) * quad->normal : y,
                       .contribution = x.f * intensity * (cosX / (distance2 * pmf))};
}

Emission emitPhoton(const World& world, std::uint32_t photon, std::uint32_t pass) {
    const shared::Sampler sampler = shared::photonSampler(world.render.seed, pass, photon);
    const Light& light = world.lights[chooseLight(world.lights, sampleUnitSquare(sampler, shared::kPhotonLight).x)];
    const glm::dvec2 direction = sampleUnitSquare(sampler, shared::kPhotonDirection);
    const glm::dvec3 power = light.power / (light.pmf * world.render.photons);
    if (const auto* quad = std::get_if<QuadLight>(&light.shape)) {
        const glm::dvec3 origin = pointOnQuad(sampleUnitSquare(sampler, shared::kPhotonOrigin), quad->quad);
        return {.ray = {.origin = origin + offsetOf(quad->quad) * quad->normal,
                        .direction = cosineHemisphere(direction, quad->normal)},
                .power = power};
    }
    return {.ray = {.origin = std::get<PointLight>(light.shape).position, .direction = uniformSphere(direction)},
            .power = power};
}

} // namespace hyalite::reference
