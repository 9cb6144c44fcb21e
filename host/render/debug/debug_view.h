// Pictures of the scene rather than its light: normals, distances, path lengths. Only the first pass is drawn, because
// further passes would blur it.
#pragma once

#include "render/integrators/integrator.h"
#include "render/wavefront/camera_paths.h"

namespace hyalite::render {

enum class DebugQuantity {
    Normals, // shading normals at the first hits: from [-1, 1] to [0, 1]
    Depth,   // distance of the first hit [m]; 0: no hit
    Bounces, // segments from the camera to the first diffuse surface; 0: none was found
};

class DebugView final : public PassIntegrator {
public:
    [[nodiscard]] static std::vector<LayerKind> layers() { return {{"view"}}; }

    DebugView(const IntegratorInput& input, DebugQuantity quantity);

    void renderPass(std::uint32_t pass) override;

private:
    void drawSurfaces();
    void countSegments(std::uint32_t pass);

    Device& device_;
    const DeviceScene& deviceScene_;
    Film& film_;
    DebugQuantity quantity_;
    CameraPaths cameraPaths_;
    gpu::Kernel traceClosest_;
    gpu::Kernel showSurface_;
    gpu::Array<shared::VisiblePoint> visiblePoints_;
    gpu::Array<glm::vec3> emitted_;
    gpu::Array<glm::vec3> colors_;
};

} // namespace hyalite::render
