// Measures the photon maps: `measure_photon_maps PHOTONS…` builds a tree and a grid over so many photons on the walls
// of a box, a tenth of them heaped up as in a caustic, and prints how long that takes.
#include "base/stopwatch.h"
#include "kernel/photon_sets.h"
#include "render/photon_grid.h"
#include "render/photon_tree.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

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

template <class Work>
double shortest(const Work& work) {
    double best = INFINITY;
    for (int i = 0; i < kRepeats; ++i) {
        const Stopwatch watch;
        work();
        best = std::min(best, watch.seconds());
    }
    return best;
}

void measure(std::uint32_t count) {
    render::Device device(Gpu::shared().context(), Gpu::shared().compiler(), true);
    const std::vector<shared::Photon> photons = photonsInBox(count);
    const gpu::Array<shared::Photon> slots(device.context, std::span<const shared::Photon>(photons), "photons");
    const gpu::Array<shared::Photon> table(device.context, count, "photon table");
    render::PhotonTree tree(device);
    render::PhotonGrid grid(device);
    const double treeSeconds = shortest([&] {
        tree.build(device, slots, count, table, 0);
        device.commands.finish();
    });
    const double gridSeconds = shortest([&] {
        grid.build(device, slots, count, 0.02F);
        device.commands.finish();
    });
    std::printf("%u photons: tree %.1f ms, grid %.1f ms\n", count, 1e3 * treeSeconds, 1e3 * gridSeconds);
    for (const auto& [kernel, time] : device.commands.times()) {
        std::printf("  %-20s %8.2f ms a build in %llu dispatches\n", kernel.c_str(), 1e3 * time.seconds / kRepeats,
                    static_cast<unsigned long long>(time.dispatches / kRepeats));
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
