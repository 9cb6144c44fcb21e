// Rough and metallic surfaces: shade_surface, trace_whitted and sample_rough_lights against their twins.
#include "kernel/bounce.h"
#include "kernel/visible_points.h"

#include <catch2/generators/catch_generators.hpp>

namespace hyalite::testing {

namespace {

// The surface's normal is right to 2e-6 on a small sphere; facets, reflected directions and densities lose digits like
// those of smooth surfaces by the cosines, and once more by 1 / alpha, 1 / 0.04 at most here.
constexpr double kRoughError = 2e-4;

// Rays from all over the box, shaded on both sides.
struct RoughBounce {
    BothSides both;
    std::vector<shared::Ray> rays;
    std::vector<shared::CameraPath> paths;
    std::optional<Bounce> device;
    std::vector<std::optional<reference::Shading>> expected; // none: another object was hit

    explicit RoughBounce(Ways ways) : both(sceneFor(ways)) {
        reference::test::Random random;
        for (std::uint32_t i = 0; i < 20000; ++i) {
            const dvec3 origin = random.inCube(0.99);
            rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
            paths.push_back({vec3(0.5, 0.25, 1), i, shared::hash(i), shared::kNone, static_cast<float>(i % 3)});
        }
        device.emplace(shade(both, rays, paths, 1, 3, ways));
        expected.resize(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const reference::Ray ray = toReference(rays[i]);
            const auto hit = reference::traceClosest(both.world, ray);
            if (hit && hit->object == both.sceneObject(device->hits.host()[i].object)) {
                const reference::CameraPath path{dvec3(paths[i].beta), paths[i].samplerSeed, {}, paths[i].pdfW};
                expected[i] = reference::shadeSurface(both.world, ray, *hit, path, 1, 3);
            }
        }
    }

    static Scene sceneFor(Ways ways) {
        Scene scene = roughBox();
        scene.render.integrator = ways == Ways::All ? "whitted" : "ppm";
        scene.render.minWeight = 0;
        return scene;
    }
};

double relative(double actual, double expected) {
    return std::abs(actual - expected) / std::max(1e-6, std::abs(expected));
}

} // namespace

TEST_CASE("a bounce off rough and metallic surfaces is that of the reference") {
    const Ways ways = GENERATE(Ways::One, Ways::All);
    const RoughBounce b(ways);
    std::size_t rough = 0;
    std::size_t coated = 0;
    std::size_t choices = 0; // a random decision at its threshold, or a direction along the surface
    for (std::size_t i = 0; i < b.rays.size(); ++i) {
        if (!b.expected[i]) {
            continue;
        }
        const reference::Shading& expected = *b.expected[i];
        // Emission found by a path of density 1 or 2 is weighed against the light's own
        CHECK(distance(b.device->emitted.host()[i], expected.emitted) < 1e-5 * (1 + glm::length(expected.emitted)));
        const shared::VisiblePoint& v = b.device->visible.host()[i];
        REQUIRE((v.depth != 0) == expected.visible.has_value());
        if (expected.visible) {
            CHECK(glm::distance(fAt(b.both, v), reference::receiverAt(*expected.visible).f) < 1e-5);
            coated += (reference::bsdfFlags(*expected.visible->material) & shared::kBsdfLayered) != 0 ? 1 : 0;
        }
        const shared::RoughPoint& x = b.device->rough.host()[i];
        REQUIRE((x.depth != 0) == expected.rough.has_value());
        if (expected.rough) {
            ++rough;
            CHECK(x.depth == 1);
            CHECK(distance(x.position, expected.rough->surface.position) < 2e-5);
            CHECK(distance(x.beta, expected.rough->beta) < 1e-4);
            const reference::Lobe lobe = lobeAt(b.both, x);
            CHECK(std::abs(lobe.alpha - expected.rough->lobe.alpha) < 1e-6);
            CHECK(std::abs(lobe.eta - expected.rough->lobe.eta) < 1e-6);
        }
        const auto& next = expected.next[0];
        const std::size_t slot = b.device->slot(i, 0);
        const shared::Ray& ray = b.device->nextRays.host()[slot];
        if (b.device->goesOn(i) != next.has_value() ||
            (next && glm::dot(dvec3(ray.direction), next->ray.direction) < 0.99)) {
            ++choices;
            continue;
        }
        if (next) {
            const shared::CameraPath& path = b.device->nextPaths.host()[slot];
            const dvec3 normal = expected.rough ? expected.rough->surface.normal : dvec3(0);
            const double condition = conditioning(b.rays[i].direction, next->ray.direction, normal);
            CHECK(distance(ray.direction, next->ray.direction) * condition < kRoughError);
            CHECK(distance(path.beta, next->path.beta) * condition < kRoughError);
            CHECK((path.pdfW == 0) == (next->path.pdfW == 0));
            CHECK(relative(path.pdfW, next->path.pdfW) * condition < 10 * kRoughError);
        }
    }
    CHECK(rough > 5000);
    CHECK(coated > (ways == Ways::All ? 8000 : 4000));
    CHECK(choices <= 5);
}

TEST_CASE("rough points get the light of the reference's samples") {
    const Ways ways = GENERATE(Ways::One, Ways::All);
    RoughBounce b(ways);
    const auto count = static_cast<std::uint32_t>(b.rays.size());
    for (const std::uint32_t light : {shared::kNone, 0U, 1U, 2U}) { // a point, a quad, a sphere
        const auto direct = b.both.upload(std::vector<vec3>(count, vec3(0)));
        b.both.run("sample_rough_lights",
                   shared::SampleRoughLightsArguments{b.device->rough,
                                                      b.both.deviceScene.materials,
                                                      b.both.deviceScene.lights,
                                                      direct,
                                                      count,
                                                      light,
                                                      3,
                                                      b.both.deviceScene.rootNode,
                                                      {},
                                                      {},
                                                      {},
                                                      b.both.deviceScene.normals,
                                                      b.both.deviceScene.instances},
                   count);
        const auto one = light == shared::kNone ? std::nullopt : std::optional<std::uint32_t>(light);
        std::size_t lit = 0;
        std::size_t outliers = 0;
        for (std::uint32_t i = 0; i < count; ++i) { // the pixel of path i is i
            if (!b.expected[i] || !b.expected[i]->rough) {
                CHECK((!b.expected[i] || direct.host()[i] == vec3(0)));
                continue;
            }
            const auto sample = reference::sampleRoughLight(b.both.world, *b.expected[i]->rough, 3, one);
            const bool arrives = sample && reference::traceShadow(b.both.world, sample->from, sample->to);
            const dvec3 expected = arrives ? sample->contribution : dvec3(0);
            lit += glm::length(expected) > 1e-4 ? 1 : 0;
            outliers += distance(direct.host()[i], expected) > 1e-3 * glm::length(expected) + 1e-4 ? 1 : 0;
        }
        CHECK(lit > 500);
        // Past the edge of an occluder, on a horizon, and where both directions graze a small sphere
        CHECK(outliers <= lit / 100);
    }
}

} // namespace hyalite::testing
