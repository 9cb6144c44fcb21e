// One bounce of camera paths on the device.
#pragma once

#include "kernel/kernel_support.h"
#include "reference/integrators/shading.h"

#include <numeric>

namespace hyalite::testing {

// Output of a bounce. Visible points and emission are indexed by path, which must be its pixel.
struct Bounce {
    gpu::Array<shared::Ray> rays;
    gpu::Array<shared::Hit> hits;
    gpu::Array<shared::CameraPath> paths;
    gpu::Array<shared::VisiblePoint> visible;
    gpu::Array<vec3> emitted;
    gpu::Array<shared::Ray> nextRays;
    gpu::Array<shared::CameraPath> nextPaths;
    gpu::Array<shared::uint> alive;
    gpu::Array<shared::RoughPoint> rough;
    std::size_t slotsOfPath = 1;
    gpu::Array<vec3> light = {}; // for a level of a tree: direct light included

    [[nodiscard]] std::size_t slot(std::size_t path, std::size_t child) const { return slotsOfPath * path + child; }
    [[nodiscard]] bool goesOn(std::size_t path, std::size_t child = 0) const { return child < alive.host()[path]; }
};

// Next rays that a path follows: one, as in trace_closest and shade_surface, or all, as in trace_whitted.
enum class Ways { One, All };

inline Bounce shade(BothSides& both, const std::vector<shared::Ray>& rays, const std::vector<shared::CameraPath>& paths,
                    std::uint32_t depth, std::uint32_t pass, Ways ways) {
    const auto count = static_cast<std::uint32_t>(rays.size());
    const std::size_t slotsOfPath = ways == Ways::All ? 2 : 1;
    Bounce b{both.upload(rays),
             both.room<shared::Hit>(count),
             both.upload(paths),
             both.upload(std::vector<shared::VisiblePoint>(count)),
             both.upload(std::vector<vec3>(count, vec3(0))),
             both.room<shared::Ray>(slotsOfPath * count),
             both.room<shared::CameraPath>(slotsOfPath * count),
             both.room<shared::uint>(count),
             both.room<shared::RoughPoint>(count),
             slotsOfPath};
    const auto& d = both.deviceScene;
    const std::uint32_t maxDepth = both.scene.render.maxDepth;
    if (ways == Ways::One) {
        both.run("trace_closest", shared::TraceClosestArguments{b.rays, b.hits, count, d.rootNode, 13, {}}, count);
        both.run("shade_surface",
                 shared::ShadeSurfaceArguments{b.rays,
                                               b.hits,
                                               b.paths,
                                               d.materials,
                                               d.lights,
                                               d.normals,
                                               d.instances,
                                               b.visible,
                                               b.emitted,
                                               b.nextRays,
                                               b.nextPaths,
                                               b.alive,
                                               count,
                                               depth,
                                               maxDepth,
                                               pass,
                                               b.rough,
                                               13,
                                               {}},
                 count);
        return b;
    }
    std::vector<shared::uint> slots(count); // backwards
    std::iota(slots.rbegin(), slots.rend(), 0U);
    const auto deviceSlots = both.upload(slots);
    const auto pixels = both.room<shared::uint>(count);
    const auto before = both.upload(std::vector<shared::Ray>(rays.rbegin(), rays.rend()));
    const auto pathsBefore = both.upload(std::vector<shared::CameraPath>(paths.rbegin(), paths.rend()));
    b.light = both.room<vec3>(count);
    both.run("trace_whitted",
             shared::TraceWhittedArguments{.slots = deviceSlots,
                                           .rays = before,
                                           .paths = pathsBefore,
                                           .materials = d.materials,
                                           .lights = d.lights,
                                           .normals = d.normals,
                                           .instances = d.instances,
                                           .light = b.light,
                                           .pixels = pixels,
                                           .roughPoints = b.rough,
                                           .nextRays = b.nextRays,
                                           .nextPaths = b.nextPaths,
                                           .alive = b.alive,
                                           .seed = {},
                                           .camera = {},
                                           .count = count,
                                           .depths = depth + shared::kDepthsUnit * (maxDepth + 1),
                                           .pass = pass,
                                           .minWeight = static_cast<float>(both.scene.render.minWeight),
                                           .lightCount = d.lightCount,
                                           .rootNode = d.rootNode,
                                           .keptRays = b.rays,
                                           .keptPaths = b.paths,
                                           .hits = b.hits,
                                           .emitted = b.emitted,
                                           .visiblePoints = b.visible,
                                           .live = {},
                                           .rayCount = {}},
             count);
    return b;
}

// The reference's next rays, in the order of their slots.
inline std::vector<reference::NextRay> waysOf(const reference::Shading& shading) {
    std::vector<reference::NextRay> ways;
    for (const std::optional<reference::NextRay>& next : shading.next) {
        if (next) {
            ways.push_back(*next);
        }
    }
    return ways;
}

} // namespace hyalite::testing
