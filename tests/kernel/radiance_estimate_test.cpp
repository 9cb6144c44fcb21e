// The radiance estimate from the nearest photons, against the reference and against densities that are known.
#include "kernel/photon_sets.h"
#include "kernel/visible_points.h"
#include "reference/photons/radiance_estimate.h"
#include "render/photons/photon_grid.h"
#include "render/photons/photon_query.h"
#include "render/photons/photon_tree.h"

#include <array>
#include <catch2/matchers/catch_matchers_string.hpp>

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kIndirect = 1U << shared::kPhotonIndirect;
constexpr std::uint32_t kUp16 = 0x7fffU | 0x7fffU << 16U; // to half a step of 1/32767 in x and y

struct Estimates {
    std::vector<vec3> radiance;
    std::vector<float> radii;
};

// Builds a map of the photons and estimates at every point.
Estimates estimate(BothSides& both, render::PhotonStructure structure, const std::vector<shared::Photon>& slots,
                   const std::vector<shared::VisiblePoint>& points, const render::PhotonSearch& search,
                   const render::PhotonDensity& density) {
    const auto photons = both.upload(slots);
    const auto slotCount = static_cast<std::uint32_t>(slots.size());
    const auto count = static_cast<std::uint32_t>(points.size());
    const auto table = both.room<shared::Photon>(slots.size() + 2);
    render::PhotonTree tree(both.device);
    render::PhotonGrid grid(both.device);
    const bool isTree = structure == render::PhotonStructure::Tree;
    if (isTree) {
        tree.build(both.device, photons, slotCount, table, 2);
    } else {
        grid.build(both.device, photons, slotCount, search.radius, table, 2);
    }
    both.device.commands.finish();
    both.device.tables.set(TABLE_PHOTONS, table.buffer(), gpu::TexelFormat::Float4);
    render::RadianceEstimate kernel(both.device, both.deviceScene, structure, search.nearest);
    const auto devicePoints = both.upload(points);
    const auto gathered = both.room<vec3>(count);
    const auto radii = both.room<float>(count);
    kernel.run(both.device, isTree ? tree.map() : grid.map(), devicePoints, count, search, density, gathered, radii);
    both.device.commands.finish();
    return {gathered.read(), radii.read()};
}

shared::VisiblePoint upwardPoint(const vec3& position) {
    return PointMade{.position = position, .geometricNormal = kUp16};
}

dvec3 geometricNormal() {
    const double step = 0x7fff / 32767.5 - 1; // what kUp16 says exactly: a little off the axis
    return glm::normalize(dvec3(step, step, 1 - 2 * std::abs(step)));
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

// Standard deviation of the mean.
double errorOfMean(const std::vector<double>& values) {
    const double mean = meanOf(values);
    double sum = 0;
    for (const double value : values) {
        sum += (value - mean) * (value - mean);
    }
    const auto n = static_cast<double>(values.size());
    return std::sqrt(sum / (n - 1) / n);
}

constexpr render::PhotonDensity density(render::PhotonFilter filter, float coneConstant, float maxChange,
                                        float footprint = 0) {
    return {filter, coneConstant, maxChange, {0.3F, 0, 1}, footprint};
}

constexpr std::array kDensities{
    density(render::PhotonFilter::None, 1.1F, 0), density(render::PhotonFilter::Cone, 1.1F, 0),
    density(render::PhotonFilter::Cone, 2.5F, 0), density(render::PhotonFilter::Gaussian, 1.1F, 0),
    density(render::PhotonFilter::None, 1.1F, 0.3F), density(render::PhotonFilter::Gaussian, 1.1F, 0.2F),
    // Discs no smaller than 0.02 below the eye, which is above the spot at a height of 1
    density(render::PhotonFilter::Cone, 1.1F, 0.3F, 0.02F)};

} // namespace

