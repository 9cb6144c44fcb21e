// The photon grid and the gathering of radiance, against brute force and against the reference.
#include "kernel/kernel_support.h"
#include "kernel/visible_points.h"
#include "reference/photons/photon_map.h"
#include "render/photons/photon_grid.h"

#include <algorithm>
#include <map>

namespace hyalite::testing {

namespace {

// An upward surface's photon of power 1, arriving from above, after two segments.
constexpr std::uint32_t kMiddle11 = 0x3ff;
constexpr std::uint32_t kKindAndLength = shared::kPhotonIndirect << shared::kKindShift | 2U << shared::kLengthShift;
shared::Photon photonAt(const vec3& position, float power) {
    // Octahedral (0, 0, 1): both coordinates at the middle, to one step in 2047 and 32767
    const std::uint32_t up11 = kMiddle11 | kMiddle11 << 11U;
    const std::uint32_t up15 = 0x3fffU | 0x3fffU << 15U;
    return {position, up15, vec3(power), up11 | kKindAndLength};
}

reference::Photon toReference(const shared::Photon& p, std::uint32_t number) {
    return {.position = p.position,
            .direction = {0, 0, 1},
            .normal = {0, 0, 1},
            .power = p.power,
            .photon = number,
            .depth = 2};
}

struct PhotonSet {
    std::string name;
    std::vector<vec3> positions;
};

std::vector<PhotonSet> photonSets() {
    reference::test::Random random;
    std::vector<PhotonSet> sets{{"none", {}},   {"one", {vec3(0.1F)}}, {"planar", {}},
                                {"volume", {}}, {"clustered", {}},     {"coincident", {}}};
    for (int i = 0; i < 20000; ++i) {
        const dvec3 p = random.inCube(1);
        sets[2].positions.emplace_back(p.x, p.y, 0);
        sets[3].positions.emplace_back(p);
        sets[4].positions.emplace_back(0.3 + 0.01 * p.x * p.x, 0.01 * p.y, 0); // all in a few cells
    }
    sets[5].positions.assign(5000, vec3(-0.5, 0.25, 0));
    return sets;
}

std::vector<shared::Photon> photonsOf(const PhotonSet& set) {
    std::vector<shared::Photon> photons;
    for (std::size_t i = 0; i < set.positions.size(); ++i) {
        photons.push_back(photonAt(set.positions[i], 1 + static_cast<float>(i % 7)));
        if (i % 3 == 0) { // slots where nothing was stored
            photons.push_back(photons.back());
            photons.back().surface = shared::kNone;
        }
    }
    return photons;
}

} // namespace

TEST_CASE("the grid holds every stored photon once, buckets together, in the order of emission") {
    BothSides both(reference::test::cornellBox());
    render::PhotonGrid grid(both.device);
    for (const PhotonSet& set : photonSets()) {
        INFO(set.name);
        const auto photons = photonsOf(set);
        const auto devicePhotons = both.upload(photons);
        grid.build(both.device, devicePhotons, static_cast<std::uint32_t>(photons.size()), 0.02F);
        both.device.commands.finish();
        REQUIRE(grid.photonCount() == set.positions.size());

        const auto record = grid.record();
        const auto bucketOf = [&](const vec3& p) {
            const vec3 cell = glm::floor(p * record.inverseCellSize);
            return shared::cellBucket(glm::ivec3(cell), record.bucketMask);
        };
        // The order expected: by bucket, then by slot
        std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
        for (std::uint32_t slot = 0; slot < photons.size(); ++slot) {
            if (photons[slot].surface != shared::kNone) {
                expected.emplace_back(bucketOf(photons[slot].position), slot);
            }
        }
        std::ranges::sort(expected);
        const auto sorted = grid.sorted().read();
        const auto cellStarts = grid.cellStarts().read();
        for (std::size_t i = 0; i < expected.size(); ++i) {
            REQUIRE(sorted[i].position == photons[expected[i].second].position);
            REQUIRE(sorted[i].power == photons[expected[i].second].power);
            REQUIRE(cellStarts[expected[i].first] <= i);
            REQUIRE(cellStarts[expected[i].first + 1] > i);
        }
    }
}

TEST_CASE("gathering finds every photon of the disc once, even if cells share buckets") {
    BothSides both(withPaints(reference::test::cornellBox()));
    render::PhotonGrid grid(both.device);
    reference::test::Random random;
    for (const PhotonSet& set : photonSets()) {
        INFO(set.name);
        const auto photons = photonsOf(set);
        const auto devicePhotons = both.upload(photons);
        // 0.02: some 10^6 cells for 2^14 buckets or fewer, so that unrelated cells share them
        for (const float radius : {0.02F, 0.3F, 3.0F}) {
            grid.build(both.device, devicePhotons, static_cast<std::uint32_t>(photons.size()), radius);
            const std::uint32_t count = set.name == "volume" || radius < 1 ? 2000 : 200;
            std::vector<shared::VisiblePoint> points(count);
            for (std::uint32_t i = 0; i < count; ++i) {
                const bool atPhoton = !set.positions.empty() && i % 2 == 0;
                const dvec3 near = atPhoton ? dvec3(set.positions[i % set.positions.size()]) : random.inCube(1);
                points[i] = PointMade{.position = vec3(near + 0.5 * random.inCube(radius) * dvec3(1, 1, 0.1)),
                                      .pixel = i,
                                      .material = paintOf(both.scene, i % 2 != 0)};
            }
            const auto devicePoints = both.upload(points);
            const auto gathered = both.room<vec3>(count);
            both.run("gather_radiance",
                     shared::GatherRadianceArguments{devicePoints, both.deviceScene.materials, grid.cellStarts(),
                                                     gathered, grid.record(), radius, count, 12, 13, radius},
                     count);
            std::vector<reference::Photon> stored;
            for (const shared::Photon& p : photons) {
                if (p.surface != shared::kNone) {
                    stored.push_back(toReference(p, static_cast<std::uint32_t>(stored.size())));
                }
            }
            const reference::PhotonMap map(stored);
            std::size_t edge = 0; // a photon on the rim of the disc, in on one side and out on the other
            for (std::uint32_t i = 0; i < count; ++i) {
                const reference::VisiblePoint x = toReference(both, points[i]);
                const double expected = reference::gatherRadiance(map, x, radius, 12, radius).x;
                const double actual = gathered.host()[i].x;
                edge += std::abs(actual - expected) > 1e-4 * expected ? 1 : 0;
            }
            CHECK(edge <= count / 200);
        }
    }
}

TEST_CASE("a disc that extends beyond a parallelogram counts with its area inside") {
    // Photons all over a slanted parallelogram, and points up to its edges and corners
    Scene scene;
    const Quad quad{{-0.5, -0.4, 0}, {1.1, 0.2, 0}, {-0.3, 0.9, 0}};
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(0.7)});
    reference::test::addObject(scene, Sphere{{0, 0, -5}, 1}, white);
    reference::test::addObject(scene, quad, white);
    scene.lights = {{{0, 0, 3}, dvec3(1)}};
    BothSides both(std::move(scene));
    reference::test::Random random;
    const auto onQuad = [&](double u, double v) { return quad.corner + u * quad.edge0 + v * quad.edge1; };
    std::vector<shared::Photon> photons;
    std::vector<reference::Photon> stored;
    for (std::uint32_t i = 0; i < 4000; ++i) {
        const dvec3 at = random.inCube(0.5) + 0.5;
        photons.push_back(photonAt(onQuad(at.x, at.y), 1));
        stored.push_back(toReference(photons.back(), i));
    }
    const reference::PhotonMap map(stored);
    std::vector<shared::VisiblePoint> points;
    const std::uint32_t quadObject = both.sceneObject(0) == 1 ? 0 : 1;
    REQUIRE(both.sceneObject(quadObject) == 1);
    for (std::uint32_t i = 0; i < 3000; ++i) {
        dvec3 at = random.inCube(0.5) + 0.5;
        at.x = i % 3 == 0 ? std::round(at.x) : at.x; // on an edge, or a corner
        at.y = i % 5 == 0 ? std::round(at.y) : at.y;
        points.push_back(PointMade{.position = onQuad(at.x, at.y), .pixel = i, .from = 1 + quadObject});
    }
    render::PhotonGrid grid(both.device);
    const auto devicePhotons = both.upload(photons);
    const auto devicePoints = both.upload(points);
    const auto count = static_cast<std::uint32_t>(points.size());
    const auto gathered = both.room<vec3>(count);
    for (const float radius : {0.05F, 0.3F, 2.0F}) { // the last covers all of it
        INFO("radius " << radius);
        grid.build(both.device, devicePhotons, 4000, radius);
        both.run("gather_radiance",
                 shared::GatherRadianceArguments{devicePoints, both.deviceScene.materials, grid.cellStarts(), gathered,
                                                 grid.record(), radius, count, 12, 13, 0},
                 count);
        std::size_t edge = 0; // a photon on the rim of the disc, in on one side and out on the other
        for (std::uint32_t i = 0; i < count; ++i) {
            reference::VisiblePoint x = toReference(both, points[i], {0, 0, 1});
            x.quad = &quad;
            const double expected = reference::gatherRadiance(map, x, radius, 12, 0).x;
            edge += std::abs(gathered.host()[i].x - expected) > 1e-4 * expected ? 1 : 0;
        }
        CHECK(edge <= count / 200);
    }
}

