// One scene on both sides, and how the device's records read in the reference's terms: numbers exactly, indices by the
// tables that the upload left.
#pragma once

#include "parity/nudge.h"
#include "reference/integrators/shading.h"
#include "reference/lights/rough_light.h"
#include "reference/photons/photons.h"
#include "reference/world.h"
#include "render/upload/device_scene.h"

#include "shaders/shared/path_records.h"

#include <optional>

namespace hyalite::parity {

class Sides {
public:
    // A reference to the scene is kept.
    Sides(const Scene& scene, const render::DeviceScene& deviceScene);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const reference::World& world() const { return world_; }
    [[nodiscard]] double scale() const { return scale_; } // largest coordinate of scene and camera [m]

    [[nodiscard]] reference::Ray toTwin(const shared::Ray& ray) const;
    [[nodiscard]] std::optional<reference::Hit> toTwin(const shared::Hit& hit) const;
    [[nodiscard]] reference::CameraPath toTwin(const shared::CameraPath& path) const;
    [[nodiscard]] reference::PhotonPath toTwin(const shared::PhotonPath& path) const;
    [[nodiscard]] reference::VisiblePoint toTwin(const shared::VisiblePoint& x, Nudge nudge = Nudge(0)) const;
    [[nodiscard]] reference::RoughPoint toTwin(const shared::RoughPoint& x, Nudge nudge = Nudge(0)) const;
    // Whether light that falls on the point reaches the pixel at all.
    [[nodiscard]] bool reflects(const shared::VisiblePoint& x) const;
    // A stored photon; with a number of 0, which the device's does not have.
    [[nodiscard]] reference::Photon toTwin(const shared::Photon& photon) const;

    // The device's number of a material of the world.
    [[nodiscard]] std::uint32_t numberOf(const Material* material) const;

    // The nearest hit of a ray that leaves the object which `from` names (see shared::Ray): where it starts, to within
    // rounding on that object's surface, is none.
    [[nodiscard]] std::optional<reference::Hit> trace(const reference::Ray& ray, std::uint32_t from) const;

    // The device's hit, its distance along the ray in double precision where the twin meets the same surface there:
    // with less, points of curved surfaces would not be on them.
    [[nodiscard]] std::optional<reference::Hit> refined(const reference::Ray& ray, std::uint32_t from,
                                                        const shared::Hit& hit) const;

    // Do surfaces coincide where device and twin met them, so that a rounding says which is met? A move of the ray
    // would not part them.
    [[nodiscard]] bool areInOnePlace(const reference::Ray& ray, const std::optional<reference::Hit>& device,
                                     const std::optional<reference::Hit>& twin) const;

private:
    // The material of a surface with its textures, looked up where the nudge moves the point to.
    [[nodiscard]] MaterialModel materialAt(std::uint32_t number, const glm::dvec3& position, const glm::dvec2& uv,
                                           Nudge nudge) const;
    [[nodiscard]] const Material* material(std::uint32_t number) const;

    const Scene& scene_;
    std::vector<std::uint32_t> objectOf_; // see render::DeviceScene
    std::vector<std::uint32_t> leafOf_;
    std::vector<std::uint32_t> triangleOf_;
    reference::World world_;
    double scale_;
};

// A vector of the direction that was packed as a point of the unfolded octahedron, `bits` a coordinate [Cigolle14]; its
// length says nothing.
[[nodiscard]] glm::dvec3 unpackDirection(std::uint32_t packed, std::uint32_t bits);

} // namespace hyalite::parity
