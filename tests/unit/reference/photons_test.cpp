// The photon pass: what is stored, in which order, and that no energy is made or lost.
#include "reference/photons/photons.h"

#include "reference/lights/lights.h"
#include "unit/reference/support.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

std::vector<Photon> photonsOf(const World& world) {
    return tracePhotons(world, progressivePass(world, 0));
}

bool sameBits(const Photon& a, const Photon& b) {
    return std::tie(a.photon, a.depth) == std::tie(b.photon, b.depth) && a.position == b.position &&
           a.direction == b.direction && a.normal == b.normal && a.power == b.power;
}

// A unit sphere seen from inside, with a point light of 1 W/sr at its centre.
Scene hollowSphere(double albedo) {
    Scene scene;
    const std::size_t wall = addMaterial(scene, Diffuse{dvec3(albedo)});
    addObject(scene, Sphere{}, wall);
    scene.lights = {{.position = {0, 0, 0}, .intensity = dvec3(1)}};
    return scene;
}

// The share of the power that arrives at a hit which the surface absorbs on average.
dvec3 absorptance(const World& world, const Ray& ray, const Hit& hit) {
    const Surface surface = evaluateSurface(world, ray, hit);
    if (surface.material == nullptr) {
        return dvec3(1);
    }
    const bool isGlass = surface.material->model.type == shared::kMaterialDielectric;
    return isGlass ? dvec3(0) : dvec3(1) - surface.material->model.color;
}

} // namespace

TEST_CASE("stored photons are ascending, indirect, and short enough for a camera path to follow") {
    Scene scene = cornellBox();
    scene.render.maxDepth = 6;
    const std::vector<Photon> photons = photonsOf(prepareWorld(scene));
    CHECK(photons.size() > 1000);
    for (std::size_t i = 0; i < photons.size(); ++i) {
        CHECK(photons[i].depth >= 2);
        CHECK(photons[i].depth <= 5); // one segment is left for the camera
        CHECK(glm::dot(photons[i].direction, photons[i].normal) > 0);
        if (i > 0) {
            CHECK(std::tie(photons[i - 1].photon, photons[i - 1].depth) <
                  std::tie(photons[i].photon, photons[i].depth));
        }
    }
    CHECK(std::any_of(photons.begin(), photons.end(), [](const Photon& p) { return p.depth == 5; }));
}

TEST_CASE("every run of a pass stores the same photons, and another pass others") {
    const World world = prepareWorld(cornellBox());
    const std::vector<Photon> first = tracePhotons(world, progressivePass(world, 0));
    const std::vector<Photon> again = tracePhotons(world, progressivePass(world, 0));
    const std::vector<Photon> other = tracePhotons(world, progressivePass(world, 1));
    CHECK(std::equal(first.begin(), first.end(), again.begin(), again.end(), sameBits));
    CHECK_FALSE(std::equal(first.begin(), first.end(), other.begin(), other.end(), sameBits));
}

TEST_CASE("photons traced on all cores are those traced one by one") {
    Scene scene = cornellBox();
    scene.render.photons = 3000; // three blocks, the last one not full
    const World world = prepareWorld(scene);
    std::vector<Photon> expected;
    for (std::uint32_t photon = 0; photon < 3000; ++photon) {
        const Emission emission = emitPhoton(world, photon, progressivePass(world, 0));
        std::optional<Ray> ray = emission.ray;
        PhotonPath path{.power = emission.power, .photon = photon, .light = emission.light};
        for (std::uint32_t depth = 1; ray; ++depth) {
            const auto hit = traceClosest(world, *ray);
            if (!hit) {
                break;
            }
            const PhotonScatter scatter = scatterPhoton(world, *ray, *hit, path, depth, progressivePass(world, 0));
            if (scatter.stored) {
                expected.push_back(*scatter.stored);
            }
            ray = scatter.next;
            path = scatter.path;
        }
    }
    const std::vector<Photon> actual = tracePhotons(world, progressivePass(world, 0));
    CHECK(std::equal(actual.begin(), actual.end(), expected.begin(), expected.end(), sameBits));
}