TEST_CASE("photons of another surface, another side or too long a path are not gathered") {
    BothSides both(reference::test::cornellBox());
    render::PhotonGrid grid(both.device);
    const float radius = 0.1F;
    const auto estimate = [&](const shared::Photon& photon, std::uint32_t depth, std::uint32_t maxDepth) {
        const auto photons = both.upload(std::vector{photon});
        grid.build(both.device, photons, 1, radius);
        const auto points =
            both.upload(std::vector<shared::VisiblePoint>{PointMade{.position = vec3(0), .depth = depth}});
        const auto gathered = both.room<vec3>(1);
        both.run("gather_radiance",
                 shared::GatherRadianceArguments{points, both.deviceScene.materials, grid.cellStarts(), gathered,
                                                 grid.record(), radius, 1, maxDepth, 13, radius},
                 1);
        return gathered.host()[0].x;
    };
    // f * power / (pi r^2), f = 1
    const float whole = 3.0F / (std::numbers::pi_v<float> * radius * radius);
    const shared::Photon near = photonAt({0.05F, 0, 0.01F}, 3);
    CHECK(std::abs(estimate(near, 1, 3) - whole) < 1e-5F * whole);
    CHECK(estimate(near, 2, 3) == 0);                           // two segments here, two there
    CHECK(estimate(photonAt({0.08F, 0.08F, 0}, 3), 1, 3) == 0); // in the cell but outside the disc
    CHECK(estimate(photonAt({0, 0, 0.03F}, 3), 1, 3) == 0);     // off the tangent plane by more than r / 4
    shared::Photon below = near;
    below.direction = 0; // octahedral (-1, -1): straight down
    CHECK(estimate(below, 1, 3) == 0);
    shared::Photon wall = near;
    wall.surface = 0x7ffU | kMiddle11 << 11U | kKindAndLength; // octahedral (1, 0): normal along x
    CHECK(estimate(wall, 1, 3) == 0);
}

} // namespace hyalite::testing
