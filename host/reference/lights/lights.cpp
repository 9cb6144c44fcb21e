// Sampling the lights from both ends: shadow rays from surfaces, photons from the lights.
#include "reference/lights/lights.h"

#include "reference/bsdf/materials.h"
#include "reference/photons/photons.h"
#include "reference/photons/projection_map.h"
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

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>; // clang 14 does not deduce aggregates

// ---- Spots: their profile s(c) over the cosine c with the axis is 1 above the inner cosine, 0 below the outer one,
// and t^2 (3 - 2 t) between, with t = (c - outer) / (inner - outer).

struct Cone {
    double inner; // cosines
    double outer;

    explicit Cone(const SpotLight& spot)
        : inner(std::cos(spot.angle * (1 - spot.blend) * pi / 180)), outer(std::cos(spot.angle * pi / 180)) {}

    // The integral of t^2 (3 - 2 t) over t is 1/2: s integrates over c to this.
    [[nodiscard]] double integral() const { return (1 - inner) + (inner - outer) / 2; }

    [[nodiscard]] double profile(double c) const {
        if (c >= inner) {
            return 1;
        }
        if (c <= outer) {
            return 0;
        }
        const double t = (c - outer) / (inner - outer);
        return t * t * (3 - 2 * t);
    }

    // The cosine above which s has the share x of its integral; between the cones by bisection.
    [[nodiscard]] double quantile(double x) const {
        const double above = x * integral();
        if (above <= 1 - inner) {
            return 1 - above;
        }
        const double share = 1 - (above - (1 - inner)) / ((inner - outer) / 2); // of the falling part, below c
        double low = 0;
        double high = 1;
        for (int i = 0; i < 60; ++i) {
            const double t = (low + high) / 2;
            (2 * t * t * t - t * t * t * t < share ? low : high) = t; // the integral of 2 t^2 (3 - 2 t)
        }
        return outer + low * (inner - outer);
    }
};

glm::dvec3 sampleSpot(const SpotLight& spot, glm::dvec2 uv) {
    const double cosine = Cone(spot).quantile(uv.x);
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const double phi = 2 * pi * uv.y;
    const Basis basis = orthonormalBasis(spot.direction);
    return sine * std::cos(phi) * basis.tangent + sine * std::sin(phi) * basis.bitangent + cosine * spot.direction;
}

// ---- Light from discs

// Across the light, whichever way that goes.
struct Disc {
    glm::dvec3 center; // [m]
    double radius;     // [m]

    [[nodiscard]] double area() const { return pi * radius * radius; }
    [[nodiscard]] bool isPassed(const glm::dvec3& point, const glm::dvec3& direction) const {
        return glm::length(glm::cross(point - center, direction)) <= radius;
    }
    [[nodiscard]] glm::dvec3 point(const glm::dvec3& direction, glm::dvec2 uv) const {
        const glm::dvec2 at = radius * concentricDisc(uv);
        const Basis basis = orthonormalBasis(direction);
        return center + at.x * basis.tangent + at.y * basis.bitangent;
    }
};

std::optional<Disc> discOf(const Light& light) {
    if (const auto* parallel = std::get_if<ParallelLight>(&light.shape)) {
        return Disc{parallel->center, parallel->radius};
    }
    if (const auto* surrounding = std::get_if<SurroundingLight>(&light.shape)) {
        return Disc{surrounding->sphere.center, surrounding->sphere.radius};
    }
    return std::nullopt;
}

ParallelLight makeParallel(const DirectionalLight& light, const LightSphere& sphere) {
    ParallelLight parallel{.direction = light.direction, .irradiance = light.irradiance};
    if (light.beam) {
        parallel.center = light.beam->center;
        parallel.radius = light.beam->radius;
    } else {
        parallel.isEverywhere = true;
        parallel.center = sphere.center - sphere.distance * light.direction;
        parallel.radius = sphere.radius;
    }
    return parallel;
}

// ---- What a light offers a receiver: the way to it, and the irradiance of a surface that faces that way, the density
// of the choice divided out.
struct Offer {
    glm::dvec3 way; // to a place on the light [m]; kBeyond long where there is none
    glm::dvec3 shadowEnd;
    glm::dvec3 irradiance{0};
    double pdfW = 0; // 0: no choice
};

Offer offerFrom(const glm::dvec3& place, const glm::dvec3& receiver, const glm::dvec3& intensity) {
    const glm::dvec3 way = place - receiver;
    return {.way = way, .shadowEnd = place, .irradiance = intensity / glm::dot(way, way)};
}

