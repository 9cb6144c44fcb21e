// Every shape with a million rays: trace_closest and the resulting surfaces against the reference.
#include "kernel/kernel_support.h"
#include "support/random_shapes.h"

#include "base/parallel.h"

#include <atomic>
#include <functional>
#include <sstream>

namespace hyalite::testing {

namespace {

constexpr std::size_t kRays = 1000000;

// Of a million rays ten may differ, and they must pass a silhouette or edge.
constexpr double kUnlike = 1e-5;
constexpr double kUnlikeNormal = 1e-3;

// Largest error [m] of a hit on a surface about one metre in size: eight roundings of 2^-24 in a space stretched four
// times as much along one axis as along another (see randomPlacement). For a ray that hits at an angle, the error in t
// is this over the cosine.
constexpr double kPlaceError = 0x1p-19;

// What the kernels find along a ray.
struct Found {
    std::vector<shared::Hit> hits;
    std::vector<shared::VisiblePoint> points;
};

Found find(BothSides& both, const std::vector<shared::Ray>& rays) {
    const auto count = static_cast<std::uint32_t>(rays.size());
    const auto deviceRays = both.upload(rays);
    const auto hits = both.room<shared::Hit>(count);
    const auto& d = both.deviceScene;
    both.run("trace_closest", shared::TraceClosestArguments{deviceRays, hits, count, d.rootNode, 0, {}}, count);
    std::vector<shared::CameraPath> paths(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        paths[i] = {vec3(1), i, i, shared::kNone, 0};
    }
    const auto devicePaths = both.upload(paths);
    const auto points = both.room<shared::VisiblePoint>(count);
    const auto emitted = both.room<vec3>(count);
    const auto nextRays = both.room<shared::Ray>(count);
    const auto nextPaths = both.room<shared::CameraPath>(count);
    const auto alive = both.room<shared::uint>(count);
    both.run("shade_surface",
             shared::ShadeSurfaceArguments{deviceRays,
                                           hits,
                                           devicePaths,
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
                                           12,
                                           0,
                                           {},
                                           0,
                                           {}},
             count);
    return {hits.read(), points.read()};
}

// A scene that holds one diffuse shape of reach about one, and a light because every scene has one.
Scene sceneOf(const Shape& shape) {
    Scene scene;
    scene.lights.push_back({.position = {0, 9, 0}, .intensity = dvec3(1)});
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{});
    reference::test::addObject(scene, shape, white);
    return scene;
}

// From around the shape towards it.
std::vector<shared::Ray> raysFromOutside() {
    constexpr double kReach = 1.5;
    constexpr double kDistance = 4;
    Random random;
    std::vector<shared::Ray> rays;
    for (std::size_t i = 0; i < kRays; ++i) {
        const dvec3 origin = kDistance * random.direction();
        rays.push_back(toDevice({.origin = origin, .direction = glm::normalize(random.inCube(kReach) - origin)}));
    }
    return rays;
}

// From anywhere inside the shape or near it in any direction: many graze, many start on the surface but for rounding.
std::vector<shared::Ray> raysFromAnywhere() {
    Random random;
    std::vector<shared::Ray> rays;
    for (std::size_t i = 0; i < kRays; ++i) {
        rays.push_back(toDevice({.origin = random.inCube(1.5), .direction = random.direction()}));
    }
    return rays;
}

bool areAlike(const std::optional<reference::Hit>& a, const std::optional<reference::Hit>& b, double apart) {
    return a.has_value() == b.has_value() &&
           (!a || (a->leaf == b->leaf && a->primitive == b->primitive && std::abs(a->t - b->t) <= apart));
}

// True if the hit changes abruptly within `shift` of the ray: another part of the shape, a point farther away than ten
// times the shift, or a normal as unlike as compare() reports, as beside the apex of a cone.
bool isOnSilhouette(const reference::World& world, const reference::Ray& ray, double shift) {
    const auto centre = reference::traceClosest(world, ray);
    Random random;
    for (int i = 0; i < 32; ++i) {
        reference::Ray shifted = ray;
        shifted.origin += shift * random.direction();
        shifted.direction = glm::normalize(ray.direction + shift / (1 + (centre ? centre->t : 0)) * random.direction());
        const auto hit = reference::traceClosest(world, shifted);
        if (!areAlike(centre, hit, 10 * shift) ||
            (centre && distance(evaluateSurface(world, shifted, *hit).normal,
                                evaluateSurface(world, ray, *centre).normal) > kUnlikeNormal)) {
            return true;
        }
    }
    return false;
}

enum class Likeness { Alike, Miss, Distance, Normal };

// Strictly, t is right to 1e-5 of itself; else to kPlaceError over the cosine.
Likeness compare(const BothSides& both, const shared::Ray& deviceRay, const shared::Hit& hit,
                 const shared::VisiblePoint& point, bool strictly) {
    const reference::Ray ray = toReference(deviceRay);
    const auto expected = reference::traceClosest(both.world, ray);
    if (expected.has_value() != (hit.object != shared::kNone)) {
        return Likeness::Miss;
    }
    if (!expected) {
        return Likeness::Alike;
    }
    const reference::Surface surface = reference::evaluateSurface(both.world, ray, *expected);
    const double cosine = std::abs(glm::dot(ray.direction, surface.geometricNormal));
    const double allowed =
        strictly ? 1e-5 * expected->t : std::max(kPlaceError * std::max(1.0, expected->t) / cosine, 1e-5 * expected->t);
    if (std::abs(double{hit.t} - expected->t) > allowed) {
        return Likeness::Distance;
    }
    return distance(point.normal, surface.normal) > kUnlikeNormal ? Likeness::Normal : Likeness::Alike;
}

struct Comparison {
    std::size_t hits = 0;
    std::size_t unlike = 0;
    std::size_t unlikeElsewhere = 0; // not on a silhouette
    std::string list;
};

Comparison compareAll(BothSides& both, const std::vector<shared::Ray>& rays, bool strictly) {
    const Found found = find(both, rays);
    std::vector<Likeness> likeness(rays.size());
    parallelFor(rays.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            likeness[i] = compare(both, rays[i], found.hits[i], found.points[i], strictly);
        }
    });
    Comparison result;
    std::ostringstream list;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        result.hits += found.hits[i].object != shared::kNone ? 1 : 0;
        if (likeness[i] == Likeness::Alike) {
            continue;
        }
        const reference::Ray ray = toReference(rays[i]);
        const double length = glm::length(ray.origin) + 1;
        const bool silhouette = isOnSilhouette(both.world, ray, 4e-6 * length);
        ++result.unlike;
        result.unlikeElsewhere += silhouette ? 0 : 1;
        const auto expected = reference::traceClosest(both.world, ray);
        list.precision(9);
        list << "ray " << i
             << (likeness[i] == Likeness::Miss       ? " misses"
                 : likeness[i] == Likeness::Distance ? " distance"
                                                     : " normal")
             << " device t " << found.hits[i].t << " part " << found.hits[i].primitive << ", reference t "
             << (expected ? expected->t : 0) << " part " << (expected ? expected->primitive : 0)
             << (silhouette ? " on a silhouette" : " ELSEWHERE") << '\n';
    }
    result.list = list.str();
    return result;
}

