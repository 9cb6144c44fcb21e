// Recursive reflection and refraction [Whitted80], the recursion unrolled into the levels of the trees of all pixels.
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
    // Everything that has one element per ray of a level, or two for the rays that go on from it.
    struct Level {
        gpu::Array<shared::uint> slots;   // of the level before, where this one's rays stand
        gpu::Array<shared::Ray> nextRays; // two slots each
        gpu::Array<shared::CameraPath> nextPaths;
        gpu::Array<shared::uint> alive; // slots in use
        gpu::Array<shared::uint> pixels;
        gpu::Array<glm::vec3> light;
        gpu::Array<shared::RoughPoint> roughPoints;

        [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(alive.count()); }
    };
    // What a level also leaves for who looks on.
    struct Kept {
        gpu::Array<shared::Ray> rays;
        gpu::Array<shared::CameraPath> paths;
        gpu::Array<shared::Hit> hits;
        gpu::Array<glm::vec3> emitted;
        gpu::Array<shared::VisiblePoint> visiblePoints;
    };

    // Makes room for `count` rays of the level at this depth, whose last contents are lost if there was not enough.
    Level& levelFor(std::uint32_t depth, std::uint32_t count);
    void keepFor(std::uint32_t count);
    // Traces the trees of all pixels and returns how many rays each level has. Levels have the room of the passes
    // before; only if it `waits` for the device at every level it makes room for what comes.
    [[nodiscard]] std::vector<std::uint32_t> traceTrees(std::uint32_t pass, bool waits);
    // Lists the rays of the level below this one.
    void listNext(std::uint32_t depth, bool waits);
    // Had each level room for so many rays?
    [[nodiscard]] bool hadRoom(const std::vector<std::uint32_t>& rays) const;
    void trace(std::uint32_t pass, std::uint32_t depth);

    Device& device_;
    const Scene& scene_;
    const DeviceScene& deviceScene_;
    Film& film_;

    gpu::Kernel traceWhitted_;
    gpu::Kernel sumPaths_;
    NextRays nextRays_;
    QueueSizes sizes_; // of the levels
    RoughLight roughLight_;
    DeviceCounter shadowRays_;
    std::array<Level, 2> levels_; // of even and of odd depth: each reads what the one before has left
    Kept kept_;
    gpu::Array<glm::vec3> radiance_; // of the pass, by pixel
};

} // namespace hyalite::render
