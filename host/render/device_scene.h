// The scene on the device: what every integrator's kernels read.
#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel.h"
#include "scene/scene.h"

#include "shaders/shared/scene_records.h"

namespace hyalite::render {

struct DeviceScene {
    shared::CameraRecord camera;
    gpu::Array<shared::MaterialRecord> materials;
    gpu::Array<shared::LightRecord> lights;
    gpu::Array<shared::InstanceRecord> instances; // in device order, like the objects
    gpu::Array<glm::vec3> normals;                // three per triangle of the triangle table
    gpu::Array<glm::uvec4> nodes;
    gpu::Array<glm::vec4> objects;
    gpu::Array<glm::vec4> triangles;
    std::uint32_t rootNode = 0;
    std::uint32_t lightCount = 0;
    bool hasRoughLobes = false;            // whether camera paths leave rough points
    std::vector<std::uint32_t> objectOf;   // see ObjectTable
    std::vector<std::uint32_t> leafOf;     // see ObjectTable
    std::vector<std::uint32_t> triangleOf; // see MeshTables::fileOrder
    gpu::Specialization specialization;    // what the scene does not have, kernels leave out
};

[[nodiscard]] shared::CameraRecord cameraRecord(const Camera& camera);

// Point lights in order, then emitting objects in order; pmf in proportion to the mean of the flux's three channels.
[[nodiscard]] std::vector<shared::LightRecord> lightRecords(const Scene& scene);

// Builds the hierarchies, uploads everything and shows the hot tables at their bindings; the result must outlive the
// tables' use.
[[nodiscard]] DeviceScene uploadScene(const gpu::Context& context, gpu::TexelTables& tables, const Scene& scene);

} // namespace hyalite::render
