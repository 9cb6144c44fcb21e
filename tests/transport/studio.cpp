#include "transport/studio.h"

#include <glm/gtc/matrix_transform.hpp>

namespace hyalite::testing {

using glm::dvec3;

dvec3 Placement::direction(const dvec3& d) const {
    return dvec3(glm::rotate(glm::dmat4(1), glm::radians(degrees), axis) * glm::dvec4(d, 0));
}

dvec3 Placement::point(const dvec3& p) const {
    return direction(scale * p) + move;
}

std::string Placement::transform() const {
    return text("[{scale: ", scale, "}, {rotate: {axis: ", axis, ", degrees: ", degrees, "}}, {translate: ", move,
                "}]");
}

std::string Studio::at(const Placement& placement) const {
    std::string scene =
        text("camera: {position: ", placement.point(eye), ", look_at: ", placement.point(target),
             ", up: ", placement.direction(up), ", fov: ", fov, ", resolution: [8, 8]}\n", "render: {", settings,
             "max_depth: 12, passes: 2, photons: 2000, caustic_photons: 2000, radius: ", searchRadius * placement.scale,
             ", caustic_radius: ", searchRadius * placement.scale, "}\n", "materials: {", materials,
             "}\nlights:", points.empty() && lights.empty() ? " []\n" : "\n");
    for (const PointOfLight& light : points) {
        scene += text("  - {type: point, position: ", placement.point(light.position),
                      ", intensity: ", light.intensity * placement.scale * placement.scale, "}\n");
    }
    for (const std::string& light : lights) {
        scene += "  - {" + light + "}\n";
    }
    scene += "objects:\n";
    for (const std::string& object : objects) {
        scene += "  - {" + object + ", transform: " + placement.transform() + "}\n";
    }
    return scene;
}

Studio studioWith(const std::vector<std::string>& objects, const std::string& material) {
    Studio studio;
    studio.materials = "floor: {type: diffuse, albedo: 0.7}, wall: {type: diffuse, albedo: 0.4}, m: " + material;
    studio.points = {{{1.5, 2, 1.5}, 3}};
    studio.objects = {"shape: {type: quad, corner: [-2, 0, 2], edges: [[4, 0, 0], [0, 0, -4]]}, material: floor",
                      "shape: {type: quad, corner: [-2, 0, -1.5], edges: [[4, 0, 0], [0, 3, 0]]}, material: wall",
                      "shape: {type: quad, corner: [-0.5, 2.8, -0.5], edges: [[1, 0, 0], [0, 0, 1]]}, emission: 8"};
    studio.objects.insert(studio.objects.end(), objects.begin(), objects.end());
    return studio;
}

Studio furnishedStudio() {
    Studio studio = studioWith(
        {"shape: {type: sphere, center: [0.5, 0.45, 0.3], radius: 0.4}, material: glass",
         "shape: {type: box, min: [-1.2, 0.01, -0.8], max: [-0.6, 0.8, -0.2]}, material: mirror",
         "shape: {type: torus, center: [-0.2, 0.25, 0.6], axis: [0.2, 1, 0.3], major: 0.3, minor: 0.1}, material: m",
         "shape: {type: csg, op: difference, left: {type: box, min: [0.8, 0.1, -1], max: [1.5, 1.2, -0.4]}, right: "
         "{type: sphere, center: [0.9, 1.1, -0.4], radius: 0.4}}, material: metal"});
    studio.materials += ", glass: {type: dielectric}, mirror: {type: mirror, reflectance: 0.9}, metal: {type: "
                        "conductor, metal: gold, roughness: 0.4}";
    return studio;
}

} // namespace hyalite::testing
