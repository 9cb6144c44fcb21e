// A mixture of the targets' cones, or discs, each weighted by its size: the density of a ray is the number of targets
// that contain it, divided by the sum of all sizes.
#include "reference/photons/projection_map.h"

#include "reference/photons/photons.h"
#include "reference/world.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace hyalite::reference {

namespace {

using std::numbers::pi;

// Directions from a point of a light that meet a sphere; all emitted directions if the sphere's cone is no smaller.
struct Cone {
    glm::dvec3 axis{0}; // unit
    double cosine = -1; // of the half-angle
    bool everything = false;

    [[nodiscard]] double size() const { return 2 * pi * (1 - cosine); } // [sr]
    [[nodiscard]] bool contains(const glm::dvec3& direction) const { return glm::dot(direction, axis) >= cosine; }
};

Cone coneAround(const BoundingSphere& target, const Light& light, const glm::dvec3& point) {
    const glm::dvec3 way = target.center - point;
    const double distance = glm::length(way);
    const double sine = target.radius / distance;
    const double cosine = std::sqrt(std::max(0.0, 1 - sine * sine));
    // From a point inside the sphere, or almost, every direction meets it
    if (!(target.radius * 1.0001 < distance) || !(cosine > emissionCosine(light))) {
        return {.cosine = emissionCosine(light), .everything = true};
    }
    return {.axis = way / distance, .cosine = cosine};
}

glm::dvec3 directionIn(const Cone& cone, glm::dvec2 uv) {
    const double z = 1 - uv.x * (1 - cone.cosine);
    const double sine = std::sqrt(std::max(0.0, 1 - z * z));
    const double phi = 2 * pi * uv.y;
    const Basis basis = orthonormalBasis(cone.axis);
    return sine * std::cos(phi) * basis.tangent + sine * std::sin(phi) * basis.bitangent + z * cone.axis;
}

// For parallel light: the lines that meet a sphere.
struct Disc {
    glm::dvec3 center{0};
    double radius = 0; // [m]
    double area = 0;   // [m^2]
    bool everything = false;

    [[nodiscard]] double size() const { return area; }
    [[nodiscard]] bool contains(const glm::dvec3& point, const glm::dvec3& direction) const {
        return glm::length(glm::cross(point - center, direction)) <= radius;
    }
};

template <class Part>
std::size_t choosePart(const std::vector<Part>& parts, double total, double x) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        sum += parts[i].size();
        if (x * total < sum) {
            return i;
        }
    }
    return parts.size() - 1;
}

template <class Part>
double totalSize(const std::vector<Part>& parts) {
    double total = 0;
    for (const Part& part : parts) {
        total += part.size();
    }
    return total;
}

// Weight of a photon: density of the light's own sampling over that of the mixture. `own`: the light's density;
// `within(i)`: true if the ray is in part i.
template <class Part, class Within>
double weight(const std::vector<Part>& parts, double own, const Within& within) {
    double mixture = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].everything) {
            mixture += parts[i].size() * own;
        } else if (within(i)) {
            mixture += 1;
        }
    }
    return mixture > 0 ? own * totalSize(parts) / mixture : 0;
}

struct Aimed {
    Ray ray;
    glm::dvec3 power; // flux [W] of the light if all its photons were like this one
};

Aimed aimFromPoint(const World& world, const Light& light, LightRay ray, double choice, glm::dvec2 uDirection) {
    std::vector<Cone> cones;
    for (const BoundingSphere& target : world.targets) {
        cones.push_back(coneAround(target, light, ray.origin));
    }
    const std::size_t chosen = choosePart(cones, totalSize(cones), choice);
    if (!cones[chosen].everything) {
        ray.direction = directionIn(cones[chosen], uDirection);
    }
    const double w = weight(cones, emissionDensity(light, ray.normal, ray.direction),
                            [&](std::size_t i) { return i == chosen || cones[i].contains(ray.direction); });
    return {.ray = {.origin = startOf(ray), .direction = ray.direction}, .power = light.power * w};
}

Aimed aimAcross(const World& world, const Light& light, LightRay ray, double choice, glm::dvec2 uOrigin) {
    std::vector<Disc> discs;
    for (const BoundingSphere& target : world.targets) {
        const double area = pi * target.radius * target.radius;
        if (area * ray.pdfOrigin >= 1) { // no narrower than the light's own disc
            discs.push_back({.area = 1 / ray.pdfOrigin, .everything = true});
        } else {
            discs.push_back({.center = target.center, .radius = target.radius, .area = area});
        }
    }
    const std::size_t chosen = choosePart(discs, totalSize(discs), choice);
    if (!discs[chosen].everything) {
        const Basis basis = orthonormalBasis(ray.direction);
        const glm::dvec2 at = discs[chosen].radius * concentricDisc(uOrigin);
        const glm::dvec3 q = discs[chosen].center + at.x * basis.tangent + at.y * basis.bitangent;
        ray.origin = q - glm::dot(q - ray.origin, ray.direction) * ray.direction;
    }
    const double w = weight(discs, originDensity(light, ray.origin, ray.direction),
                            [&](std::size_t i) { return i == chosen || discs[i].contains(ray.origin, ray.direction); });
    return {.ray = {.origin = ray.origin, .direction = ray.direction}, .power = rayPower(light, ray.direction) * w};
}

} // namespace

Emission emitAimedPhoton(const World& world, std::uint32_t photon, const PhotonPass& pass, double shift) {
    const shared::Sampler sampler = shared::photonSampler(pass.sequence, photon);
    const glm::dvec2 choice = sampleUnitSquare(sampler, shared::kPhotonLight, shift);
    const std::uint32_t index = chooseLight(world.lights, choice.x);
    const Light& light = world.lights[index];
    const glm::dvec2 uOrigin = sampleUnitSquare(sampler, shared::kPhotonOrigin, shift);
    const glm::dvec2 uDirection = sampleUnitSquare(sampler, shared::kPhotonDirection, shift);
    const LightRay own = emitFrom(light, uOrigin, uDirection);
    Aimed aimed = own.pdfOrigin > 0 ? aimAcross(world, light, own, choice.y, uOrigin)
                                    : aimFromPoint(world, light, own, choice.y, uDirection);
    aimed.power /= light.pmf * pass.count;
    if (aimed.power == glm::dvec3(0)) {
        aimed.ray.tMax = 0; // the light does not emit in that direction
    }
    return {.ray = aimed.ray, .power = aimed.power, .light = index};
}

} // namespace hyalite::reference
