// Recursive reflection and refraction [Whitted80], with the recursion unrolled into the levels of all pixels' ray
// trees.
#pragma once

#include "render/integrators/integrator.h"
#include "render/upload/device_scene.h"
#include "render/wavefront/device_counter.h"
#include "render/wavefront/next_rays.h"
#include "render/wavefront/rough_light.h"

#include <array>

namespace hyalite::render {

class Whitted final : public PassIntegrator {
public:
    [[nodiscard]] static IntegratorKind kind();

    explicit Whitted(const IntegratorInput& input);

    void renderPass(std::uint32_t pass) override;

private:
    // The buffers with one element per ray of a level, or two for its next rays.
    struct Level {
        gpu::Array<shared::uint> slots;   // slots of the previous level that hold this level's rays
        gpu::Array<shared::Ray> nextRays; // two slots each
        gpu::Array<shared::CameraPath> nextPaths;
        gpu::Array<shared::uint> alive; // slots in use
        gpu::Array<shared::uint> pixels;
        gpu::Array<glm::vec3> light;
        gpu::Array<shared::RoughPoint> roughPoints;

        [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(alive.count()); }
    };
    // The additional buffers that a level writes for observers.
    struct Kept {
        gpu::Array<shared::Ray> rays;
        gpu::Array<shared::CameraPath> paths;
        gpu::Array<shared::Hit> hits;
        gpu::Array<glm::vec3> emitted;
        gpu::Array<shared::VisiblePoint> visiblePoints;
    };

    // Makes room for `count` rays of the level at this depth; replacing buffers loses their contents.
    Level& levelFor(std::uint32_t depth, std::uint32_t count);
    void keepFor(std::uint32_t count);
    // Traces the trees of all pixels and returns the number of rays in each level. Levels have the capacity of earlier
    // passes; only with `waits` it waits for the device at every level and makes room for the next one.
    [[nodiscard]] std::vector<std::uint32_t> traceTrees(std::uint32_t pass, bool waits);
    // Lists the rays of the next level.
    void listNext(std::uint32_t depth, bool waits);
    // Did each level have room for this many rays?
    [[nodiscard]] bool hadRoom(const std::vector<std::uint32_t>& rays) const;
    void trace(std::uint32_t pass, std::uint32_t depth);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    Film& film_;

    gpu::Kernel traceWhitted_;
    gpu::Kernel sumPaths_;
    NextRays nextRays_;
    QueueSizes sizes_; // sizes of the levels
    RoughLight roughLight_;
    DeviceCounter shadowRays_;
    std::array<Level, 2> levels_; // of even and odd depth: each reads the output of the other
    Kept kept_;
    gpu::Array<glm::vec3> radiance_; // of the pass, per pixel
};

} // namespace hyalite::render