Offer offerTo(const glm::dvec3& receiver, const PointLight& light, glm::dvec2 /*uv*/) {
    return offerFrom(light.position, receiver, light.intensity);
}

Offer offerTo(const glm::dvec3& receiver, const SpotLight& light, glm::dvec2 /*uv*/) {
    const double cosine = glm::dot(light.direction, glm::normalize(receiver - light.position));
    return offerFrom(light.position, receiver, light.intensity * Cone(light).profile(cosine));
}

Offer offerTo(const glm::dvec3& receiver, const ParallelLight& light, glm::dvec2 /*uv*/) {
    const double along = glm::dot(receiver - light.center, light.direction);
    const double distance = light.isEverywhere ? kBeyond : along;
    const bool isLit =
        light.isEverywhere || (along > 0 && Disc{light.center, light.radius}.isPassed(receiver, light.direction));
    const glm::dvec3 way = -distance * light.direction;
    return {.way = way, .shadowEnd = receiver + way, .irradiance = isLit ? light.irradiance : glm::dvec3(0)};
}

Offer offerTo(const glm::dvec3& receiver, const SurroundingLight& light, glm::dvec2 uv) {
    const glm::dvec3 direction = light.map.sample(uv);
    const double pdfW = light.map.pdfW(direction);
    const glm::dvec3 way = kBeyond * direction;
    return {.way = way,
            .shadowEnd = receiver + way,
            .irradiance = pdfW > 0 ? light.map.radiance(direction) / pdfW : glm::dvec3(0),
            .pdfW = pdfW};
}

// An area sends Le cos(l) per area, and 1 / A is the density of the point.
Offer offerTo(const glm::dvec3& receiver, const AreaLight& light, glm::dvec2 uv) {
    const LightPoint y = pointFacing(light, receiver, uv);
    const double cosLight = glm::dot(y.normal, glm::normalize(receiver - y.position));
    Offer offer = offerFrom(y.position, receiver, light.radiance * (std::max(cosLight, 0.0) * areaFacing(light)));
    // Moved off by the roundings of the way there too, which those of the light's coordinates do not bound
    offer.shadowEnd = y.moved() + surfaceOffset(glm::length(offer.way)) * y.normal;
    offer.pdfW = cosLight > 0 ? glm::dot(offer.way, offer.way) / (cosLight * areaFacing(light)) : 0;
    return offer;
}

void setProbabilities(std::vector<Light>& lights) {
    double total = 0;
    for (const Light& light : lights) {
        total += channelMean(light.power) * light.share;
    }
    double cdf = 0;
    for (Light& light : lights) {
        light.pmf = total > 0 ? channelMean(light.power) * light.share / total : 0;
        cdf += light.pmf;
        light.cdf = cdf;
    }
    if (!lights.empty()) {
        lights.back().cdf = 1; // not a rounding error less
    }
}

} // namespace

