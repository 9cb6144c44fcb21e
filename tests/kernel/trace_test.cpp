// trace_closest and trace_shadow against their twins, and against closed forms.
#include "kernel/kernel_support.h"

namespace hyalite::testing {

namespace {

std::vector<shared::Ray> raysInside(std::size_t count) {
    reference::test::Random random;
    std::vector<shared::Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 origin = random.inCube(0.99);
        rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
    }
    return rays;
}

std::vector<shared::Hit> trace(BothSides& both, const std::vector<shared::Ray>& rays) {
    const auto count = static_cast<std::uint32_t>(rays.size());
    const auto deviceRays = both.upload(rays);
    const auto hits = both.room<shared::Hit>(count);
    both.run("trace_closest", shared::TraceClosestArguments{deviceRays, hits, count, both.deviceScene.rootNode, 13, {}},
             count);
    return hits.read();
}

// At most `unlike` rays may hit another object than in the reference: those that pass an edge within rounding.
void compareHits(BothSides& both, std::size_t count, std::size_t unlike) {
    const std::vector<shared::Ray> rays = raysInside(count);
    const std::vector<shared::Hit> hits = trace(both, rays);
    std::size_t different = 0;
    std::size_t hitCount = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto expected = reference::traceClosest(both.world, toReference(rays[i]));
        const std::uint32_t object = both.sceneObject(hits[i].object);
        if (object != (expected ? expected->object : shared::kNone)) {
            ++different;
            continue;
        }
        if (expected) {
            ++hitCount;
            // Grazing spheres and planes seen edge-on lose digits: t is compared to the length they are lost over
            const bool near = std::abs(double{hits[i].t} - expected->t) <= 1e-4 * std::max(1e-2, expected->t);
            different += near ? 0 : 1;
        }
    }
    CHECK(different <= unlike);
    CHECK(hitCount > count / 2);
}

} // namespace

TEST_CASE("rays among few objects hit what the reference hits") {
    BothSides both(reference::test::cornellBox());
    REQUIRE(both.deviceScene.specialization.at("kFewObjects") > 0);
    compareHits(both, 100000, 2);
}

TEST_CASE("rays through the hierarchies of objects and meshes hit what the reference hits") {
    BothSides both(crowdedBox());
    REQUIRE(both.deviceScene.specialization.at("kFewObjects") == 0);
    compareHits(both, 100000, 4);
}

TEST_CASE("a ray that misses every object reports a miss") {
    BothSides both(reference::test::cornellBox());
    // Away from the box, beside it, and towards it but too short
    const auto hits = trace(
        both, {{{0, 0, 3}, 3e38F, {0, 0, 1}, 0}, {{5, 0, 3}, 3e38F, {0, 0, -1}, 0}, {{0, 0, 3}, 3.9F, {0, 0, -1}, 0}});
    for (const shared::Hit& hit : hits) {
        CHECK(hit.object == shared::kNone);
    }
}

TEST_CASE("rays along the axes hit the boxes of the hierarchy") {
    // Directions with two zero components, where 1 / direction is infinite
    Scene scene = crowdedBox();
    BothSides both(scene);
    std::vector<shared::Ray> rays;
    for (std::size_t i = 8; i < 38; ++i) { // the thirty spheres, each hit at distance 5 - radius along every axis
        const auto& sphere = std::get<Sphere>(scene.objects[i].shape);
        for (int axis = 0; axis < 3; ++axis) {
            dvec3 direction(0);
            direction[axis] = 1;
            rays.push_back(
                toDevice({.origin = sphere.center - 0.5 * sphere.radius * direction, .direction = direction}));
        }
    }
    const auto hits = trace(both, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto expected = reference::traceClosest(both.world, toReference(rays[i]));
        REQUIRE(expected);
        CHECK(both.sceneObject(hits[i].object) == expected->object);
    }
}

TEST_CASE("no ray from inside a closed mesh escapes through its edges") {
    Scene scene = reference::test::cornellBox();
    scene.objects.erase(scene.objects.begin(), scene.objects.begin() + 5); // light and spheres stay, the walls go
    scene.meshes = {sphereMesh(16, false)};
    reference::test::addObject(scene, MeshInstance{0, glm::scale(glm::dmat4(1), dvec3(3, 2, 4))}, 0);
    BothSides both(scene);
    // From the centre straight at every corner and every middle of an edge, and at random
    std::vector<shared::Ray> rays = raysInside(200000);
    const Mesh& mesh = scene.meshes[0];
    for (const auto& triangle : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const dvec3 a = dvec3(mesh.positions[triangle[i]]) * dvec3(3, 2, 4);
            const dvec3 b = dvec3(mesh.positions[triangle[(i + 1) % 3]]) * dvec3(3, 2, 4);
            rays.push_back(toDevice({.origin = dvec3(0.01, 0.02, 0.03), .direction = glm::normalize(a)}));
            rays.push_back(toDevice({.origin = dvec3(0.01, 0.02, 0.03), .direction = glm::normalize(a + b)}));
        }
    }
    std::size_t escaped = 0;
    for (const shared::Hit& hit : trace(both, rays)) {
        escaped += hit.object == shared::kNone ? 1 : 0;
    }
    CHECK(escaped == 0);
}

TEST_CASE("shadow rays are blocked where they are in the reference") {
    BothSides both(crowdedBox());
    reference::test::Random random;
    const std::uint32_t count = 50000;
    std::vector<shared::Ray> rays;
    std::vector<bool> visible;
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 from = random.inCube(0.95);
        const vec3 to = random.inCube(0.95);
        const vec3 along = to - from;
        rays.push_back({from, glm::length(along), glm::normalize(along), 0});
        visible.push_back(reference::traceShadow(both.world, from, to));
    }
    rays.push_back({vec3(0), 0, vec3(0, 1, 0), 0}); // nothing to trace, nothing to add
    const auto deviceRays = both.upload(rays);
    const auto contributions = both.upload(std::vector<vec3>(count + 1, vec3(1, 2, 3)));
    const auto direct = both.upload(std::vector<vec3>(count + 1, vec3(10)));
    both.run(
        "trace_shadow",
        shared::TraceShadowArguments{
            deviceRays, contributions, direct, count + 1, both.deviceScene.rootNode, 13, {}, {}, {}, {}, {}, {}, {}},
        count + 1);
    std::size_t different = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec3 expected = visible[i] ? vec3(11, 12, 13) : vec3(10);
        different += direct.host()[i] == expected ? 0 : 1;
    }
    CHECK(different <= 2); // past an edge within rounding
    CHECK(direct.host()[count] == vec3(10));
}

} // namespace hyalite::testing
