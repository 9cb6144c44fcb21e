// The scene on the device: the input of every integrator's kernels.
#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel.h"
#include "scene/model/scene.h"

#include "shaders/shared/scene_records.h"

namespace hyalite::render {

struct DeviceScene {
    shared::CameraRecord camera;
    gpu::Array<shared::MaterialRecord> materials;
    gpu::Array<shared::LightRecord> lights; // they refer to elements of the next five
    gpu::Array<shared::LightTriangle> lightTriangles;
    gpu::Array<glm::vec3> lightTexels;
    gpu::Array<float> lightCdfs;
    gpu::Array<shared::LightNode> lightNodes;
    gpu::Array<shared::LightHierarchy> lightHierarchy; // one
    gpu::Array<shared::InstanceRecord> instances;      // in device order, like the objects
    gpu::Array<std::uint32_t> neighbors;               // the instances refer to its elements
    gpu::Array<glm::vec3> normals;                     // three for each triangle with normals; those come first
    gpu::Array<glm::uvec4> geometry;                   // triangles, then nodes
    gpu::Array<glm::vec4> objects;
    gpu::Array<glm::vec4> textures;
    gpu::Array<glm::vec4> textureCoordinates; // of the triangles
    std::uint32_t rootNode = 0;
    std::uint32_t lightCount = 0;
    gpu::Array<shared::TargetRecord> targets; // aims of caustic photons
    std::uint32_t targetCount = 0;
    bool hasRoughLobes = false;            // camera paths leave rough points
    std::vector<std::uint32_t> objectOf;   // see ObjectTable
    std::vector<std::uint32_t> leafOf;     // see ObjectTable
    std::vector<std::uint32_t> triangleOf; // see MeshTables::fileOrder
    gpu::Specialization specialization;    // kernels omit features that the scene lacks

    // The picture's width if this many elements are its pixels, else 0: see shaders/shared/pixel_order.h.
    [[nodiscard]] std::uint32_t widthOf(std::uint32_t count) const {
        return count == camera.width * camera.height ? camera.width : 0;
    }
};

// With the media around the scene's camera.
[[nodiscard]] shared::CameraRecord cameraRecord(const Scene& scene);

// Builds the hierarchies, uploads everything and binds the hot tables; the result must outlive the tables' use.
[[nodiscard]] DeviceScene uploadScene(const gpu::Context& context, gpu::TexelTables& tables, const Scene& scene);

} // namespace hyalite::render
