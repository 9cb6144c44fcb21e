// Rays within a closed solid of mirrors stay there: no escape in ten reflections of each.
#include "kernel/kernel_support.h"
#include "support/random_shapes.h"
#include "support/thorough.h"

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kMany = 1000000; // with the reflections, ten million
constexpr std::uint32_t kFewer = 200000;
constexpr int kReflections = 10;

Scene mirrored(const Shape& shape) {
    Scene scene;
    scene.lights.push_back({.position = {0, 9, 0}, .intensity = dvec3(1)});
    const std::size_t mirror = reference::test::addMaterial(scene, Mirror{});
    reference::test::addObject(scene, shape, mirror);
    return scene;
}

std::vector<shared::Ray> raysInside(const BothSides& both, std::uint32_t count) {
    Random random;
    std::vector<shared::Ray> rays;
    while (rays.size() < count) {
        const dvec3 origin(vec3(random.inCube(2.5)));
        // Not so near the surface that a float could not tell: one of six steps along the axes would cross it
        bool isDeep = true;
        for (int i = 0; i < 6 && isDeep; ++i) {
            dvec3 step(0);
            step[i / 2] = i % 2 == 0 ? 1e-5 : -1e-5;
            isDeep = reference::isInside(both.world, 0, origin + step);
        }
        for (int i = 0; i < 8 && isDeep && rays.size() < count; ++i) {
            rays.push_back(toDevice({.origin = origin, .direction = random.direction()}));
        }
    }
    return rays;
}

std::size_t countEscapes(Scene scene, std::uint32_t count) {
    BothSides both(std::move(scene));
    const auto& d = both.deviceScene;
    auto rays = both.upload(raysInside(both, count));
    auto nextRays = both.room<shared::Ray>(count);
    const auto hits = both.room<shared::Hit>(count);
    const auto paths = both.upload(std::vector<shared::CameraPath>(count, {vec3(1), 0, 0, shared::kNone, 0}));
    const auto points = both.room<shared::VisiblePoint>(count);
    const auto emitted = both.room<vec3>(count);
    const auto nextPaths = both.room<shared::CameraPath>(count);
    const auto alive = both.room<shared::uint>(count);
    std::size_t escapes = 0;
    for (int i = 0; i < kReflections; ++i) {
        both.run("trace_closest", shared::TraceClosestArguments{rays, hits, count, d.rootNode, 0, {}}, count);
        both.run("shade_surface",
                 shared::ShadeSurfaceArguments{rays,
                                               hits,
                                               paths,
                                               d.materials,
                                               d.lights,
                                               d.normals,
                                               d.instances,
                                               points,
                                               emitted,
                                               nextRays,
                                               nextPaths,
                                               alive,
                                               count,
                                               1,
                                               255,
                                               0,
                                               {},
                                               0,
                                               {}},
                 count);
        for (std::uint32_t ray = 0; ray < count; ++ray) {
            if (hits.host()[ray].object == shared::kNone) {
                ++escapes;
                nextRays.host()[ray] = rays.host()[0]; // goes on as another one
            }
        }
        std::swap(rays, nextRays);
    }
    return escapes;
}

void checkNoEscape(const std::string& name, Scene scene, std::uint32_t count) {
    const std::size_t escapes = countEscapes(std::move(scene), count);
    INFO(name << ": " << escapes << " of " << kReflections * std::size_t{count} << " rays escaped");
    CHECK(escapes == 0);
}

// A cube rounded by a sphere, with a cylinder drilled out along each axis.
Scene drilledCube() {
    Scene scene = mirrored(Sphere{});
    const double big = 3;
    const auto cylinder = [&](int axis) {
        QuadricForm form{.a = 1, .e = 1, .h = 1, .j = -0.16};
        (axis == 0 ? form.a : axis == 1 ? form.e : form.h) = 0;
        Bounds clip{dvec3(-0.5), dvec3(0.5)};
        clip.low[axis] = -big;
        clip.high[axis] = big;
        return Quadric{.form = form, .clip = clip, .capped = true, .objectToWorld = dmat4(1)};
    };
    const auto addLeaf = [&](const Shape& shape) {
        scene.csgLeaves.push_back({.shape = shape, .material = 0, .emission = dvec3(0), .where = {}});
    };
    addLeaf(Quadric{.form = {.j = -1}, .clip = {dvec3(-0.7), dvec3(0.7)}, .capped = true, .objectToWorld = dmat4(1)});
    addLeaf(Sphere{dvec3(0), 0.95});
    addLeaf(cylinder(0));
    addLeaf(cylinder(1));
    addLeaf(cylinder(2));
    using enum CsgStep;
    scene.objects[0].shape = Csg{0, {Leaf, Leaf, Intersection, Leaf, Leaf, Union, Leaf, Union, Difference}};
    return scene;
}

} // namespace

TEST_CASE("no ray escapes from inside a sphere, quadric or torus", "[escape]") {
    Random random;
    checkNoEscape("sphere", mirrored(Sphere{{0.3, -0.2, 0.1}, 1.1}), manyRays(kFewer));
    for (const NamedForm& named : namedForms()) {
        checkNoEscape(std::string(named.name), mirrored(quadric(named, randomPlacement(random, 0.7, 0.2))),
                      manyRays(kFewer));
    }
    checkNoEscape("torus", mirrored(Torus{1, 0.35, randomPlacement(random, 0.7, 0.2)}), manyRays(kFewer));
}

TEST_CASE("no ray escapes from inside a closed mesh", "[escape]") {
    Random random;
    Scene scene = mirrored(MeshInstance{0, randomPlacement(random, 0.9, 0.2)});
    scene.meshes = {sphereMesh(32, false)};
    checkNoEscape("mesh", scene, manyRays(kMany));
}

TEST_CASE("no ray escapes from inside a CSG solid", "[escape]") {
    checkNoEscape("drilled cube", drilledCube(), manyRays(kMany));

    // The same with a mesh for the ball
    Random random;
    Scene meshed = drilledCube();
    meshed.meshes = {sphereMesh(32, false)};
    meshed.csgLeaves[1].shape = MeshInstance{0, glm::scale(dmat4(1), dvec3(0.95))};
    checkNoEscape("drilled cube with a mesh", meshed, manyRays(kMany));
}

} // namespace hyalite::testing