void check(const std::string& name, const Comparison& c) {
    INFO(name << ": " << c.hits << " hits, " << c.unlike << " unlike\n" << c.list);
    CHECK(static_cast<double>(c.unlike) <= kUnlike * static_cast<double>(kRays));
    CHECK(c.unlikeElsewhere == 0);
    CHECK(c.hits > kRays / 100);
}

// A shape without end is met at any distance, so nothing can be said strictly of t.
void checkShape(const std::string& name, const Shape& shape) {
    BothSides both(sceneOf(shape));
    const bool hasEnd = isFinite(worldBounds(both.scene, both.scene.objects[0]));
    check(name + " from outside", compareAll(both, raysFromOutside(), hasEnd));
    check(name + " from anywhere", compareAll(both, raysFromAnywhere(), false));
}

// From a hundred kilometres, where a float resolves 8 mm along the ray.
constexpr double kAfar = 1e5;

std::vector<shared::Ray> raysFromAfar() {
    constexpr std::size_t kFewer = 100000;
    Random random;
    std::vector<shared::Ray> rays;
    for (std::size_t i = 0; i < kFewer; ++i) {
        const dvec3 origin = kAfar * random.direction();
        rays.push_back(toDevice({.origin = origin, .direction = glm::normalize(random.inCube(1) - origin)}));
    }
    return rays;
}

