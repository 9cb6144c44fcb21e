// Sampling the lights from both ends: shadow rays from surfaces, photons from the lights.
#include "reference/lights.h"

#include "reference/materials.h"
#include "reference/photons.h"
#include "reference/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

double channelMean(const glm::dvec3& c) {
    return (c.x + c.y + c.z) / 3;
}

// A point of a light's surface with its normal on the emitting side, and how far a ray starts from it.
struct LightPoint {
    glm::dvec3 position;
    glm::dvec3 normal;
    double offset = 0;

    [[nodiscard]] glm::dvec3 moved() const { return position + offset * normal; }
};

LightPoint pointOn(const Quad& quad, glm::dvec2 uv) {
    return {.position = pointOnQuad(uv, quad),
            .normal = glm::normalize(glm::cross(quad.edge0, quad.edge1)),
            .offset = surfaceOffset(glm::length(quad.corner) + glm::length(quad.edge0) + glm::length(quad.edge1))};
}
LightPoint pointOn(const Disk& disk, glm::dvec2 uv) {
    const glm::dvec2 at = concentricDisc(uv);
    return {.position = disk.center + at.x * disk.axis0 + at.y * disk.axis1,
            .normal = glm::normalize(glm::cross(disk.axis0, disk.axis1)),
            .offset = surfaceOffset(glm::length(disk.center) + glm::length(disk.axis0) + glm::length(disk.axis1))};
}
LightPoint pointOn(const Sphere& sphere, glm::dvec2 uv) {
    const glm::dvec3 normal = uniformSphere(uv);
    return {.position = sphere.center + sphere.radius * normal,
            .normal = normal,
            .offset = surfaceOffset(glm::length(sphere.center) + sphere.radius)};
}

// Evenly distributed over the area.
LightPoint pointOn(const AreaLight& light, glm::dvec2 uv) {
    return std::visit([&](const auto& shape) { return pointOn(shape, uv); }, light.shape);
}

double areaOf(const Quad& quad) {
    return glm::length(glm::cross(quad.edge0, quad.edge1));
}
double areaOf(const Disk& disk) {
    return pi * glm::length(glm::cross(disk.axis0, disk.axis1));
}
double areaOf(const Sphere& sphere) {
    return 4 * pi * sphere.radius * sphere.radius;
}

template <class S>
Light makeAreaLight(const S& shape, const glm::dvec3& radiance) {
    const double area = areaOf(shape);
    return {.shape = AreaLight{.shape = shape, .area = area, .radiance = radiance}, .power = pi * area * radiance};
}

Light makeAreaLight(const Object& object) {
    if (const auto* quad = std::get_if<Quad>(&object.shape)) {
        return makeAreaLight(*quad, object.emission);
    }
    if (const auto* disk = std::get_if<Disk>(&object.shape)) {
        return makeAreaLight(*disk, object.emission);
    }
    if (const auto* sphere = std::get_if<Sphere>(&object.shape)) {
        return makeAreaLight(*sphere, object.emission);
    }
    throw Error(ExitCode::BadInput, object.where, "only quads, disks and spheres emit light",
                "give the emission to one of these");
}

// What a light offers a receiver: a point, and the intensity that it sends there in place of a point light's I.
struct Offer {
    glm::dvec3 position;
    glm::dvec3 shadowEnd;
    glm::dvec3 intensity;
    double pdfW = 0; // see lightPdfW
};

// Of a sphere only the half that faces the receiver is sampled.
double sampledArea(const AreaLight& light) {
    return std::holds_alternative<Sphere>(light.shape) ? light.area / 2 : light.area;
}

Offer offerTo(const glm::dvec3& /*receiver*/, const PointLight& light, glm::dvec2 /*uv*/) {
    return {.position = light.position, .shadowEnd = light.position, .intensity = light.intensity};
}

