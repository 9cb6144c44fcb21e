// Random CSG trees of all shapes: trace_closest against the reference, and both against point membership.
#include "kernel/kernel_support.h"
#include "support/random_shapes.h"
#include "support/thorough.h"

#include "base/parallel.h"

#include <atomic>

namespace hyalite::testing {

namespace {

constexpr double kSpacing = 8; // trees reach 3 from their places [m]

// A box of trees, kPerScene of them apart from each other, each of 1 to 32 leaves.
constexpr std::size_t kPerScene = 125; // five along each axis

std::size_t raysPerTree() {
    return manyRays(1000);
}

dvec3 placeOf(std::size_t tree) {
    return kSpacing * (dvec3(tree % 5, tree / 5 % 5, tree / 25) - 2.0);
}

// Moves a solid that was made about the origin.
void move(Shape& shape, const dvec3& by) {
    const dmat4 map = glm::translate(dmat4(1), by);
    if (auto* sphere = std::get_if<Sphere>(&shape)) {
        sphere->center += by;
    } else if (auto* plane = std::get_if<Plane>(&shape)) {
        plane->point += by;
    } else if (auto* form = std::get_if<Quadric>(&shape)) {
        form->objectToWorld = map * form->objectToWorld;
    } else if (auto* torus = std::get_if<Torus>(&shape)) {
        torus->objectToWorld = map * torus->objectToWorld;
    } else {
        auto& mesh = std::get<MeshInstance>(shape);
        mesh.objectToWorld = map * mesh.objectToWorld;
    }
}

void addTree(Scene& scene, Random& random, const dvec3& place, std::size_t leaves) {
    Csg csg{.firstLeaf = scene.csgLeaves.size(), .program = {}};
    const auto makeLeaf = [&] {
        const bool isMesh = random.unit() < 0.1;
        Shape shape = isMesh ? Shape(MeshInstance{random.unit() < 0.5 ? 0U : 1U, randomPlacement(random, 0.8, 0.8)})
                             : randomSolid(random, 0.8, 0.8);
        move(shape, place);
        scene.csgLeaves.push_back({.shape = shape, .material = 0, .emission = dvec3(0), .where = {}});
    };
    appendTree(random, leaves, makeLeaf, csg.program);
    // Within a ball, so that trees with half-spaces have an end too
    csg.program.push_back(CsgStep::Leaf);
    csg.program.push_back(CsgStep::Intersection);
    scene.csgLeaves.push_back({.shape = Sphere{place, 3}, .material = 0, .emission = dvec3(0), .where = {}});
    reference::test::addObject(scene, csg, 0);
}

Scene treesScene(Random& random) {
    Scene scene;
    scene.lights.push_back({.position = {0, 9, 0}, .intensity = dvec3(1)});
    reference::test::addMaterial(scene, Diffuse{});
    scene.meshes = {sphereMesh(8, false), sphereMesh(5, true)};
    for (std::size_t tree = 0; tree < kPerScene; ++tree) {
        const auto leaves = 1 + static_cast<std::size_t>(31 * random.unit() * random.unit());
        addTree(scene, random, placeOf(tree), leaves);
    }
    return scene;
}

// From within and around each tree, in any direction, as far as its neighbours.
std::vector<shared::Ray> raysAtTrees(Random& random) {
    std::vector<shared::Ray> rays;
    for (std::size_t i = 0; i < kPerScene * raysPerTree(); ++i) {
        const dvec3 place = placeOf(i / raysPerTree());
        const dvec3 origin = place + random.inCube(3);
        const dvec3 target = place + random.inCube(1.5);
        shared::Ray ray = toDevice({.origin = origin, .direction = glm::normalize(target - origin)});
        ray.tMax = 4;
        rays.push_back(ray);
    }
    return rays;
}

// See csg.glsl: crossings nearer together than this are one place.
double placeLength(const reference::Ray& ray, double t) {
    const dvec3 o = glm::abs(ray.origin);
    return 0x1p-18 * std::max({t, o.x, o.y, o.z});
}

struct Tally {
    std::atomic<std::size_t> hits = 0;
    std::atomic<std::size_t> unlike = 0;          // hit or miss, leaf, or distance
    std::atomic<std::size_t> unlikeElsewhere = 0; // of these, those without an edge, a graze or a second face nearby
    std::atomic<std::size_t> sameSides = 0;       // hits before and after which the point is on the same side
    std::atomic<std::size_t> thin = 0; // hits where that takes a closer look, another surface being very near
};

bool isInside(const BothSides& both, const reference::Ray& ray, std::uint32_t object, double t) {
    return reference::isInside(both.world, object, ray.origin + t * ray.direction);
}

// Point membership on both sides of a hit, near enough that no other surface lies between, if there is such a distance.
void checkSides(const BothSides& both, const reference::Ray& ray, std::uint32_t object, double t, Tally& tally) {
    const double length = placeLength(ray, t);
    for (const double step : {4.0, 1.5, 1.0, 0.3, 0.1}) {
        if (isInside(both, ray, object, t - step * length) != isInside(both, ray, object, t + step * length)) {
            return;
        }
        tally.thin += step == 4.0 ? 1 : 0;
    }
    ++tally.sameSides;
}

// Within rounding of the ray there is another answer: the ray passes an edge or a silhouette, or two faces nearly meet.
bool isUnstable(const BothSides& both, const reference::Ray& ray, const std::optional<reference::Hit>& expected) {
    const double shift = 2 * placeLength(ray, expected ? expected->t : 4);
    Random random;
    for (int i = 0; i < 64; ++i) {
        reference::Ray shifted = ray;
        shifted.origin += shift * random.direction();
        const auto other = reference::traceClosest(both.world, shifted);
        if (other.has_value() != expected.has_value() ||
            (other && (other->leaf != expected->leaf || other->primitive != expected->primitive ||
                       std::abs(other->t - expected->t) > 10 * shift))) {
            return true;
        }
    }
    return false;
}

// How far apart t may be: eight roundings of coordinates up to 20, over the cosine; see shapes_test.cpp.
double allowedError(const BothSides& both, const reference::Ray& ray, const reference::Hit& hit) {
    const reference::Surface surface = reference::evaluateSurface(both.world, ray, hit);
    return 20 * 0x1p-21 / std::abs(glm::dot(ray.direction, surface.geometricNormal));
}

void compareRay(const BothSides& both, const shared::Ray& deviceRay, const shared::Hit& hit, Tally& tally) {
    const reference::Ray ray = toReference(deviceRay);
    const auto expected = reference::traceClosest(both.world, ray);
    const bool hits = hit.object != shared::kNone;
    if (hits) {
        ++tally.hits;
        checkSides(both, ray, both.sceneObject(hit.object), double{hit.t}, tally);
    }
    if (expected) {
        checkSides(both, ray, expected->object, expected->t, tally);
    }
    const bool alike = hits == expected.has_value() &&
                       (!hits || (both.deviceScene.leafOf[hit.object] == expected->leaf &&
                                  std::abs(double{hit.t} - expected->t) <= allowedError(both, ray, *expected)));
    if (!alike) {
        ++tally.unlike;
        if (!isUnstable(both, ray, expected)) {
            UNSCOPED_INFO("device t " << hit.t << ", reference t " << (expected ? expected->t : 0) << ", origin "
                                      << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z);
            ++tally.unlikeElsewhere;
        }
    }
}

void compareTrees(std::size_t trees) {
    Random random;
    Tally tally;
    for (std::size_t done = 0; done < trees; done += kPerScene) {
        BothSides both(treesScene(random));
        const std::vector<shared::Ray> rays = raysAtTrees(random);
        const auto count = static_cast<std::uint32_t>(rays.size());
        const auto deviceRays = both.upload(rays);
        const auto hits = both.room<shared::Hit>(count);
        both.run("trace_closest",
                 shared::TraceClosestArguments{deviceRays, hits, count, both.deviceScene.rootNode, 0, {}}, count);
        const std::vector<shared::Hit> found = hits.read();
        parallelFor(rays.size(), 1024, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                compareRay(both, rays[i], found[i], tally);
            }
        });
    }
    const auto rayCount = static_cast<double>(trees * raysPerTree());
    INFO(rayCount << " rays, " << tally.hits << " hits, " << tally.unlike << " unlike, " << tally.unlikeElsewhere
                  << " elsewhere, " << tally.sameSides << " same sides, " << tally.thin << " thin");
    CHECK(tally.unlikeElsewhere == 0);
    CHECK(static_cast<double>(tally.unlike) <= 1e-4 * rayCount);
    CHECK(static_cast<double>(tally.sameSides) <= 1e-5 * rayCount);
    CHECK(static_cast<double>(tally.hits) > 0.2 * rayCount);
}