// The point and normal of a hit from afar are as exact as from nearby: the line of a ray is exact, however long, and
// the surface is found near the shape. But which of two crossings nearer than the resolution is hit is open, and
// whether a ray that grazes the shape hits it; `grazes`: rays to leave out.
void checkFromAfar(
    const std::string& name, const Shape& shape,
    const std::function<bool(const reference::Ray&)>& grazes = [](const reference::Ray& /*ray*/) { return false; }) {
    BothSides both(sceneOf(shape));
    const std::vector<shared::Ray> rays = raysFromAfar();
    const Found found = find(both, rays);
    std::size_t hits = 0;
    std::size_t unlike = 0;
    double worstPoint = 0, worstNormal = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const reference::Ray ray = toReference(rays[i]);
        if (grazes(ray)) {
            continue;
        }
        const auto expected = reference::traceClosest(both.world, ray);
        const bool isHit = found.hits[i].object != shared::kNone;
        if (!expected || !isHit) {
            unlike += expected.has_value() != isHit ? 1 : 0;
            continue;
        }
        ++hits;
        const reference::Surface surface = reference::evaluateSurface(both.world, ray, *expected);
        const double cosine = std::abs(glm::dot(ray.direction, surface.geometricNormal));
        const bool isAlike = distance(found.points[i].onSurface, surface.position) <= kPlaceError / cosine &&
                             distance(found.points[i].normal, surface.normal) <= 2e-5 / cosine;
        unlike += isAlike ? 0 : 1;
        worstPoint = std::max(worstPoint, distance(found.points[i].onSurface, surface.position) * cosine);
        worstNormal = std::max(worstNormal, distance(found.points[i].normal, surface.normal) * cosine);
    }
    INFO(name << ": " << unlike << " of " << hits << " hits unlike; worst point " << worstPoint << " normal "
              << worstNormal);
    CHECK(hits > rays.size() / 100);
    CHECK(static_cast<double>(unlike) <= 2e-4 * static_cast<double>(rays.size()));
}

} // namespace

TEST_CASE("rays from a hundred kilometres hit every shape as exactly as rays from nearby", "[shapes][afar]") {
    Random random;
    for (const NamedForm& named : namedForms()) {
        checkFromAfar(std::string(named.name), quadric(named, randomPlacement(random, 0.7, 0.2)));
    }
    const Sphere sphere{{0.1, -0.2, 0.3}, 0.8};
    checkFromAfar("sphere", sphere, [&](const reference::Ray& ray) {
        // The kernel rounds a ray's distance from the centre to single precision: a difference and a product, each
        // within 2^-24 of 1e5 m a coordinate.
        constexpr double kRounding = 2 * 1.7320508 * kAfar / (1 << 24);
        const double distance = glm::length(glm::cross(sphere.center - ray.origin, ray.direction));
        return std::abs(distance - sphere.radius) < kRounding;
    });
    checkFromAfar("torus", Torus{.major = 1, .minor = 0.3, .objectToWorld = randomPlacement(random, 0.7, 0.2)});
}

TEST_CASE("a million rays hit every quadric where the reference hits it", "[shapes]") {
    Random random;
    for (const NamedForm& named : namedForms()) {
        checkShape(std::string(named.name), quadric(named, randomPlacement(random, 0.7, 0.2)));
    }
}

TEST_CASE("a million rays hit open quadrics where the reference hits them", "[shapes]") {
    Random random;
    for (const NamedForm& named : namedForms()) {
        if (named.name != "box") {
            Quadric open = quadric(named, randomPlacement(random, 0.7, 0.2));
            open.capped = false;
            checkShape("open " + std::string(named.name), open);
        }
    }
}

TEST_CASE("a million rays hit unbounded quadrics where the reference hits them", "[shapes]") {
    Random random;
    for (const NamedForm& named : namedForms()) {
        if (named.name != "box") {
            Quadric endless = quadric(named, randomPlacement(random, 0.7, 0.2));
            endless.clip = Bounds::everything();
            checkShape("endless " + std::string(named.name), endless);
        }
    }
}

TEST_CASE("a million rays hit spheres, flat shapes and tori where the reference hits them", "[shapes]") {
    Random random;
    checkShape("sphere", Sphere{{0.1, -0.2, 0.3}, 0.8});
    checkShape("quad", Quad{{-0.7, -0.5, 0.1}, {1.5, 0.2, 0.3}, {-0.2, 1.4, 0.1}});
    checkShape("disk", Disk{{0.1, 0.2, -0.1}, {0.9, 0.1, 0.2}, {-0.2, 0.3, 1.1}});
    checkShape("plane", Plane{{0.1, 0.2, -0.1}, glm::normalize(dvec3(1, 2, -3))});
    checkShape("torus", Torus{.major = 1, .minor = 0.3, .objectToWorld = randomPlacement(random, 0.7, 0.2)});
    checkShape("thin torus", Torus{.major = 1, .minor = 0.02, .objectToWorld = randomPlacement(random, 0.7, 0.2)});
    checkShape("fat torus", Torus{.major = 1, .minor = 0.95, .objectToWorld = randomPlacement(random, 0.5, 0.2)});
}

} // namespace hyalite::testing