std::vector<Light> makeLights(const Scene& scene) {
    std::vector<Light> lights;
    const LightSphere sphere = lightSphere(scene);
    if (scene.environment) {
        SurroundingLight surrounding{.map = EnvironmentLight(*scene.environment), .sphere = sphere};
        const glm::dvec3 power = pi * sphere.radius * sphere.radius * surrounding.map.integral();
        lights.push_back({.shape = std::move(surrounding), .power = power, .share = scene.environment->photonShare});
    }
    for (const PointLight& point : scene.lights) {
        lights.push_back({.shape = point, .power = 4 * pi * point.intensity, .share = point.photonShare});
    }
    for (const SpotLight& spot : scene.spots) {
        const glm::dvec3 power = 2 * pi * Cone(spot).integral() * spot.intensity;
        lights.push_back({.shape = spot, .power = power, .share = spot.photonShare});
    }
    for (const DirectionalLight& light : scene.directionals) {
        const ParallelLight parallel = makeParallel(light, sphere);
        const glm::dvec3 power = pi * parallel.radius * parallel.radius * light.irradiance;
        lights.push_back({.shape = parallel, .power = power, .share = light.photonShare});
    }
    for (const Object& object : scene.objects) {
        if (object.emission != glm::dvec3(0)) {
            AreaLight area = makeAreaLight(scene, object);
            const glm::dvec3 power = pi * area.area * area.radiance;
            lights.push_back({.shape = std::move(area),
                              .power = power,
                              .share = object.photonShare,
                              .object = static_cast<std::uint32_t>(&object - scene.objects.data())});
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
        const double x = sampleUnitSquare(sampler, shared::cameraLightChoice(vertex), choice.shift).x;
        light = chooseLight(world.lights, x);
        pmf = world.lights[light].pmf;
    }
    const glm::dvec2 uv = sampleUnitSquare(sampler, shared::cameraLightPoint(vertex), choice.shift);
    const Light& chosen = world.lights[light];
    const Offer offer = std::visit([&](const auto& shape) { return offerTo(receiver, shape, uv); }, chosen.shape);
    return {.direction = glm::normalize(offer.way),
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
    const double entering = x.coated ? coatTransmission(cosX) : 1;
    return LightSample{.from = x.shadowOrigin,
                       .to = arrival.shadowEnd,
                       .contribution = x.f * arrival.irradiance * (cosX * entering),
                       .cosine = cosX,
                       .pdfW = arrival.pdfW};
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
    if (const auto* surrounding = std::get_if<SurroundingLight>(&light.shape)) {
        return surrounding->map.pdfW(direction);
    }
    if (const auto* area = std::get_if<AreaLight>(&light.shape)) {
        const double cosLight = -glm::dot(direction, lightNormal);
        return cosLight > 0 ? distance * distance / (cosLight * areaFacing(*area)) : 0;
    }
    return 0;
}

LightRay emitFrom(const Light& light, glm::dvec2 uOrigin, glm::dvec2 uDirection) {
    LightRay ray = std::visit(
        Overloaded{
            [&](const PointLight& point) {
                return LightRay{.origin = point.position, .direction = uniformSphere(uDirection)};
            },
            [&](const SpotLight& spot) {
                return LightRay{.origin = spot.position, .direction = sampleSpot(spot, uDirection)};
            },
            [&](const ParallelLight& parallel) {
                const glm::dvec3& d = parallel.direction;
                return LightRay{.origin = Disc{parallel.center, parallel.radius}.point(d, uOrigin), .direction = d};
            },
            [&](const SurroundingLight& surrounding) {
                const LightSphere& sphere = surrounding.sphere;
                const glm::dvec3 d = -surrounding.map.sample(uDirection);
                const Disc disc{sphere.center - sphere.distance * d, sphere.radius};
                return LightRay{.origin = disc.point(d, uOrigin), .direction = d};
            },
            [&](const AreaLight& area) {
                const LightPoint point = pointOn(area, uOrigin);
                return LightRay{.origin = point.position,
                                .direction = cosineHemisphere(uDirection, point.normal),
                                .normal = point.normal,
                                .offset = point.offset};
            },
        },
        light.shape);
    ray.power = rayPower(light, ray.direction);
    if (const auto disc = discOf(light)) {
        ray.pdfOrigin = 1 / disc->area();
    } else {
        ray.pdfDirection = emissionDensity(light, ray.normal, ray.direction);
    }
    return ray;
}

glm::dvec3 rayPower(const Light& light, const glm::dvec3& direction) {
    const auto* surrounding = std::get_if<SurroundingLight>(&light.shape);
    if (surrounding == nullptr) {
        return light.power;
    }
    const double pdfW = surrounding->map.pdfW(-direction);
    const double discArea = pi * surrounding->sphere.radius * surrounding->sphere.radius;
    return pdfW > 0 ? surrounding->map.radiance(-direction) * (discArea / pdfW) : glm::dvec3(0);
}

double emissionDensity(const Light& light, const glm::dvec3& normal, const glm::dvec3& direction) {
    return std::visit(Overloaded{
                          [](const PointLight&) { return 1 / (4 * pi); },
                          [&](const SpotLight& spot) {
                              const Cone cone(spot);
                              return cone.profile(glm::dot(spot.direction, direction)) / (2 * pi * cone.integral());
                          },
                          [](const ParallelLight&) { return 0.0; },
                          [&](const SurroundingLight& surrounding) { return surrounding.map.pdfW(-direction); },
                          [&](const AreaLight&) { return std::max(0.0, glm::dot(normal, direction)) / pi; },
                      },
                      light.shape);
}

double originDensity(const Light& light, const glm::dvec3& point, const glm::dvec3& direction) {
    const auto disc = discOf(light);
    return disc && disc->isPassed(point, direction) ? 1 / disc->area() : 0;
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