TEST_CASE("the radiance estimate is the reference's, from the tree and, bit for bit the same, from the grid") {
    BothSides both(withPaints(reference::test::cornellBox()));
    reference::test::Random random;
    // A floor with a step of 0.02, more and more photons to one side, and a bright spot with a sharp edge
    std::vector<shared::Photon> slots;
    std::vector<reference::Photon> stored;
    for (std::uint32_t i = 0; i < 30000; ++i) {
        const double u = random.unit();
        dvec3 p{2 * u * u - 1, random.between(-1, 1), 0};
        if (i % 4 == 0) {
            const dvec3 in = random.inCube(0.1);
            p = dvec3(0.3 + in.x, in.y, 0);
        }
        p.z = p.y > 0.4 ? 0.02 : 0.0;
        slots.push_back(upwardPhoton(vec3(p), static_cast<float>(random.between(0.5, 1.5))));
        // From any direction above: octahedral x and y of no more than 1/2 each
        const glm::uvec2 code =
            glm::uvec2(0x2000U) + glm::uvec2(glm::dvec2(0x3fff) * glm::dvec2(random.unit(), random.unit()));
        const glm::dvec2 flat = glm::dvec2(code) / 16383.5 - 1.0;
        slots.back().direction = code.x | code.y << 15U;
        stored.push_back({.position = slots.back().position,
                          .direction = glm::normalize(dvec3(flat, 1 - std::abs(flat.x) - std::abs(flat.y))),
                          .normal = {0, 0, 1},
                          .power = slots.back().power,
                          .photon = i,
                          .depth = 2,
                          .light = 0,
                          .kind = reference::PhotonKind::Indirect});
    }
    std::vector<shared::VisiblePoint> points;
    for (std::uint32_t i = 0; i < 2000; ++i) {
        const dvec3 p = random.inCube(1.1);
        const bool nearSpot = i % 2 == 0;
        points.push_back(upwardPoint(vec3(nearSpot ? dvec3(0.3 + 0.2 * p.x, 0.2 * p.y, 0) : dvec3(p.x, p.y, 0))));
        points.back().beta = vec3(0.3, 0.6, 0.9);
        points.back().depth = i % 100 == 0 ? 0 : 1;
        points.back().material = paintOf(both.scene, i % 3 == 0);
    }
    const reference::PhotonMap map(stored);
    for (const std::uint32_t nearest : {2U, 50U, 300U}) {
        for (const render::PhotonDensity& density : kDensities) {
            // Photons may be off their surface by the step: they count across it, up to a quarter of the disc
            const render::PhotonSearch search{
                .nearest = nearest, .radius = 0.08F, .kinds = kIndirect, .maxDepth = 12, .surfaceError = 0.02F};
            INFO(nearest << " photons, filter " << static_cast<int>(density.filter) << ", change "
                         << density.maxChange);
            const auto tree = estimate(both, render::PhotonStructure::Tree, slots, points, search, density);
            const auto grid = estimate(both, render::PhotonStructure::Grid, slots, points, search, density);
            if (density.footprint == 0) { // where all photons of a pixel count, their order is the structure's
                CHECK(tree.radiance == grid.radiance);
            }
            CHECK(tree.radii == grid.radii);
            const reference::RadianceEstimateOptions options{.nearest = nearest,
                                                             .radius = double{search.radius},
                                                             .kinds = kIndirect,
                                                             .maxDepth = 12,
                                                             .filter =
                                                                 static_cast<reference::PhotonFilter>(density.filter),
                                                             .coneConstant = double{density.coneConstant},
                                                             .maxChange = double{density.maxChange},
                                                             .surfaceError = double{search.surfaceError},
                                                             .eye = dvec3(density.eye),
                                                             .footprint = double{density.footprint}};
            std::size_t differ = 0;
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (points[i].depth == 0) {
                    CHECK(tree.radiance[i] == vec3(0));
                    CHECK(tree.radii[i] == 0);
                    continue;
                }
                const reference::VisiblePoint x = toReference(both, points[i], geometricNormal());
                const auto expected = reference::estimateRadiance(map, x, options);
                const bool same = std::abs(tree.radii[i] - expected.radius) < 1e-5 * expected.radius &&
                                  distance(tree.radiance[i], expected.radiance) < 1e-4 * expected.radiance.x + 1e-7;
                differ += same ? 0 : 1;
            }
            // Rounding decides if a photon is on the rim, or a change is at the limit
            CHECK(differ <= points.size() / 200);
        }
    }
}

TEST_CASE("on a plane with random photons the mean of the estimate is the density, with every filter and radius") {
    // Photons of 1 W, evenly by chance on the unit square, at density n: L = f n. The discs of the queries do not meet,
    // so that the estimates are nearly independent. The mean of 1521 is off by more than 4.5 of its standard deviations
    // once in 147 000; with the k-th photon counted it would be off by 1/19, more than 8.
    BothSides both(reference::test::cornellBox());
    reference::test::Random random;
    const std::uint32_t n = 100000;
    std::vector<shared::Photon> slots;
    for (std::uint32_t i = 0; i < n; ++i) {
        slots.push_back(upwardPhoton(vec3(random.unit(), random.unit(), 0), 1));
    }
    std::vector<shared::VisiblePoint> points;
    for (int i = 1; i < 40; ++i) {
        for (int j = 1; j < 40; ++j) {
            points.push_back(upwardPoint(vec3(i, j, 0) / 40.0F));
        }
    }
    // 20 photons fill a disc of radius 0.008: one of half as much again has them nearly always, a smaller one hardly
    // ever
    for (const float radius : {0.012F, 0.008F, 0.005F}) {
        for (std::size_t filter = 0; filter < 4; ++filter) {
            INFO("radius " << radius << ", filter " << filter);
            const auto estimates = estimate(both, render::PhotonStructure::Tree, slots, points,
                                            {20, radius, kIndirect, 12, 0, 0}, kDensities[filter]);
            std::vector<double> values;
            for (const vec3& radiance : estimates.radiance) {
                values.push_back(radiance.x / static_cast<double>(n));
            }
            INFO("mean " << meanOf(values) << " +- " << errorOfMean(values));
            CHECK(std::abs(meanOf(values) - 1) < 4.5 * errorOfMean(values));
            CHECK(errorOfMean(values) < 0.012); // 8 photons in the least discs, by a cone: 0.4 / 39 = 0.0103
        }
    }
}

