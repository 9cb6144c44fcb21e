#include "bench/embree_tracer.h"

#include "base/parallel.h"

#include <algorithm>
#include <limits>
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace hyalite::bench {

namespace {

using glm::dmat4;
using glm::dvec4;
using glm::vec3;

constexpr std::size_t kRaysPerPiece = 1024;

// Versions 3 and 4 differ in how they take a ray.
#if RTC_VERSION_MAJOR >= 4
void intersect(RTCScene scene, RTCRayHit& ray) {
    rtcIntersect1(scene, &ray);
}
void occluded(RTCScene scene, RTCRay& ray) {
    rtcOccluded1(scene, &ray);
}
#else
void intersect(RTCScene scene, RTCRayHit& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
}
void occluded(RTCScene scene, RTCRay& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
}
#endif

RTCRay embreeRay(const shared::Ray& ray) {
    RTCRay r{};
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.tnear = 0;
    r.tfar = ray.tMax;
    r.mask = ~0U;
    return r;
}

class EmbreeTracer final : public RayTracer {
public:
    explicit EmbreeTracer(const Scene& scene) : device_(rtcNewDevice(nullptr)), scene_(newScene()) {
        std::vector<std::size_t> uses(scene.meshes.size());
        for (const Object& object : scene.objects) {
            if (const auto* instance = std::get_if<MeshInstance>(&object.shape)) {
                ++uses[instance->mesh];
            }
        }
        std::vector<RTCScene> shared(scene.meshes.size(), nullptr);
        for (const Object& object : scene.objects) {
            if (const auto* quad = std::get_if<Quad>(&object.shape)) {
                attachQuad(*quad);
            } else {
                const auto& instance = std::get<MeshInstance>(object.shape);
                const Mesh& mesh = scene.meshes[instance.mesh];
                RTCScene& own = shared[instance.mesh];
                if (uses[instance.mesh] == 1) {
                    attach(scene_, mesh.positions, mesh.triangles, instance.objectToWorld);
                    continue;
                }
                if (own == nullptr) {
                    own = newScene();
                    attach(own, mesh.positions, mesh.triangles, dmat4(1));
                    rtcCommitScene(own);
                }
                attachInstance(own, instance.objectToWorld);
            }
        }
        for (RTCScene own : shared) {
            if (own != nullptr) {
                rtcReleaseScene(own); // its instances keep it
            }
        }
        rtcCommitScene(scene_);
    }
    ~EmbreeTracer() override {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeTracer(const EmbreeTracer&) = delete;
    EmbreeTracer& operator=(const EmbreeTracer&) = delete;

    void load(const RaySet& set) override {
        set_ = &set;
        ends_.resize(set.rays.size());
    }

    void trace() override {
        parallelFor(ends_.size(), kRaysPerPiece, [this](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                ends_[i] = set_->shadow ? traceShadow(set_->rays[i]) : traceClosest(set_->rays[i]);
            }
        });
    }

    [[nodiscard]] std::vector<float> ends() const override { return ends_; }

private:
    static constexpr float kNothing = std::numeric_limits<float>::infinity();

    [[nodiscard]] float traceClosest(const shared::Ray& ray) const {
        RTCRayHit hit{};
        hit.ray = embreeRay(ray);
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        intersect(scene_, hit);
        return hit.hit.geomID == RTC_INVALID_GEOMETRY_ID ? kNothing : hit.ray.tfar;
    }
    [[nodiscard]] float traceShadow(const shared::Ray& ray) const {
        RTCRay r = embreeRay(ray);
        occluded(scene_, r);
        return r.tfar < 0 ? 0 : kNothing; // Embree sets it to minus infinity if the ray is occluded
    }

    [[nodiscard]] RTCScene newScene() const {
        RTCScene scene = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
        return scene;
    }
    void commit(RTCScene scene, RTCGeometry geometry) const {
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
    }
    void attach(RTCScene scene, const std::vector<vec3>& positions, const std::vector<glm::uvec3>& triangles,
                const dmat4& objectToWorld) const {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                                    RTC_FORMAT_FLOAT3, sizeof(vec3), positions.size()));
        std::ranges::transform(positions, vertices, [&](const vec3& p) { return vec3(objectToWorld * dvec4(p, 1)); });
        auto* corners = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), triangles.size()));
        std::ranges::copy(triangles, corners);
        commit(scene, geometry);
    }
    void attachQuad(const Quad& quad) const {
        const std::vector<vec3> corners = {quad.corner, quad.corner + quad.edge0, quad.corner + quad.edge0 + quad.edge1,
                                           quad.corner + quad.edge1};
        attach(scene_, corners, {{0, 1, 2}, {0, 2, 3}}, dmat4(1));
    }
    void attachInstance(RTCScene shared, const dmat4& objectToWorld) const {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(geometry, shared);
        const glm::mat4 matrix(objectToWorld);
        rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &matrix[0][0]);
        commit(scene_, geometry);
    }

    RTCDevice device_;
    RTCScene scene_;
    const RaySet* set_ = nullptr;
    std::vector<float> ends_;
};

} // namespace

std::string embreeVersion() {
    return "Embree " RTC_VERSION_STRING;
}

std::unique_ptr<RayTracer> makeEmbreeTracer(const Scene& scene) {
    const bool trianglesOnly = std::ranges::all_of(scene.objects, [](const Object& object) {
        return std::holds_alternative<Quad>(object.shape) || std::holds_alternative<MeshInstance>(object.shape);
    });
    return trianglesOnly ? std::make_unique<EmbreeTracer>(scene) : nullptr;
}

} // namespace hyalite::bench
