// Requirements on every solid: crossings agree with membership, and rays leave without hitting it again.
#include "reference/shapes/solid.h"

#include "reference/bsdf/interface.h"
#include "reference/world.h"
#include "unit/reference/random_solids.h"

#include <cmath>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

// One solid of a kind, of a size and at a place between the smallest and the largest powers of ten.
Scene solidScene(Random& random, int kind, double size, double place) {
    Scene scene;
    scene.render.radius = 1;
    scene.meshes = {cubeMesh(), ballMesh()};
    Shape shape = randomSolid(random, kind, 0);
    const dvec3 at = random.inCube(place);
    const glm::dmat4 map = glm::scale(glm::translate(glm::dmat4(1), at), dvec3(size));
    if (auto* sphere = std::get_if<Sphere>(&shape)) {
        *sphere = {at, size * sphere->radius};
    } else if (auto* plane = std::get_if<Plane>(&shape)) {
        plane->point = at;
    } else if (auto* quadric = std::get_if<Quadric>(&shape)) {
        quadric->objectToWorld = map * quadric->objectToWorld;
    } else if (auto* torus = std::get_if<Torus>(&shape)) {
        torus->objectToWorld = map * torus->objectToWorld;
    } else {
        auto& instance = std::get<MeshInstance>(shape);
        instance.objectToWorld = map * instance.objectToWorld;
    }
    addObject(scene, shape, std::nullopt);
    return scene;
}

dvec3 placeOf(const Shape& shape) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) {
        return sphere->center;
    }
    if (const auto* plane = std::get_if<Plane>(&shape)) {
        return plane->point;
    }
    if (const auto* quadric = std::get_if<Quadric>(&shape)) {
        return dvec3(quadric->objectToWorld[3]);
    }
    if (const auto* torus = std::get_if<Torus>(&shape)) {
        return dvec3(torus->objectToWorld[3]);
    }
    return dvec3(std::get<MeshInstance>(shape).objectToWorld[3]);
}

} // namespace

TEST_CASE("the crossings of every solid agree with membership between them, and the nearest is the hit") {
    Random random;
    int between = 0;
    for (int i = 0; i < 24000; ++i) {
        const Scene scene = solidScene(random, i % kSolidKinds, 1, 10);
        const World world = prepareWorld(scene);
        const auto& solid = std::get<Solid>(world.geometry[0]);
        const Ray ray{.origin = placeOf(scene.objects[0].shape) + random.inCube(1.5), .direction = random.direction()};
        const Crossings list = crossingsOf(solid, ray);
        REQUIRE(list.size() % 2 == 0);
        std::optional<double> nearest;
        for (std::size_t k = 0; k <= list.size(); ++k) {
            const double from = std::max(k == 0 ? -10 : list[k - 1].at.t, -10.0);
            const double to = std::min(k == list.size() ? 10 : list[k].at.t, 10.0);
            if (k < list.size()) {
                CHECK(list[k].entering == (k % 2 == 0));
                CHECK((k == 0 || list[k - 1].at.t < list[k].at.t));
                if (!nearest && list[k].at.t > 0 && std::isfinite(list[k].at.t)) {
                    nearest = list[k].at.t;
                }
            }
            if (to - from > 1e-6) { // more than any rounding of where the surface is, also where the line grazes it
                CHECK(isInsideOf(solid, ray.origin + (from + to) / 2 * ray.direction) == (k % 2 == 1));
                ++between;
            }
        }
        const auto hit = traceClosest(world, ray);
        REQUIRE(hit.has_value() == nearest.has_value());
        if (hit) {
            CHECK_THAT(hit->t, WithinAbs(*nearest, 1e-12));
        }
    }
    CHECK(between > 30000);
}

TEST_CASE("rays that leave a solid's surface outwards are outside, inwards inside, at any size, place and angle") {
    // Outside, the next surface met is a front, inside a back: there is one unless the solid has no end.
    Random random;
    int left = 0;
    for (int i = 0; i < 48000; ++i) {
        const int kind = i % kSolidKinds;
        const double size = std::pow(10.0, random.between(-3, 3));
        const Scene scene = solidScene(random, kind, size, std::pow(10.0, random.between(-2, 4)));
        const World world = prepareWorld(scene);
        const dvec3 way = random.direction();
        const dvec3 target = placeOf(scene.objects[0].shape) + size * random.inCube(0.7);
        const Ray ray{.origin = target - way * size * random.between(2, 100), .direction = way};
        const auto hit = traceClosest(world, ray);
        if (!hit) {
            continue;
        }
        ++left;
        CAPTURE(i, kind, size, hit->primitive);
        const Surface surface = evaluateSurface(world, ray, *hit);
        const dvec3 outwards = surface.front ? surface.geometricNormal : -surface.geometricNormal;
        dvec3 out = random.direction();
        if (i % 5 == 0) { // nearly along the surface
            out = glm::normalize(out - glm::dot(out, outwards) * outwards + 1e-7 * outwards);
        }
        out = glm::dot(out, outwards) < 0 ? reflect(out, outwards) : out;
        const Ray outside{.origin = leave(surface, out), .direction = out};
        if (const auto next = traceClosest(world, outside)) {
            CHECK(evaluateSurface(world, outside, *next).front);
        }
        const Ray inside{.origin = leave(surface, -out), .direction = -out};
        const auto next = traceClosest(world, inside);
        REQUIRE((next.has_value() || kind == kSolidKinds - 1));
        if (next) {
            CHECK_FALSE(evaluateSurface(world, inside, *next).front);
        }
    }
    CHECK(left > 20000);
}
