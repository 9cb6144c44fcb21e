// Surfaces at hits: normals and sides, meshes under transforms, rays that leave without hitting where they started;
// and the camera's rays.
#include "reference/world.h"

#include "reference/bsdf/interface.h"
#include "unit/reference/support.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

Surface surfaceAlong(const World& world, const Ray& ray) {
    const auto hit = traceClosest(world, ray);
    REQUIRE(hit);
    return evaluateSurface(world, ray, *hit);
}

Mesh oneTriangle() {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

} // namespace

TEST_CASE("a sphere's normal is turned to the side the ray comes from and the side is kept") {
    Scene scene;
    addObject(scene, Sphere{{1, 2, 3}, 2}, std::nullopt);
    const World world = prepareWorld(scene);
    const Surface outside = surfaceAlong(world, {.origin = {1, 2, 10}, .direction = {0, 0, -1}});
    CHECK(outside.front);
    checkNear(outside.position, {1, 2, 5}, 1e-14);
    checkNear(outside.normal, {0, 0, 1}, 1e-15);
    const Surface inside = surfaceAlong(world, {.origin = {1, 2, 3}, .direction = {0, 0, 1}});
    CHECK_FALSE(inside.front);
    checkNear(inside.position, {1, 2, 5}, 1e-14);
    checkNear(inside.normal, {0, 0, -1}, 1e-15);
    CHECK(inside.material == nullptr);
}

TEST_CASE("a quad emits on its front, edge0 x edge1, only") {
    Scene scene;
    addObject(scene, Quad{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, std::nullopt, {1, 2, 3}); // x cross y = z
    const World world = prepareWorld(scene);
    CHECK(surfaceAlong(world, {.origin = {0, 0, 1}, .direction = {0, 0, -1}}).emission == dvec3(1, 2, 3));
    CHECK(surfaceAlong(world, {.origin = {0, 0, -1}, .direction = {0, 0, 1}}).emission == dvec3(0));
}

TEST_CASE("a mesh is where its transform puts it, with its front as in the file") {
    // Scaled by 2 in x, mirrored in z, moved to z = 4. Counter-clockwise about +z becomes a front towards -z.
    Scene scene;
    scene.meshes = {oneTriangle()};
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), dvec3(0, 0, 4));
    addObject(scene, MeshInstance{.mesh = 0, .objectToWorld = glm::scale(moved, dvec3(2, 1, -1))}, std::nullopt);
    const World world = prepareWorld(scene);
    const Ray ray{.origin = {1, 0.25, 0}, .direction = {0, 0, 1}};
    const auto hit = traceClosest(world, ray);
    REQUIRE(hit);
    CHECK(hit->t == 4);
    CHECK(hit->u == 0.5);  // x = 1 = 2 u
    CHECK(hit->v == 0.25); // y
    const Surface surface = evaluateSurface(world, ray, *hit);
    CHECK(surface.front);
    checkNear(surface.geometricNormal, {0, 0, -1}, 1e-15);
    checkNear(surface.position, {1, 0.25, 4}, 1e-15);
}

TEST_CASE("shading normals are interpolated, transformed by the inverse transpose, and turned with the side") {
    Scene scene;
    scene.meshes = {oneTriangle()};
    const float h = std::sqrt(0.5F);
    scene.meshes[0].normals = {{0, 0, 1}, {h, 0, h}, {0, 0, 1}};
    const glm::dmat4 stretched = glm::scale(glm::dmat4(1), dvec3(2, 1, 1));
    addObject(scene, MeshInstance{.mesh = 0, .objectToWorld = stretched}, std::nullopt);
    const World world = prepareWorld(scene);
    // Halfway along the first edge the mesh's normal is along (0, 0, 1) + (h, 0, h) with h = 1 / sqrt 2; the inverse
    // transpose halves x: (h / 2, 0, 1 + h), along (1, 0, 2 + 2 sqrt 2).
    const dvec3 expected = glm::normalize(dvec3(1, 0, 2 + 2 * std::sqrt(2.0)));
    const Surface front = surfaceAlong(world, {.origin = {1, 0, 1}, .direction = {0, 0, -1}});
    checkNear(front.normal, expected, 1e-7); // the file's normals are single precision
    checkNear(front.geometricNormal, {0, 0, 1}, 1e-15);
    const Surface back = surfaceAlong(world, {.origin = {1, 0, -1}, .direction = {0, 0, 1}});
    checkNear(back.normal, -expected, 1e-7);
    checkNear(back.geometricNormal, {0, 0, -1}, 1e-15);
}

