// Scenes whose sizes, places, lights or photons are out of proportion.
#include "transport/studio.h"
#include "transport/table.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr Sharpness kSharpness{.bias = 2e-3, .sees = 0.6};

Symmetry same(const std::string& name, const std::string& one, const std::string& other, const Names& claims,
              const Sharpness& sharpness = kSharpness) {
    return {.name = name, .whole = one, .parts = {other}, .claims = claims, .sharpness = sharpness};
}

} // namespace

// Far from the origin, and seen from afar.
std::vector<Symmetry> farSymmetries() {
    std::vector<Symmetry> rows;
    const Studio studio = furnishedStudio();
    const auto moved = [&](const char* name, const dvec3& move) {
        rows.push_back(
            same(name, studio.at(), studio.at({.move = move}), kAllIntegrators, {.bias = 0.01, .sees = 0.6}));
    };
    moved("the scene moved by 10 km", {10000, 10000, 10000});
    moved("the scene moved by 1000 km", {1e6, -1e6, 1e6});
    const auto fromAfar = [](const std::string& shape) {
        return text("camera: {position: [40000, 30000, 86600], look_at: [0, 0, 0], fov: 0.00126, resolution: [8, 8]}\n",
                    "render: {passes: 4, max_depth: 2}\nmaterials: {m: {type: diffuse, albedo: 0.8}}\nlights: [{type: "
                    "directional, direction: [-1, -1, -1], irradiance: 2}]\nobjects: [{shape: ",
                    shape, ", material: m}]\n");
    };
    const Names exact{"whitted", "path"};
    rows.push_back(same("an ellipsoid as a ball from 100 km", fromAfar("{type: sphere, radius: 1}"),
                        fromAfar("{type: ellipsoid, radii: [1, 1, 1]}"), exact, {.bias = 0.01, .sees = 0.2}));
    rows.push_back(same("a can as a cone from 100 km",
                        fromAfar("{type: cylinder, base: [0, -1, 0], top: [0, 1, 0], radius: 0.7}"),
                        fromAfar("{type: cone, base: [0, -1, 0], top: [0, 1, 0], radius: 0.7, top_radius: 0.7}"), exact,
                        {.bias = 0.01, .sees = 0.2}));
    rows.push_back(
        same("a ball as a csg from 100 km", fromAfar("{type: sphere, radius: 1}"),
             fromAfar("{type: csg, op: intersection, left: {type: ellipsoid, radii: [1, 1, 1]}, right: {type: box, "
                      "min: [-2, -2, -2], max: [2, 2, 2]}}"),
             exact, {.bias = 0.01, .sees = 0.2}));
    return rows;
}

// What stands outside a closed room does not change the picture inside.
std::vector<Symmetry> outsideSymmetries() {
    std::vector<Symmetry> rows;
    const auto room = [](const std::string& lights, const std::string& objects) {
        return text(
            "camera: {position: [0, 1.5, 1.9], look_at: [0, 0.5, -1], fov: 50, resolution: [8, 8]}\n",
            "render: {passes: 2, photons: 4000, caustic_photons: 0, radius: 0.3}\nmaterials: {w: {type: diffuse, "
            "albedo: 0.6}}\nlights:\n  - {type: point, position: [0, 2.5, 0], intensity: 5}\n",
            lights,
            "objects:\n  - {shape: {type: csg, op: difference, left: {type: box, min: [-2.2, -0.2, -2.2], max: [2.2, "
            "3.2, 2.2]}, right: {type: box, min: [-2, 0, -2], max: [2, 3, 2]}}, material: w}\n",
            objects);
    };
    const std::string ground =
        "  - {shape: {type: quad, corner: [-50, -0.25, -50], edges: [[0, 0, 100], [100, 0, 0]]}, "
        "material: w}\n";
    rows.push_back(same("a lamp in a room under a sun", room("", ground),
                        room("  - {type: directional, direction: [0.3, -1, 0.2], irradiance: 1000}\n", ground),
                        {"path", "ppm"}));
    rows.push_back(same("a lamp in a room under a sky", room("", ground),
                        room("  - {type: environment, radiance: 50}\n", ground), {"path", "ppm"}));
    return rows;
}

// One point or one focus, in scenes that are out of proportion.
std::vector<Row> proportionRows() {
    std::vector<Row> rows;
    // Flat ground that is a csg 100 m deep, seen from 5 cm: albedo E cos / pi
    rows.push_back({.name = "ground of a csg seen from 5 cm",
                    .scene =
                        "camera: {position: [0.03, 0.025, 0.04], look_at: [0, 0, 0], fov: 40, resolution: [16, 16]}\n"
                        "render: {max_depth: 2, passes: 1}\nmaterials: {w: {type: diffuse, albedo: 0.6}}\n"
                        "lights: [{type: directional, direction: [-1, -1, 0.5], irradiance: 3}]\nobjects:\n"
                        "  - {shape: {type: csg, op: difference, left: {type: box, min: [-100, -100, -100], max: [100, "
                        "0, 100]}, right: {type: box, min: [50, -1, 50], max: [60, 1, 60]}}, material: w}\n",
                    .expected = 0.6 * 3 * (1 / 1.5) / pi,
                    .claims = kAllIntegrators,
                    .sharpness = {.bias = 1e-4, .sees = 1e-3}});
    // Vertex normals at 60 degrees to a floor under a vertical beam of irradiance pi, straight or by way of a mirror:
    // L = cos 60 degrees
    const std::string tilted = "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nvn 0.8660254 0.5 0\nf 1//1 2//1 3//1 4//1\n";
    for (const bool straight : {true, false}) {
        const std::string light =
            straight ? "direction: [0, -1, 0], center: [0, 0.8, 0]" : "direction: [0, 1, 0], center: [0, 0.5, 0]";
        Row row{
            .name = text("smoothed normals, lit ", straight ? "straight" : "by way of a mirror"),
            .scene = text(
                cameraOver({0, 0, 0}, {0, 1, 0}, {0, 0, -1}, 0.1, 0.3),
                "render: {max_depth: 4, passes: 4, photons: 500, caustic_photons: 4000, radius: 0.1, caustic_radius: "
                "0.1, caustic_nearest: 512, caustic_filter: none, gather_rays: 0}\n",
                "materials: {w: {type: diffuse, albedo: 1}, m: {type: mirror}}\nlights: [{type: directional, ", light,
                ", irradiance: ", pi, ", radius: 0.9}]\nobjects:\n",
                "  - {shape: {type: mesh, file: tilted.obj}, material: w}\n",
                straight ? ""
                         : "  - {shape: {type: quad, corner: [-2, 1, -2], edges: [[4, 0, 0], [0, 0, 4]]}, "
                           "material: m}\n"),
            .expected = 0.5,
            .claims = straight ? kAllIntegrators : kPhotonIntegrators,
            .sharpness = {.bias = 1e-3, .sees = 0.2},
            .independent = Independent::Renders,
            .files = {{"tilted.obj", tilted}}};
        rows.push_back(row);
    }
    return rows;
}

} // namespace hyalite::testing
