// shade_surface and trace_whitted against their twins.
#include "kernel/bounce.h"
#include "kernel/visible_points.h"

namespace hyalite::testing {

namespace {

// Positions are right to a few 1e-7 of coordinates up to 10 (a mesh at scale 0.1, in its own space); so are directions
// and reflectances, once their conditioning is taken out.
constexpr double kScatterError = 2e-5;

void compareChild(const reference::NextRay& expected, const dvec3& arriving, const dvec3& normal, const Bounce& b,
                  std::size_t slot) {
    const shared::Ray& ray = b.nextRays.host()[slot];
    const shared::CameraPath& path = b.nextPaths.host()[slot];
    const double condition = conditioning(arriving, expected.ray.direction, normal);
    CHECK(distance(ray.direction, expected.ray.direction) * condition < kScatterError);
    CHECK(distance(ray.origin, expected.ray.origin) < 2e-5);
    CHECK(distance(path.beta, expected.path.beta) * condition < kScatterError);
    CHECK(path.samplerSeed == expected.path.samplerSeed);
}

// What the reference adds to the emission at a visible point, from every lamp.
dvec3 lightOn(const BothSides& both, const std::optional<reference::VisiblePoint>& x, std::uint32_t pass) {
    dvec3 sum(0);
    for (std::uint32_t lamp = 0; x && lamp < both.world.lights.size(); ++lamp) {
        const auto sample = reference::sampleLight(both.world, *x, pass, lamp);
        if (sample && reference::traceShadow(both.world, sample->from, sample->to)) {
            sum += sample->contribution;
        }
    }
    return sum;
}

// Rays from all over the room; those that would not hit the same object are left out, they are trace_test's matter.
void compareShading(Scene scene, Ways ways, std::uint32_t depth) {
    scene.render.integrator = ways == Ways::All ? "whitted" : "ppm";
    BothSides both(scene);
    reference::test::Random random;
    const std::size_t count = 20000;
    std::vector<shared::Ray> rays;
    std::vector<shared::CameraPath> paths;
    for (std::uint32_t i = 0; i < count; ++i) {
        const dvec3 origin = random.inCube(0.99);
        rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
        paths.push_back({vec3(0.5, 0.25, 1), i, shared::hash(i), shared::kNone, 0});
    }
    const std::uint32_t pass = 3;
    const Bounce b = shade(both, rays, paths, depth, pass, ways);

    std::size_t compared = 0;
    std::size_t choices = 0; // a coin that falls on the other side of a reflectance that is right to rounding
    std::size_t lit = 0;
    std::size_t edges = 0; // shadow rays past an edge
    for (std::size_t i = 0; i < count; ++i) {
        const reference::Ray ray = toReference(rays[i]);
        const auto hit = reference::traceClosest(both.world, ray);
        if (!hit || hit->object != both.sceneObject(b.hits.host()[i].object)) {
            CHECK((hit || !b.goesOn(i)));
            continue;
        }
        ++compared;
        const reference::CameraPath path{dvec3(paths[i].beta), paths[i].samplerSeed};
        const dvec3 normal = reference::evaluateSurface(both.world, ray, *hit).normal;
        const auto expected = reference::shadeSurface(both.world, ray, *hit, path, depth, pass);
        CHECK(distance(b.emitted.host()[i], expected.emitted) < 1e-5);
        const shared::VisiblePoint& v = b.visible.host()[i];
        REQUIRE((v.depth != 0) == expected.visible.has_value());
        if (expected.visible) {
            CHECK(v.depth == depth);
            CHECK(v.pixel == i);
            CHECK(v.samplerSeed == expected.visible->samplerSeed);
            CHECK(distance(v.position, expected.visible->position) < 2e-5);
            CHECK(distance(v.normal, expected.visible->normal) < 2e-4);
            CHECK(glm::distance(fAt(both, v), reference::receiverAt(*expected.visible).f) < 1e-6);
        }
        const std::vector<reference::NextRay> next = waysOf(expected);
        REQUIRE(b.alive.host()[i] == next.size());
        for (std::size_t child = 0; child < next.size(); ++child) {
            const std::size_t slot = b.slot(i, child);
            if (ways == Ways::One &&
                glm::dot(dvec3(b.nextRays.host()[slot].direction), next[child].ray.direction) < 0.99) {
                ++choices;
                continue;
            }
            compareChild(next[child], ray.direction, normal, b, slot);
        }
        if (ways == Ways::All) {
            const dvec3 direct = lightOn(both, expected.visible, pass);
            edges += distance(b.light.host()[i], expected.emitted + direct) > 2e-5 * (1 + glm::length(direct)) ? 1 : 0;
            lit += direct != dvec3(0) ? 1 : 0;
        }
    }
    CHECK(compared > count * 3 / 4); // the rest leave by the open side
    CHECK(choices <= 2);
    CHECK((lit > count / 10 || ways == Ways::One));
    CHECK(edges <= 10);
}

} // namespace

TEST_CASE("one bounce of a camera path that chooses is that of the reference") {
    compareShading(reference::test::cornellBox(), Ways::One, 1);
}

TEST_CASE("one bounce that follows both reflection and refraction is that of the reference") {
    compareShading(reference::test::cornellBox(), Ways::All, 1);
}

TEST_CASE("meshes, smooth and mirrored ones too, shade as in the reference") {
    compareShading(crowdedBox(), Ways::All, 1);
}

TEST_CASE("no path goes on from the last bounce") {
    Scene scene = reference::test::cornellBox();
    scene.render.maxDepth = 4;
    compareShading(scene, Ways::One, 4);
}

TEST_CASE("a ray in glass beyond the critical angle is totally reflected") {
    // A sphere of ior 1.5, a ray inside it that meets the surface at 60 degrees; the critical angle is asin(1/1.5)
    // = 41.8
    Scene scene = reference::test::cornellBox();
    scene.objects = {};
    reference::test::addObject(scene, Quad{{9, 9, 9}, {1, 0, 0}, {0, 1, 0}}, std::nullopt, dvec3(1));
    reference::test::addObject(scene, Sphere{{0, 0, 0}, 1}, 4);
    BothSides both(scene);
    // From (0, sin 60, 0) along x the ray meets the sphere at (cos 60, sin 60, 0); n = -(cos 60, sin 60, 0):
    // d - 2 (n.d) n = (1, 0) - 2 * 0.5 * (0.5, sin 60) = (0.5, -sin 60)
    const double s = std::sqrt(3.0) / 2;
    const std::vector<shared::Ray> rays{{vec3(0, s, 0), 3e38F, vec3(1, 0, 0), 0}};
    const Bounce b = shade(both, rays, {{vec3(1), 0, 1, shared::kNone, 0}}, 1, 0, Ways::All);
    REQUIRE(b.alive.host()[0] == 1); // nothing is refracted
    CHECK(distance(b.nextRays.host()[0].direction, dvec3(0.5, -s, 0)) < 1e-6);
    CHECK(b.nextPaths.host()[0].beta == vec3(1));
}

TEST_CASE("a ray that leaves a quad or a sphere does not hit it again at once") {
    // Oblique surfaces of all sizes, near the origin and away from it; neither a plane nor a ball from outside can be
    // met again by a ray that goes to the side it came from
    Scene scene = reference::test::cornellBox();
    scene.objects.resize(6); // walls and light
    reference::test::Random random;
    for (int i = 0; i < 60; ++i) {
        const dvec3 place = random.inCube(0.9);
        const double size = std::pow(10.0, random.between(-2, 0));
        if (i % 2 == 0) {
            reference::test::addObject(scene, Quad{place, size * random.direction(), size * random.direction()}, 0);
        } else {
            reference::test::addObject(scene, Sphere{place, 0.3 * size}, 0);
        }
    }
    BothSides both(scene);
    const std::uint32_t count = 200000;
    std::vector<shared::Ray> rays;
    for (std::uint32_t i = 0; i < count; ++i) {
        rays.push_back(toDevice({.origin = random.inCube(0.95), .direction = random.direction()}));
    }
    const Bounce b =
        shade(both, rays, std::vector<shared::CameraPath>(count, {vec3(1), 0, 1, shared::kNone, 0}), 1, 0, Ways::All);
    std::vector<shared::Ray> leaving;
    std::vector<std::uint32_t> from;
    for (std::uint32_t i = 0; i < count; ++i) {
        const shared::VisiblePoint& x = b.visible.host()[i];
        const dvec3 outward = x.normal;
        const dvec3 direction = random.direction();
        const bool inside = x.depth == 0 || glm::dot(direction, outward) < 1e-3; // none, or along the surface
        const auto& shape =
            x.depth == 0 ? scene.objects[0].shape : scene.objects[both.sceneObject(b.hits.host()[i].object)].shape;
        const auto* sphere = std::get_if<Sphere>(&shape);
        const bool withinBall = sphere != nullptr && glm::dot(dvec3(x.position) - sphere->center, outward) < 0;
        if (!inside && !withinBall) {
            leaving.push_back({x.position, 3e38F, direction, x.from});
            from.push_back(b.hits.host()[i].object);
        }
    }
    const auto leavingCount = static_cast<std::uint32_t>(leaving.size());
    const auto deviceRays = both.upload(leaving);
    const auto hits = both.room<shared::Hit>(leavingCount);
    both.run("trace_closest",
             shared::TraceClosestArguments{deviceRays, hits, leavingCount, both.deviceScene.rootNode, 0, {}},
             leavingCount);
    std::size_t again = 0;
    for (std::uint32_t i = 0; i < leavingCount; ++i) {
        again += hits.host()[i].object == from[i] ? 1 : 0;
    }
    CHECK(leavingCount > count / 3);
    CHECK(again == 0);
}

} // namespace hyalite::testing
