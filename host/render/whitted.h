// Recursive reflection and refraction [Whitted80], the recursion unrolled into one queue per level of the tree.
#pragma once

#include "render/device_scene.h"
#include "render/film.h"
#include "render/integrator.h"
#include "render/path_queue.h"
#include "render/rough_light.h"

namespace hyalite::render {

class Whitted final : public PassIntegrator {
public:
    // The layers of its film.
    [[nodiscard]] static std::vector<LayerKind> layers() { return {{"radiance"}}; }

    // References are kept.
    Whitted(Device& device, const Scene& scene, const DeviceScene& deviceScene, const Film& film);

    void renderPass(std::uint32_t pass) override;

private:
    // Everything that has one element per ray of a level, or two where children wait for their place.
    struct Level {
        CameraQueue queue;
        gpu::Array<shared::VisiblePoint> visiblePoints;
        gpu::Array<shared::RoughPoint> roughPoints;
        gpu::Array<shared::Ray> shadowRays;
        gpu::Array<glm::vec3> contributions;
        gpu::Array<glm::vec3> emitted;
        gpu::Array<glm::vec3> direct;

        Level(const gpu::Context& context, std::uint32_t capacity, std::uint32_t roughPointCount);
    };

    void shade(std::uint32_t pass, std::uint32_t depth);
    void sampleEveryLight(std::uint32_t pass);
    void descend();

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    const Film& film_;

    gpu::Kernel generateCameraRays_;
    gpu::Kernel traceClosest_;
    gpu::Kernel shadeSurface_;
    gpu::Kernel sampleLights_;
    gpu::Kernel traceShadow_;
    gpu::Kernel sumPaths_;
    CameraCompaction compaction_;
    RoughLight roughLight_;
    Level level_;
    gpu::Array<glm::vec3> radiance_; // of the pass, by pixel
};

} // namespace hyalite::render
