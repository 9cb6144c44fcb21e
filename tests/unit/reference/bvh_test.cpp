// The tree must find exactly what a brute-force test of every primitive finds.
#include "reference/world.h"

#include "unit/reference/support.h"

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

Scene randomScene(int triangles, int others) {
    Random random;
    Scene scene;
    Mesh mesh;
    for (int i = 0; i < triangles; ++i) {
        const dvec3 centre = random.inCube(10);
        const auto first = static_cast<unsigned>(mesh.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.emplace_back(centre + random.inCube(0.5));
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }
    scene.meshes.push_back(mesh);
    addObject(scene, MeshInstance{}, std::nullopt);
    for (int i = 0; i < others; ++i) {
        addObject(scene, Sphere{random.inCube(10), random.between(0.1, 0.6)}, std::nullopt);
        addObject(scene, Quad{random.inCube(10), random.inCube(1), random.inCube(1)}, std::nullopt);
        // Axis-aligned and flat: its box has no thickness.
        addObject(scene, Quad{random.inCube(10), {1, 0, 0}, {0, 0, 1}}, std::nullopt);
    }
    return scene;
}

std::optional<Hit> askEveryPrimitive(const Scene& scene, const Ray& ray) {
    std::optional<Hit> nearest;
    const auto ask = [&](std::uint32_t object, std::uint32_t primitive, const std::optional<ShapeHit>& hit) {
        if (hit && (!nearest || hit->t < nearest->t)) {
            nearest = Hit{.t = hit->t, .object = object, .primitive = primitive, .u = hit->u, .v = hit->v};
        }
    };
    for (std::uint32_t object = 0; object < scene.objects.size(); ++object) {
        const Shape& shape = scene.objects[object].shape;
        if (const auto* sphere = std::get_if<Sphere>(&shape)) {
            ask(object, 0, intersectSphere(ray, *sphere));
        } else if (const auto* quad = std::get_if<Quad>(&shape)) {
            ask(object, 0, intersectQuad(ray, *quad));
        } else {
            const Mesh& mesh = scene.meshes.at(std::get<MeshInstance>(shape).mesh);
            for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
                const glm::uvec3& at = mesh.triangles[i];
                const Triangle triangle{{mesh.positions[at.x], mesh.positions[at.y], mesh.positions[at.z]}};
                ask(object, i, intersectTriangle(ray, triangle));
            }
        }
    }
    return nearest;
}

} // namespace

TEST_CASE("the tree finds the same nearest hit as a brute-force test of every triangle and object") {
    const Scene scene = randomScene(3000, 60);
    const World world = prepareWorld(scene);
    Random random;
    int hits = 0;
    for (int i = 0; i < 3000; ++i) {
        dvec3 direction = random.direction();
        if (i % 10 == 0) { // along an axis: two of the slabs are parallel to the ray
            direction = dvec3(0);
            direction[i / 10 % 3] = i % 20 == 0 ? 1 : -1;
        }
        const Ray ray{.origin = random.inCube(12), .direction = direction};
        const auto expected = askEveryPrimitive(scene, ray);
        const auto actual = traceClosest(world, ray);
        REQUIRE(actual.has_value() == expected.has_value());
        if (expected) {
            ++hits;
            CHECK(actual->t == expected->t);
            CHECK(actual->object == expected->object);
            CHECK(actual->primitive == expected->primitive);
            CHECK(actual->u == expected->u);
            CHECK(actual->v == expected->v);
        }
    }
    CHECK(hits > 300); // the scene is neither empty nor solid, so both answers were tested
    CHECK(hits < 2900);
}

TEST_CASE("a shadow ray is blocked exactly where a hit lies between its ends") {
    const Scene scene = randomScene(3000, 60);
    const World world = prepareWorld(scene);
    Random random;
    int blocked = 0;
    for (int i = 0; i < 3000; ++i) {
        const dvec3 from = random.inCube(11);
        const dvec3 to = random.inCube(11);
        const auto hit = askEveryPrimitive(scene, {.origin = from, .direction = (to - from) / glm::length(to - from)});
        const bool free = !hit || hit->t > glm::length(to - from);
        blocked += free ? 0 : 1;
        CHECK(traceShadow(world, from, to) == free);
    }
    CHECK(blocked > 300);
    CHECK(blocked < 2900);
}

TEST_CASE("of surfaces in the same place the first object is hit") {
    Scene scene;
    for (int i = 0; i < 9; ++i) { // more than a leaf holds
        addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, std::nullopt);
    }
    const auto hit = traceClosest(prepareWorld(scene), {.origin = {0.1, 0.2, 1}, .direction = {0, 0, -1}});
    REQUIRE(hit);
    CHECK(hit->object == 0);
}

TEST_CASE("nothing is hit in an empty scene") {
    Scene scene;
    scene.render.radius = 1; // its default is derived from the objects
    const World world = prepareWorld(scene);
    CHECK_FALSE(traceClosest(world, {.origin = {0, 0, 0}, .direction = {0, 0, 1}}));
    CHECK(traceShadow(world, {0, 0, 0}, {1, 1, 1}));
}