TEST_CASE("emitted flux is absorbed or escapes, channel by channel") {
    // For each photon X = sum of arriving power * absorptance + escaped power - emitted power. Roulette and Fresnel's
    // choice are unbiased, so E[X] = 0; paths may run 250 segments, beyond which less than 0.9^249 = 4e-12 is left. The
    // mean of X must lie within five of its standard errors.
    Scene scene = cornellBox();
    scene.render.maxDepth = 251;
    scene.render.photons = 20000;
    const World world = prepareWorld(scene);
    dvec3 emitted(0);
    dvec3 escapedTotal(0);
    dvec3 sum(0);
    dvec3 sum2(0);
    for (std::uint32_t photon = 0; photon < scene.render.photons; ++photon) {
        const Emission emission = emitPhoton(world, photon, progressivePass(world, 0));
        dvec3 x = -emission.power;
        std::optional<Ray> ray = emission.ray;
        PhotonPath path{.power = emission.power, .photon = photon, .light = emission.light};
        for (std::uint32_t depth = 1; ray; ++depth) {
            const auto hit = traceClosest(world, *ray);
            if (!hit) {
                x += path.power;
                escapedTotal += path.power;
                break;
            }
            x += path.power * absorptance(world, *ray, *hit);
            const PhotonScatter scatter = scatterPhoton(world, *ray, *hit, path, depth, progressivePass(world, 0));
            ray = scatter.next;
            path = scatter.path;
        }
        emitted += emission.power;
        sum += x;
        sum2 += x * x;
    }
    checkNear(emitted, std::numbers::pi * 0.25 * dvec3(18.4, 15.6, 8), 1e-9); // pi A L
    CHECK(escapedTotal.x > 0.05 * emitted.x);                                 // the box is open in front
    const double n = scene.render.photons;
    for (int channel = 0; channel < 3; ++channel) {
        const double standardError = std::sqrt(sum2[channel] / n / n) * n;
        CHECK(std::abs(sum[channel]) <= 5 * standardError);
        CHECK(standardError < 0.01 * emitted[channel]); // a loss of one per cent would be detected
    }
}

TEST_CASE("in a closed sphere each bounce stores the flux times a power of the albedo") {
    // The light's flux is 4 pi W. Photons of depth j have bounced j - 1 times, so they carry 4 pi (1/2)^(j - 1) in all.
    // Roulette keeps each photon with p = 1/2 at unchanged power: their number is binomial with n p (1 - p) variance.
    Scene scene = hollowSphere(0.5);
    scene.render.photons = 20000;
    scene.render.maxDepth = 6;
    std::array<double, 6> power{};
    for (const Photon& photon : photonsOf(prepareWorld(scene))) {
        power.at(photon.depth) += photon.power.x;
        checkNear(photon.normal, -photon.position, 1e-12); // inwards
        CHECK_THAT(glm::length(photon.position), WithinAbs(1, 1e-15));
    }
    for (const int depth : {2, 3, 4, 5}) {
        const double p = std::pow(0.5, depth - 1);
        const double tolerance = 5 * std::sqrt(20000 * p * (1 - p)) / 20000;
        CHECK_THAT(power.at(static_cast<std::size_t>(depth)) / (4 * std::numbers::pi), WithinAbs(p, tolerance));
    }
}

TEST_CASE("photons through glass keep their flux, whatever the index does to radiance") {
    // A beam through a pane of ior 1.5 onto a diffuse floor. All photons reach the floor but those the pane reflects;
    // each stored one carries what it was emitted with.
    Scene scene;
    const std::size_t glass = addMaterial(scene, Dielectric{1.5});
    const std::size_t black = addMaterial(scene, Diffuse{dvec3(0)});
    addObject(scene, Quad{{-50, 1, -50}, {0, 0, 100}, {100, 0, 0}}, glass); // front up
    addObject(scene, Quad{{-50, 0.9, -50}, {100, 0, 0}, {0, 0, 100}}, glass);
    addObject(scene, Quad{{-50, 0, -50}, {0, 0, 100}, {100, 0, 0}}, black);
    addObject(scene, Quad{{-0.5, 2, -0.5}, {1, 0, 0}, {0, 0, 1}}, std::nullopt, dvec3(1)); // down
    scene.render.photons = 1000;
    scene.render.maxDepth = 20;
    const std::vector<Photon> photons = photonsOf(prepareWorld(scene));
    CHECK(photons.size() > 800); // a diffuse beam loses about a tenth at two boundaries
    CHECK(photons.size() < 1000);
    for (const Photon& photon : photons) {
        CHECK_THAT(photon.power.x, WithinAbs(std::numbers::pi / 1000, 1e-15));
        CHECK(photon.depth % 2 == 1); // two boundaries, or two more for each reflection inside
    }
}