TEST_CASE("a ray that leaves a surface does not hit it where it started, at any size, place and angle") {
    Random random;
    int left = 0;
    for (int i = 0; i < 20000; ++i) {
        const double size = std::pow(10.0, random.between(-3, 3));
        const dvec3 place = random.inCube(std::pow(10.0, random.between(-2, 4)));
        Scene scene;
        const int kind = i % 3;
        if (kind == 0) {
            addObject(scene, Sphere{place, size}, std::nullopt);
        } else if (kind == 1) {
            addObject(scene, Quad{place, size * random.direction(), size * random.direction()}, std::nullopt);
        } else {
            Mesh mesh;
            mesh.positions = {glm::vec3(random.direction()), glm::vec3(random.direction()),
                              glm::vec3(random.direction())};
            mesh.triangles = {{0, 1, 2}};
            scene.meshes = {mesh};
            const glm::dmat4 toWorld = glm::scale(glm::translate(glm::dmat4(1), place), dvec3(size));
            addObject(scene, MeshInstance{.mesh = 0, .objectToWorld = toWorld}, std::nullopt);
        }
        const World world = prepareWorld(scene);
        // Aim at a point of the shape from far or near.
        dvec3 target = place;
        if (kind == 1) {
            const auto& quad = std::get<Quad>(scene.objects[0].shape);
            target = pointOnQuad({random.unit(), random.unit()}, quad);
        } else if (kind == 2) {
            const auto& corners = scene.meshes[0].positions;
            target = place + size * dvec3(corners[0] + corners[1] + corners[2]) / 3.0;
        }
        const dvec3 way = random.direction();
        const Ray ray{.origin = target - way * size * random.between(1.5, 100), .direction = way};
        const auto hit = traceClosest(world, ray);
        if (!hit) {
            continue; // edge on
        }
        ++left;
        const Surface surface = evaluateSurface(world, ray, *hit);
        dvec3 out = random.direction();
        if (i % 5 == 0) { // nearly along the surface
            out = glm::normalize(out - glm::dot(out, surface.geometricNormal) * surface.geometricNormal +
                                 1e-7 * surface.geometricNormal);
        }
        out = glm::dot(out, surface.geometricNormal) < 0 ? reflect(out, surface.geometricNormal) : out;
        CHECK_FALSE(traceClosest(world, {.origin = leave(surface, out), .direction = out}));
    }
    CHECK(left > 19000);
}

TEST_CASE("a ray that enters a sphere hits its far side") {
    Random random;
    for (int i = 0; i < 5000; ++i) {
        const double radius = std::pow(10.0, random.between(-3, 3));
        const dvec3 centre = random.inCube(1000);
        Scene scene;
        addObject(scene, Sphere{centre, radius}, std::nullopt);
        const World world = prepareWorld(scene);
        const dvec3 way = random.direction();
        const Surface surface = surfaceAlong(world, {.origin = centre - 3 * radius * way, .direction = way});
        const dvec3 in = glm::normalize(way + 0.9 * random.direction());
        const auto exit = traceClosest(world, {.origin = leave(surface, in), .direction = in});
        REQUIRE(exit);
        // The chord through a point of the sphere at angle a to the normal has length 2 r cos a.
        CHECK_THAT(exit->t, WithinAbs(-2 * radius * glm::dot(in, surface.geometricNormal), 1e-10 * (1000 + radius)));
    }
}

TEST_CASE("camera rays pass through their own pixel, the first row on top") {
    Scene scene;
    scene.camera = {.position = {0, 0, 4}, .lookAt = {0, 0, 0}, .up = {0, 1, 0}, .fov = 90, .resolution = {4, 2}};
    const World world = prepareWorld(scene);
    // fov 90: the image plane at distance 1 spans y in [-1, 1] and x in [-2, 2]; a pixel is 1 x 1.
    for (std::uint32_t pixel = 0; pixel < 8; ++pixel) {
        const std::uint32_t row = pixel / 4;
        const double left = pixel % 4 - 2.0;
        const double top = 1.0 - row;
        dvec2 sum(0);
        for (std::uint32_t pass = 0; pass < 64; ++pass) {
            const Ray ray = generateCameraRay(world, pixel, pass);
            CHECK(ray.origin == dvec3(0, 0, 4));
            CHECK_THAT(glm::length(ray.direction), WithinAbs(1, 1e-15));
            const dvec2 point(ray.direction.x / -ray.direction.z, ray.direction.y / -ray.direction.z);
            CHECK(point.x >= left - 1e-12);
            CHECK(point.x <= left + 1 + 1e-12);
            CHECK(point.y <= top + 1e-12);
            CHECK(point.y >= top - 1 - 1e-12);
            sum += point;
        }
        // 64 Sobol points have one in every 64th of either axis: their mean is within 1/128 of the pixel's centre.
        CHECK_THAT(sum.x / 64, WithinAbs(left + 0.5, 1.0 / 128));
        CHECK_THAT(sum.y / 64, WithinAbs(top - 0.5, 1.0 / 128));
    }
}

TEST_CASE("a camera that looks along its up direction is refused") {
    Scene scene;
    scene.camera.up = {0, 0, 1};
    CHECK_THROWS_AS(prepareWorld(scene), Error);
}