TEST_CASE("no light leaks through a thin wall, around a corner or down a step") {
    BothSides both(reference::test::cornellBox());
    reference::test::Random random;
    std::vector<shared::Photon> slots;
    for (std::uint32_t i = 0; i < 6000; ++i) {
        const dvec3 p = random.inCube(1);
        shared::Photon photon = upwardPhoton(vec3(p.x, p.y, 0), 1);
        if (i % 3 == 0) { // the underside of a floor without thickness, lit from below; octahedral (0, 0, -1)
            photon.direction = 0;
            photon.surface &= ~((1U << shared::kKindShift) - 1);
        } else if (i % 3 == 1) { // a wall that stands on it; octahedral (1, 0)
            photon.position = vec3(0, p.y, p.x + 1);
            photon.surface = (photon.surface & ~((1U << shared::kKindShift) - 1)) | 0x7ffU | 0x3ffU << 11U;
        } else { // floors beneath, by a step and by the thickness of a sheet
            photon.position.z = i % 2 == 0 ? -0.06F : -0.001F;
        }
        slots.push_back(photon);
    }
    std::vector<shared::VisiblePoint> points;
    for (std::uint32_t i = 0; i < 500; ++i) {
        points.push_back(upwardPoint(vec3(random.between(-0.9, 0.9), random.between(-0.9, 0.9), 0)));
    }
    for (const auto structure : {render::PhotonStructure::Tree, render::PhotonStructure::Grid}) {
        const auto estimates = estimate(both, structure, slots, points, {512, 0.2F, kIndirect, 12, 0, 0}, {});
        for (const vec3& radiance : estimates.radiance) {
            REQUIRE(radiance == vec3(0));
        }
    }
}

TEST_CASE("differential checking leaves an even density alone and keeps the edge of a lit half plane") {
    BothSides both(reference::test::cornellBox());
    reference::test::Random random;
    const std::uint32_t n = 40000;
    std::vector<shared::Photon> slots;
    for (std::uint32_t i = 0; i < n; ++i) { // density n / 2 where x < 0, none beyond
        slots.push_back(upwardPhoton(vec3(random.between(-1, 0), random.between(-1, 1), 0), 1));
    }
    std::vector<shared::VisiblePoint> inside;
    std::vector<shared::VisiblePoint> atEdge;
    for (int i = 0; i < 400; ++i) {
        inside.push_back(upwardPoint(vec3(-0.5, -0.8 + 0.004 * i, 0)));
        atEdge.push_back(upwardPoint(vec3(-0.03, -0.8 + 0.004 * i, 0)));
    }
    const render::PhotonSearch search{500, 0.5F, kIndirect, 12, 0, 0};
    const auto mean = [&](const std::vector<shared::VisiblePoint>& points, float maxChange) {
        const auto estimates = estimate(both, render::PhotonStructure::Tree, slots, points, search,
                                        {render::PhotonFilter::None, 1.1F, maxChange});
        std::vector<double> values;
        for (const vec3& radiance : estimates.radiance) {
            values.push_back(radiance.x / (n / 2.0));
        }
        return meanOf(values);
    };
    // 500 photons reach 0.09 from inside, three times as far as the edge is from the points near it: of a disc of
    // radius r cut off at a third of it, 0.708 is lit and the disc grows until it holds them. Stopped in time it is
    // nearer 1.
    CHECK(std::abs(mean(inside, 0.15F) - 1) < 0.15);
    const double blurred = mean(atEdge, 0);
    const double kept = mean(atEdge, 0.15F);
    CHECK(blurred < 0.75);
    CHECK(std::abs(kept - 1) < 0.7 * std::abs(blurred - 1));
}

TEST_CASE("a search for no photon, or for more than a thread keeps, is refused") {
    BothSides both(reference::test::cornellBox());
    for (const std::uint32_t nearest : {0U, 1U, 513U}) {
        CHECK_THROWS_WITH(
            render::RadianceEstimate(both.device, both.deviceScene, render::PhotonStructure::Tree, nearest),
            Catch::Matchers::ContainsSubstring("a search for " + std::to_string(nearest) + " photons"));
    }
}

} // namespace hyalite::testing
