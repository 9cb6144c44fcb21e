// Absorption in glass against closed forms.
#include "reference/media/medium.h"

#include "reference/integrators/whitted.h"
#include "reference/media/media_depth.h"
#include "reference/photons/photons.h"
#include "unit/reference/support.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

// A pane of thickness d across the z axis between the camera and a light of radiance 1.
Scene pane(double d, const Dielectric& glass) {
    Scene scene = onePixel({0, 0, 3}, {0, 0, 0}, "whitted");
    scene.render.maxDepth = 60;
    scene.render.minWeight = 0;
    const std::size_t material = addMaterial(scene, glass);
    addObject(scene, Quad{{-1, -1, d / 2}, {2, 0, 0}, {0, 2, 0}}, material);                  // faces the camera
    addObject(scene, Quad{{-1, -1, -d / 2}, {0, 2, 0}, {2, 0, 0}}, material);                 // faces the light
    addObject(scene, Quad{{-1, -1, -3}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, dvec3(1, 1, 1)); // the light
    return scene;
}

} // namespace

TEST_CASE("a pane transmits (1 - F)^2 a / (1 - F^2 a^2), where a is the transmittance of one passage") {
    // a = e^(-sigma d). Straight through: (1 - F) a (1 - F); every further pair of reflections within the pane takes
    // F^2 and two passages more: a geometric series. F = ((n - 1) / (n + 1))^2 at normal incidence.
    const double d = 0.4;
    const double n = 1.5;
    const dvec3 sigma(0, 1.5, 6);
    const double F = std::pow((n - 1) / (n + 1), 2);
    const World world = prepareWorld(pane(d, Dielectric{n, 0, sigma}));
    const dvec3 L = whittedRadiance(world, 0, 0);
    for (int channel = 0; channel < 3; ++channel) {
        const double a = std::exp(-sigma[channel] * d);
        const double expected = (1 - F) * (1 - F) * a / (1 - F * F * a * a);
        CHECK_THAT(L[channel], WithinRel(expected, 1e-7)); // rays lean by up to 1e-4: the passage grows by 1e-8
    }
}

TEST_CASE("a photon is absorbed inside glass, and only there") {
    const dvec3 sigma(0.5, 1, 2);
    const World world = prepareWorld(pane(0.4, Dielectric{1.5, 0, sigma}));
    PhotonPass pass = progressivePass(world, 0);
    PhotonPath path{.power = dvec3(1), .photon = 0, .light = 0, .kind = PhotonKind::Direct};
    // From the light onto the pane, through it, and out: whichever of its random numbers refract it
    std::optional<Ray> ray = Ray{.origin = {0, 0, -2}, .direction = {0, 0, 1}};
    for (std::uint32_t depth = 1; ray && depth <= 2; ++depth) {
        const auto hit = traceClosest(world, *ray);
        REQUIRE(hit);
        PhotonScatter scatter;
        do {
            scatter = scatterPhoton(world, *ray, *hit, path, depth, pass);
            ++path.photon;
        } while (scatter.next->direction.z < 0);
        ray = scatter.next;
        path = scatter.path;
        CHECK(path.media.list().empty() == (depth == 2));
    }
    checkNear(path.power, glm::exp(-sigma * 0.4), 1e-12);
}

TEST_CASE("space outside dielectrics absorbs nothing") {
    const std::vector<Material> materials{{.name = {}, .model = Dielectric{1.5, 0, {0, 1, 2}}}};
    Media media;
    CHECK(transmittance(materials, media, 5) == dvec3(1));
    media.enter(0);
    checkNear(transmittance(materials, media, 3), {1, std::exp(-3.0), std::exp(-6.0)}, 1e-15);
    media.leave(0);
    CHECK(transmittance(materials, media, 5) == dvec3(1));
}

TEST_CASE("the volume of highest priority fills a place, and what has none is nested in it") {
    const auto dielectric = [](double ior, std::uint32_t priority) {
        return Material{.name = {}, .model = Dielectric{.ior = ior, .priority = priority}};
    };
    // 0 glass, 1 water, 2 ice of the water's priority, 3 a bubble without
    const std::vector<Material> materials{dielectric(1.5, 2), dielectric(1.33, 1), dielectric(1.31, 1),
                                          dielectric(0.5, 0)};
    const auto indexIn = [&](std::initializer_list<std::uint32_t> list) {
        Media media;
        for (const std::uint32_t material : list) {
            media.enter(material);
        }
        return mediumOf(materials, media).index;
    };
    CHECK(indexIn({}) == 1);
    CHECK(indexIn({1}) == 1.33);
    CHECK(indexIn({0, 1}) == 1.5); // in any order
    CHECK(indexIn({1, 0}) == 1.5);
    CHECK(indexIn({1, 2}) == 1.31); // of equal priorities the later material
    CHECK(indexIn({2, 1}) == 1.31);
    CHECK(indexIn({3, 3}) == 0.25);
    CHECK(indexIn({1, 3}) == 1.33 * 0.5);   // a bubble in water
    CHECK(indexIn({3, 1}) == 1.33);         // water in a bubble
    CHECK(indexIn({0, 3, 1}) == 1.5 * 0.5); // water in a bubble in glass is not there
    Media media;
    media.enter(1);
    media.enter(0);
    media.leave(1); // the outer one first
    CHECK(mediumOf(materials, media).index == 1.5);
    media.leave(1); // it has none
    CHECK(mediumOf(materials, media).index == 1.5);
    media.leave(0);
    CHECK(media == Media());
}

TEST_CASE("dielectrics nested deeper than a path's list are refused where they are") {
    // 15 materials take 4 bits each: a list of 32 bits has room for 8. The eighth ball is the last that fits.
    Scene scene = onePixel({0, 0, 30}, {0, 0, 0}, "whitted");
    for (int i = 0; i < 15; ++i) {
        addMaterial(scene, Dielectric{1.5});
    }
    for (std::size_t i = 0; i < 8; ++i) {
        addObject(scene, Sphere{{0, 0, 0}, 10.0 - static_cast<double>(i)}, i);
    }
    CHECK_NOTHROW(checkMediaDepth(scene));
    addObject(scene, Sphere{{0, 0, 0}, 1.5}, 8);
    CHECK_THROWS_AS(checkMediaDepth(scene), Error);
}