// Rays at the trees that start anywhere, or as if they left a leaf of them.
std::vector<shared::Ray> raysFromTrees(const BothSides& both, Random& random, std::size_t count) {
    std::vector<shared::Ray> rays;
    for (const shared::Ray& ray : raysAtTrees(random)) {
        rays.push_back(ray);
        if (rays.size() % 3 != 0) {
            const auto objects = static_cast<double>(both.deviceScene.objectOf.size());
            rays.back().from = 1 + static_cast<std::uint32_t>(random.unit() * objects);
            rays.back().from |= rays.size() % 3 == 1 ? shared::kRayInside : 0;
        }
        if (rays.size() == count) {
            break;
        }
    }
    return rays;
}

// Every ray with each of its seven numbers in turn replaced.
std::vector<shared::Ray> withEachReplaced(const std::vector<shared::Ray>& rays, float number) {
    std::vector<shared::Ray> replaced;
    for (const shared::Ray& ray : rays) {
        for (int i = 0; i < 7; ++i) {
            replaced.push_back(ray);
            shared::Ray& other = replaced.back();
            (i < 3 ? other.origin[i] : i < 6 ? other.direction[i - 3] : other.tMax) = number;
        }
    }
    return replaced;
}

std::vector<shared::Hit> traceAll(BothSides& both, const std::vector<shared::Ray>& rays) {
    const auto count = static_cast<std::uint32_t>(rays.size());
    const auto deviceRays = both.upload(rays);
    const auto hits = both.room<shared::Hit>(count);
    both.run("trace_closest", shared::TraceClosestArguments{deviceRays, hits, count, both.deviceScene.rootNode, 0},
             count);
    return hits.read();
}

