// Measures the photon maps: `measure_photon_maps PHOTONS…` builds a tree and a grid over so many photons on the walls
// of a box, a tenth of them heaped up as in a caustic, and estimates radiance on the walls from both; it prints how
// long that takes by the clock, and how long all cores together have computed: the latter holds on a busy machine too.
#include "base/stopwatch.h"
#include "kernel/photon_sets.h"
#include "kernel/visible_points.h"
#include "render/photons/photon_grid.h"
#include "render/photons/photon_query.h"
#include "render/photons/photon_tree.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <sys/resource.h>

namespace {

using namespace hyalite;
using namespace hyalite::testing;

constexpr int kRepeats = 5;

std::vector<shared::Photon> photonsInBox(std::uint32_t count) {
    reference::test::Random random;
    std::vector<shared::Photon> photons;
    for (std::uint32_t i = 0; i < count; ++i) {
        dvec3 p = random.inCube(1);
        if (i % 10 == 0) {
            p = {0.3 + 0.05 * p.x * p.x * p.x, 0.05 * p.y, -1};
        } else {
            p[static_cast<int>(i % 3)] = i % 2 == 0 ? -1 : 1;
        }
        photons.push_back(upwardPhoton(p, 1));
    }
    return photons;
}

// Row by row over the walls, as a camera sees them.
std::vector<shared::VisiblePoint> pointsOnWalls() {
    std::vector<shared::VisiblePoint> points;
    const int rows = 50;
    for (int wall = 0; wall < 6; ++wall) {
        for (int i = 0; i < rows * rows; ++i) {
            const float u = 2 * (static_cast<float>(i % rows) + 0.5F) / rows - 1;
            const int row = i / rows;
            const float v = 2 * (static_cast<float>(row) + 0.5F) / rows - 1;
            vec3 p(u, v, v);
            p[(wall / 2 + 1) % 3] = u;
            p[wall / 2] = wall % 2 == 0 ? -1 : 1;
            points.push_back(PointMade{.position = p});
        }
    }
    return points;
}

struct Seconds {
    double clock = INFINITY;
    double cores = INFINITY;
};

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

double coreSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

template <class Work>
Seconds shortest(const Work& work) {
    Seconds best;
    for (int i = 0; i < kRepeats; ++i) {
        const double before = coreSeconds();
        const Stopwatch watch;
        work();
        best.clock = std::min(best.clock, watch.seconds());
        best.cores = std::min(best.cores, coreSeconds() - before);
    }
    return best;
}

void print(const char* what, const Seconds& time, double scale, const char* unit) {
    std::printf("  %-28s %9.1f %s, %9.1f of cores\n", what, scale * time.clock, unit, scale * time.cores);
}

void measure(std::uint32_t count) {
    render::Device device(Gpu::shared().context(), Gpu::shared().compiler(), false);
    const std::vector<shared::Photon> photons = photonsInBox(count);
    const gpu::Array<shared::Photon> slots(device.context, std::span<const shared::Photon>(photons), "photons");
    const gpu::Array<shared::Photon> table(device.context, 2 * std::size_t{count}, "photon table");
    const auto walls = pointsOnWalls();
    const auto queries = static_cast<std::uint32_t>(walls.size());
    const gpu::Array<shared::VisiblePoint> points(device.context, std::span(walls), "visible points");
    const gpu::Array<vec3> gathered(device.context, queries, "gathered light");
    const gpu::Array<float> radii(device.context, queries, "radii");
    const render::DeviceScene deviceScene =
        render::uploadScene(device.context, device.tables, reference::test::cornellBox()); // of which nothing is read
    device.tables.set(TABLE_PHOTONS, table.buffer(), gpu::TexelFormat::Float4);
    render::PhotonTree tree(device);
    render::PhotonGrid grid(device);
    std::printf("%u photons\n", count);
    print("tree build", shortest([&] {
              tree.build(device, slots, count, table, 0);
              device.commands.finish();
          }),
          1e3, "ms");
    for (const std::uint32_t nearest : {50U, 200U}) {
        // Half as large again as the disc that the mean density fills with so many
        const auto radius = static_cast<float>(1.5 * std::sqrt(nearest * 24 / (0.9 * count * std::numbers::pi)));
        print("grid build", shortest([&] {
                  grid.build(device, slots, count, radius, table, count);
                  device.commands.finish();
              }),
              1e3, "ms");
        for (const auto structure : {render::PhotonStructure::Tree, render::PhotonStructure::Grid}) {
            const bool isTree = structure == render::PhotonStructure::Tree;
            render::RadianceEstimate estimate(device, deviceScene, structure, nearest);
            const std::string what = (isTree ? "tree, nearest " : "grid, nearest ") + std::to_string(nearest);
            print(what.c_str(), shortest([&] {
                      estimate.run(device, isTree ? tree.map() : grid.map(), points, queries,
                                   {nearest, radius, 1U << shared::kPhotonIndirect, 12}, {}, gathered, radii);
                      device.commands.finish();
                  }),
                  1e9 / queries, "ns a point");
        }
    }
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    try {
        for (int i = 1; i < argc; ++i) {
            measure(static_cast<std::uint32_t>(std::strtoul(argv[i], nullptr, 10)));
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
