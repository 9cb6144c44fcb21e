// One scene on both sides, and the conversion of the device's records to the reference's: numbers exactly, indices
// through the tables from the upload.
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
    // Keeps a reference to the scene.
    Sides(const Scene& scene, const render::DeviceScene& deviceScene);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const reference::World& world() const { return world_; }
    [[nodiscard]] double scale() const { return scale_; }               // largest coordinate of scene and camera [m]
    [[nodiscard]] bool hasRoughLobes() const { return hasRoughLobes_; } // the device's camera paths leave rough points

    [[nodiscard]] reference::Ray toTwin(const shared::Ray& ray) const;
    [[nodiscard]] std::optional<reference::Hit> toTwin(const shared::Hit& hit) const;
    [[nodiscard]] reference::CameraPath toTwin(const shared::CameraPath& path) const;
    [[nodiscard]] reference::PhotonPath toTwin(const shared::PhotonPath& path) const;
    [[nodiscard]] reference::VisiblePoint toTwin(const shared::VisiblePoint& x, Nudge nudge = Nudge(0)) const;
    [[nodiscard]] reference::RoughPoint toTwin(const shared::RoughPoint& x, Nudge nudge = Nudge(0)) const;
    // True if light on the point can reach the pixel at all.
    [[nodiscard]] bool reflects(const shared::VisiblePoint& x) const;
    // A stored photon; its number is 0, because the device does not store one.
    [[nodiscard]] reference::Photon toTwin(const shared::Photon& photon) const;

    // The device's word for a list of media, and back.
    [[nodiscard]] std::uint32_t numberOf(const reference::Media& media) const;
    [[nodiscard]] reference::Media media(std::uint32_t word) const;
    // The material of the medium that such a word stands for; kNone: none.
    [[nodiscard]] std::uint32_t mediumOf(std::uint32_t word) const;

    // The nearest hit of a ray that leaves the object given by `from` (see shared::Ray). A hit at its start, within
    // rounding of that object's surface, does not count.
    [[nodiscard]] std::optional<reference::Hit> trace(const reference::Ray& ray, std::uint32_t from) const;

    // The device's hit, with its distance along the ray in double precision if the twin hits the same surface there: in
    // single precision, points would not lie on curved surfaces.
    [[nodiscard]] std::optional<reference::Hit> refined(const reference::Ray& ray, std::uint32_t from,
                                                        const shared::Hit& hit) const;

    // True if the objects hit by device and twin touch: then either is hit, and both mean the same.
    [[nodiscard]] bool touch(const std::optional<reference::Hit>& device,
                             const std::optional<reference::Hit>& twin) const;
    // True if the surfaces hit by device and twin coincide, so that rounding decides which one is hit. Moving the ray
    // would not separate them.
    [[nodiscard]] bool areInOnePlace(const reference::Ray& ray, const std::optional<reference::Hit>& device,
                                     const std::optional<reference::Hit>& twin) const;

private:
    // The material of a surface with its textures, evaluated at the point as moved by the nudge.
    [[nodiscard]] MaterialModel materialAt(std::uint32_t number, const glm::dvec3& position, const glm::dvec2& uv,
                                           Nudge nudge) const;
    [[nodiscard]] const Material* material(std::uint32_t number) const;

    const Scene& scene_;
    std::vector<std::uint32_t> objectOf_; // see render::DeviceScene
    std::vector<std::uint32_t> leafOf_;
    std::vector<std::uint32_t> triangleOf_;
    reference::World world_;
    double scale_;
    bool hasRoughLobes_;
};

// Decodes a direction packed as a point of the unfolded octahedron with `bits` bits per coordinate [Cigolle14]; the
// result is not normalised.
[[nodiscard]] glm::dvec3 unpackDirection(std::uint32_t packed, std::uint32_t bits);

} // namespace hyalite::parity
