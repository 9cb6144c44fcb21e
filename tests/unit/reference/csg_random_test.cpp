// Random trees of all solids against point membership, which does not use crossings; and rays that must not escape.
#include "reference/bsdf/interface.h"
#include "reference/world.h"
#include "unit/reference/random_solids.h"

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

constexpr double kBall = 2; // radius of the ball that holds every tree

Scene randomTree(Random& random, std::size_t leaves) {
    Scene scene;
    scene.render.radius = 1;
    for (std::size_t i = 0; i <= leaves; ++i) {
        addMaterial(scene, Diffuse{});
    }
    scene.meshes = {cubeMesh(), ballMesh()};
    addRandomTree(random, scene, leaves, kBall);
    return scene;
}

// All hits along the ray, each found from just behind the one before.
std::vector<Hit> allHits(const World& world, const Ray& ray) {
    std::vector<Hit> hits;
    Ray rest = ray;
    double gone = 0;
    while (const auto hit = traceClosest(world, rest)) {
        hits.push_back(*hit);
        hits.back().t += gone;
        gone = hits.back().t + hit->spread + 1e-12; // all that coincides with this hit is passed
        rest.origin = ray.origin + gone * ray.direction;
        REQUIRE(hits.size() < 1000);
    }
    return hits;
}

// Membership at a place on the ray, by the majority of three points: a slice thinner than a place, which traces ignore,
// contains at most one of them.
bool isInsideAt(const World& world, const Ray& ray, double t) {
    int votes = 0;
    for (const double step : {0.0, 2e-4, 4e-4}) {
        votes += isInside(world, 0, ray.origin + (t + step) * ray.direction) ? 1 : 0;
    }
    return votes >= 2;
}

} // namespace

TEST_CASE("membership changes at every hit of a random tree, and nowhere else") {
    Random random;
    int hitCount = 0;
    int wrong = 0;
    for (int tree = 0; tree < 4000; ++tree) {
        const Scene scene = randomTree(random, 1 + static_cast<std::size_t>(tree % 31));
        const World world = prepareWorld(scene);
        for (int i = 0; i < 8; ++i) {
            const Ray ray{.origin = random.inCube(i % 2 == 0 ? 1 : 3), .direction = random.direction()};
            const std::vector<Hit> hits = allHits(world, ray);
            hitCount += static_cast<int>(hits.size());
            // Between two hits, and beyond the last, membership is that of a random place there.
            double from = 0;
            bool inside = hits.size() % 2 == 1; // the tree is bounded: beyond the last hit is outside
            for (std::size_t k = 0; k <= hits.size(); ++k) {
                const double to = k < hits.size() ? hits[k].t : from + 1;
                if (to - from > 4e-3) {
                    const double t = random.between(from + 1e-3, to - 1e-3);
                    wrong += isInsideAt(world, ray, t) == inside ? 0 : 1;
                    wrong += isInsideAt(world, ray, from + 1e-3) == inside ? 0 : 1;
                    wrong += isInsideAt(world, ray, to - 2e-3) == inside ? 0 : 1;
                }
                inside = !inside;
                from = to;
            }
        }
    }
    CHECK(wrong == 0);
    CHECK(hitCount > 10000);
}

TEST_CASE("no ray escapes from inside a random tree, not even by reflections") {
    Random random;
    int rays = 0;
    int escaped = 0;
    int wrongSide = 0;
    for (int tree = 0; tree < 2000; ++tree) {
        const Scene scene = randomTree(random, 1 + static_cast<std::size_t>(tree % 31));
        const World world = prepareWorld(scene);
        for (int i = 0; i < 40; ++i) {
            Ray ray{.origin = random.inCube(1.2), .direction = random.direction()};
            if (!isInside(world, 0, ray.origin)) {
                continue;
            }
            for (int bounce = 0; bounce < 10; ++bounce) {
                ++rays;
                const auto hit = traceClosest(world, ray);
                if (!hit) {
                    ++escaped;
                    break;
                }
                if (hit->spread > 0) {
                    break; // in an edge: the next ray may start beside the other face
                }
                const Surface surface = evaluateSurface(world, ray, *hit);
                wrongSide += surface.front ? 1 : 0;
                const dvec3 direction = reflect(ray.direction, surface.geometricNormal);
                ray = {.origin = leave(surface, direction), .direction = direction};
            }
        }
    }
    CHECK(escaped == 0);
    CHECK(wrongSide == 0);
    CHECK(rays > 100000);
}