// A box whose corners have whole coordinates from -2 to 2.
Shape boxOnGrid(Random& random) {
    Bounds clip;
    for (int axis = 0; axis < 3; ++axis) {
        clip.low[axis] = std::floor(random.between(-2, 1.999));
        clip.high[axis] = clip.low[axis] + 1 + std::floor(random.between(0, 1.999));
    }
    return Quadric{.form = {.j = -1}, .clip = clip, .capped = true, .objectToWorld = dmat4(1)};
}

} // namespace

TEST_CASE("where faces of boxes coincide, the first leaf that decides is hit on both sides", "[csg]") {
    // On so small a grid most trees have coincident faces, of leaves that enter together and of leaves that take turns
    Random random;
    std::size_t hitCount = 0;
    std::size_t unlike = 0;
    std::size_t elsewhere = 0;
    for (int tree = 0; tree < 60; ++tree) {
        Scene scene;
        scene.lights.push_back({.position = {0, 9, 0}, .intensity = dvec3(1)});
        reference::test::addMaterial(scene, Diffuse{});
        Csg csg{.firstLeaf = 0, .program = {}};
        const auto makeLeaf = [&] {
            scene.csgLeaves.push_back({.shape = boxOnGrid(random), .material = 0, .emission = dvec3(0), .where = {}});
        };
        appendTree(random, 2 + static_cast<std::size_t>(tree) % 7, makeLeaf, csg.program);
        reference::test::addObject(scene, csg, 0);
        BothSides both(scene);
        std::vector<shared::Ray> rays;
        for (std::size_t i = 0; i < 5000; ++i) {
            const dvec3 origin = i % 2 == 0 ? random.inCube(2.5) : 6.0 * random.direction();
            rays.push_back(toDevice({.origin = origin, .direction = glm::normalize(random.inCube(2) - origin)}));
        }
        const auto count = static_cast<std::uint32_t>(rays.size());
        const auto deviceRays = both.upload(rays);
        const auto hits = both.room<shared::Hit>(count);
        both.run("trace_closest",
                 shared::TraceClosestArguments{deviceRays, hits, count, both.deviceScene.rootNode, 0, {}}, count);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const shared::Hit& hit = hits.host()[i];
            const reference::Ray ray = toReference(rays[i]);
            const auto expected = reference::traceClosest(both.world, ray);
            const bool isHit = hit.object != shared::kNone;
            hitCount += isHit ? 1 : 0;
            if (isHit != expected.has_value() || (isHit && both.deviceScene.leafOf[hit.object] != expected->leaf)) {
                ++unlike;
                elsewhere += isUnstable(both, ray, expected) ? 0 : 1;
            }
        }
    }
    INFO(hitCount << " hits, " << unlike << " unlike, " << elsewhere << " of these not at an edge");
    CHECK(hitCount > 20000);
    CHECK(unlike <= 30); // of 300 000: rays that graze, or pass an edge
    CHECK(elsewhere == 0);
}

TEST_CASE("ten thousand random CSG trees are hit where they are in the reference", "[csg]") {
    compareTrees(10000);
}

TEST_CASE("a ray of which a number is none ends, and meets nothing") {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kEndless = std::numeric_limits<float>::infinity();
    Random random;
    Scene many = treesScene(random); // a hierarchy of objects
    reference::test::addObject(many, MeshInstance{0, dmat4(1)}, 0);
    reference::test::addObject(many, Sphere{{1, 1, 1}, 2}, 0);
    Scene few; // that are tried one by one
    few.lights = many.lights;
    few.materials = many.materials;
    few.meshes = many.meshes;
    addTree(few, random, placeOf(0), 12);
    addTree(few, random, placeOf(0), 1);
    for (Scene& scene : {std::ref(many), std::ref(few)}) {
        BothSides both(scene);
        const std::vector<shared::Ray> rays = raysFromTrees(both, random, 600);
        for (const float number : {kNan, kEndless, -kEndless}) {
            const std::vector<shared::Ray> broken = withEachReplaced(rays, number);
            const std::vector<shared::Hit> hits = traceAll(both, broken);
            CHECK(std::ranges::count_if(hits, [](const auto& hit) { return hit.object != shared::kNone; }) == 0);
        }
        // Numbers that are some, but overflow on the way
        CHECK(traceAll(both, withEachReplaced(rays, 1e38F)).size() == 7 * rays.size());
        CHECK(traceAll(both, withEachReplaced(rays, 3e19F)).size() == 7 * rays.size());
    }
}

} // namespace hyalite::testing
