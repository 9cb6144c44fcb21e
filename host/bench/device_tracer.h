// Rays traced by the kernels trace_closest and trace_shadow.
#pragma once

#include "bench/ray_tracer.h"

namespace hyalite::bench {

class DeviceTracer final : public RayTracer {
public:
    // References are kept.
    DeviceTracer(render::Device& device, const render::DeviceScene& deviceScene);

    void load(const RaySet& set) override;
    void trace() override;
    [[nodiscard]] std::vector<float> ends() const override;

private:
    render::Device& device_;
    const render::DeviceScene& deviceScene_;
    gpu::Kernel traceClosest_;
    gpu::Kernel traceShadow_;
    bool shadow_ = false;
    gpu::Array<shared::Ray> rays_;
    gpu::Array<shared::Hit> hits_;
    gpu::Array<glm::vec3> contributions_;
    gpu::Array<glm::vec3> direct_;
};

} // namespace hyalite::bench