// An area sends Le cos(l) per area, and 1 / A is the density of the point.
Offer offerTo(const glm::dvec3& receiver, const AreaLight& light, glm::dvec2 uv) {
    LightPoint y = pointOn(light, uv);
    if (const auto* sphere = std::get_if<Sphere>(&light.shape)) {
        if (glm::dot(y.normal, receiver - sphere->center) < 0) {
            y.normal = -y.normal;
            y.position = sphere->center + sphere->radius * y.normal;
        }
    }
    const double distance = glm::length(receiver - y.position);
    const glm::dvec3 fromLight = (receiver - y.position) / distance;
    const double cosLight = std::max(0.0, glm::dot(y.normal, fromLight));
    return {.position = y.position,
            .shadowEnd = y.moved(),
            .intensity = light.radiance * (cosLight * sampledArea(light)),
            .pdfW = cosLight > 0 ? lightPdfW(light, y.normal, fromLight, distance) : 0};
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
        lights.push_back(makeAreaLight(object));
        lights.back().object = static_cast<std::uint32_t>(&object - scene.objects.data());
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

double lightPdfW(const AreaLight& light, const glm::dvec3& normal, const glm::dvec3& fromLight, double distance) {
    return distance * distance / (glm::dot(normal, fromLight) * sampledArea(light));
}

LightArrival sampleArrival(const World& world, const glm::dvec3& receiver, const LightChoice& choice) {
    const std::uint32_t vertex = choice.depth - 1;
    shared::Sampler sampler{.seed = choice.samplerSeed, .index = choice.pass};
    std::uint32_t light = 0;
    double pmf = 1;
    if (choice.light) {
        light = *choice.light;
        sampler.seed = shared::hashCombine(sampler.seed, light);
    } else {
        light = chooseLight(world.lights, sampleUnitSquare(sampler, shared::cameraLightChoice(vertex)).x);
        pmf = world.lights[light].pmf;
    }
    const glm::dvec2 uv = sampleUnitSquare(sampler, shared::cameraLightPoint(vertex));
    const Offer offer =
        std::visit([&](const auto& shape) { return offerTo(receiver, shape, uv); }, world.lights[light].shape);
    const glm::dvec3 way = offer.position - receiver;
    return {.position = offer.position,
            .shadowEnd = offer.shadowEnd,
            .irradiance = offer.intensity / (glm::dot(way, way) * pmf),
            .pdfW = pmf * offer.pdfW};
}

std::optional<LightSample> sampleLight(const World& world, const VisiblePoint& x, std::uint32_t pass,
                                       std::optional<std::uint32_t> light) {
    const LightArrival arrival = sampleArrival(
        world, x.position, {.depth = x.depth, .samplerSeed = x.samplerSeed, .pass = pass, .light = light});
    const double cosX = glm::dot(x.normal, glm::normalize(arrival.position - x.position));
    if (!(cosX > 0 && channelMean(arrival.irradiance) > 0)) {
        return std::nullopt;
    }
    const double entering = x.coated ? coatTransmission(cosX) : 1;
    return LightSample{
        .from = x.shadowOrigin, .to = arrival.shadowEnd, .contribution = x.f * arrival.irradiance * (cosX * entering)};
}

Emission emitPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass) {
    const shared::Sampler sampler = shared::photonSampler(pass.sequence, photon);
    const std::uint32_t index = chooseLight(world.lights, sampleUnitSquare(sampler, shared::kPhotonLight).x);
    const Light& light = world.lights[index];
    const glm::dvec2 direction = sampleUnitSquare(sampler, shared::kPhotonDirection);
    const glm::dvec3 power = light.power / (light.pmf * pass.count);
    if (const auto* area = std::get_if<AreaLight>(&light.shape)) {
        const LightPoint origin = pointOn(*area, sampleUnitSquare(sampler, shared::kPhotonOrigin));
        return {.ray = {.origin = origin.moved(), .direction = cosineHemisphere(direction, origin.normal)},
                .power = power,
                .light = index};
    }
    return {.ray = {.origin = std::get<PointLight>(light.shape).position, .direction = uniformSphere(direction)},
            .power = power,
            .light = index};
}

} // namespace hyalite::reference
