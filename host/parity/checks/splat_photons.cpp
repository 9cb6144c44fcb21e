// Photons drawn as points in the picture.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct SplatFields : FieldSet<1> {
    const Field& count = exact("count", "edge of a pixel or silhouette");
};
constexpr SplatFields kSplats;

constexpr std::size_t kHidden = SIZE_MAX;

// Index of the counter that a photon increments; kHidden: none, the camera does not see the photon.
std::size_t counterOf(const Sides& sides, const shared::Photon& photon, Nudge nudge) {
    const reference::CameraFrame& camera = sides.world().camera;
    const dvec3 position = nudge.point(dvec3(photon.position), sides.scale());
    const dvec3 way = position - camera.position;
    const double depth = glm::dot(way, camera.forward);
    if (depth <= 0) {
        return kHidden;
    }
    const double x = glm::dot(way, camera.right) / glm::dot(camera.right, camera.right) / depth;
    const double y = glm::dot(way, camera.up) / glm::dot(camera.up, camera.up) / depth;
    const double column = std::floor((x + 1) / 2 * camera.width);
    const double row = std::floor((1 - y) / 2 * camera.height);
    if (column < 0 || row < 0 || column >= camera.width || row >= camera.height) {
        return kHidden;
    }
    // A surface within the first 99.9 % of the distance occludes it; its own surface does not
    const double distance = glm::length(way);
    if (reference::traceClosest(sides.world(),
                                {.origin = camera.position, .direction = way / distance, .tMax = 0.999 * distance})) {
        return kHidden;
    }
    const auto pixel = static_cast<std::size_t>(row) * camera.width + static_cast<std::size_t>(column);
    return 4 * pixel + (photon.surface >> shared::kKindShift & 3U);
}

void compareSplatPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SplatPhotonsArguments>();
    const std::size_t counters = std::size_t{4} * args.camera.width * args.camera.height;
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto before = stage.seen.before<shared::uint>(args.counts, counters);
    const auto after = stage.seen.after<shared::uint>(args.counts, counters);
    constexpr std::uint32_t kTries = 8;
    std::vector<std::uint32_t> expected(counters, 0);
    std::vector<std::uint32_t> perhaps(counters, 0); // photons that count here or elsewhere, depending on rounding
    for (const shared::Photon& photon : photons) {
        if (photon.surface == shared::kNone) {
            continue;
        }
        std::array<std::size_t, kTries> found{};
        for (std::uint32_t n = 0; n < kTries; ++n) {
            found.at(n) = counterOf(stage.sides, photon, Nudge(n));
        }
        if (found[0] != kHidden) {
            ++expected[found[0]];
        }
        if (std::ranges::count(found, found[0]) != kTries) {
            std::ranges::sort(found);
            const auto last = std::unique(found.begin(), found.end());
            std::for_each(found.begin(), last, [&](std::size_t counter) {
                if (counter != kHidden) {
                    ++perhaps[counter];
                }
            });
        }
    }
    for (std::size_t i = 0; i < counters; ++i) {
        const std::uint64_t counted = after[i] - before[i];
        Answer device;
        device.exact(kSplats.count, counted);
        stage.compare(i, device, [&](Nudge nudge) {
            const std::uint64_t low = expected[i] > perhaps[i] ? expected[i] - perhaps[i] : 0;
            const bool isPossible = counted >= low && counted <= std::uint64_t{expected[i]} + perhaps[i];
            Answer answer;
            answer.exact(kSplats.count, nudge.movesNothing() || !isPossible ? expected[i] : counted);
            return answer;
        });
    }
}

} // namespace

const Check kSplatPhotons{.kernel = "splat_photons", .compare = compareSplatPhotons, .fields = {kSplats.all()}};

} // namespace hyalite::parity
