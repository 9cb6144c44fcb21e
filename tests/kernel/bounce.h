// One bounce of camera paths on the device.
#pragma once

#include "kernel/kernel_support.h"

namespace hyalite::testing {

// Runs trace_closest and shade_surface on given rays, as one bounce of a render does.
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
};

inline Bounce shade(BothSides& both, const std::vector<shared::Ray>& rays, const std::vector<shared::CameraPath>& paths,
                    std::uint32_t depth, std::uint32_t pass, std::uint32_t split) {
    const auto count = static_cast<std::uint32_t>(rays.size());
    const std::size_t slots = (1 + split) * std::size_t{count};
    Bounce b{both.upload(rays),
             both.room<shared::Hit>(count),
             both.upload(paths),
             both.upload(std::vector<shared::VisiblePoint>(count)),
             both.upload(std::vector<vec3>(count, vec3(0))),
             both.room<shared::Ray>(slots),
             both.room<shared::CameraPath>(slots),
             both.room<shared::uint>(slots),
             both.room<shared::RoughPoint>(count)};
    both.run("trace_closest", shared::TraceClosestArguments{b.rays, b.hits, count, both.deviceScene.rootNode, 13},
             count);
    const std::uint32_t maxDepth = both.scene.render.maxDepth + split;
    const auto minWeight = split != 0 ? static_cast<float>(both.scene.render.minWeight) : 0.0F;
    const auto& d = both.deviceScene;
    both.run("shade_surface",
             shared::ShadeSurfaceArguments{b.rays,      b.hits,      b.paths,   d.materials, d.lights,
                                           d.normals,   d.instances, b.visible, b.emitted,   b.nextRays,
                                           b.nextPaths, b.alive,     count,     depth,       maxDepth,
                                           pass,        split,       minWeight, b.rough,     13},
             count);
    return b;
}

} // namespace hyalite::testing
