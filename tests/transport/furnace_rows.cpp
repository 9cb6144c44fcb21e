// Shapes of every kind in a furnace of radiance 1: what absorbs nothing cannot be seen.
#include "transport/scene_text.h"
#include "transport/table.h"

namespace hyalite::testing {

namespace {

constexpr std::string_view kIcosahedron = "v 0 1 1.618034\nv 0 -1 1.618034\nv 0 1 -1.618034\nv 0 -1 -1.618034\n"
                                          "v 1 1.618034 0\nv -1 1.618034 0\nv 1 -1.618034 0\nv -1 -1.618034 0\n"
                                          "v 1.618034 0 1\nv -1.618034 0 1\nv 1.618034 0 -1\nv -1.618034 0 -1\n"
                                          "f 1 2 9\nf 1 9 5\nf 1 5 6\nf 1 6 10\nf 1 10 2\nf 2 7 9\nf 9 7 11\n"
                                          "f 9 11 5\nf 5 11 3\nf 5 3 6\nf 6 3 12\nf 6 12 10\nf 10 12 8\nf 10 8 2\n"
                                          "f 2 8 7\nf 4 7 8\nf 4 11 7\nf 4 3 11\nf 4 12 3\nf 4 8 12\n";

struct Solid {
    std::string name;
    std::string shape;
    bool convex = false;
};

const std::vector<Solid>& solids() {
    static const std::vector<Solid> all{
        {"a sphere", "{type: sphere, radius: 1}", true},
        {"a box", "{type: box, min: [-1, -0.7, -0.8], max: [0.8, 0.9, 1]}", true},
        {"a cylinder", "{type: cylinder, base: [0, -1, 0], top: [0.2, 1, 0.1], radius: 0.7}", true},
        {"a cone", "{type: cone, base: [0, -0.8, 0], top: [0, 1.2, 0], radius: 1, top_radius: 0.3}", true},
        {"a torus", "{type: torus, axis: [0.3, 1, 0.5], major: 0.8, minor: 0.3}"},
        {"an ellipsoid", "{type: ellipsoid, radii: [1, 0.5, 0.8]}", true},
        {"a paraboloid", "{type: paraboloid, center: [0, -0.8, 0], radii: [1, 1, 1], clip: {max: [null, 1.5, null]}}",
         true},
        {"a hyperboloid of one sheet",
         "{type: hyperboloid_one_sheet, radii: [0.5, 0.7, 0.5], clip: {min: [null, -1, null], max: [null, 1, null]}}"},
        {"a hyperboloid of two sheets",
         "{type: hyperboloid_two_sheets, radii: [0.5, 0.3, 0.5], clip: {min: [null, -1, null], max: [null, 1, null]}}"},
        {"a saddle", "{type: hyperbolic_paraboloid, radii: [1, 0.7, 1], clip: {min: [-1, -1, -1], max: [1, 1, 1]}}"},
        {"a quadric", "{type: quadric, coefficients: [1, 0.2, -0.1, 0, 1.5, 0.3, 0, 1.2, 0, -1]}", true},
        {"a mesh", "{type: mesh, file: icosahedron.obj, transform: [{scale: 0.5}]}", true},
        {"a union", "{type: csg, op: union, left: {type: sphere, radius: 0.8}, right: {type: box, min: [-1, -0.3, "
                    "-0.3], max: [1, 0.3, 0.4]}}"},
        {"an intersection",
         "{type: csg, op: intersection, left: {type: sphere, radius: 1}, right: {type: box, min: [-0.7, -0.8, -0.7], "
         "max: [0.7, 0.7, 0.7]}}",
         true},
        {"a difference", "{type: csg, op: difference, left: {type: box, min: [-0.8, -0.8, -0.8], max: [0.8, 0.8, "
                         "0.8]}, right: {type: sphere, center: [0.5, 0.6, 0.7], radius: 0.7}}"},
    };
    return all;
}

std::string furnace(const std::string& shape, const std::string& material, const std::string& render) {
    return text("camera: {position: [1.5, 2, 4], look_at: [0, 0, 0], fov: 30, resolution: [8, 8]}\n", "render: {",
                render, ", photons: 1000, caustic_photons: 0}\n", "materials: {m: ", material,
                "}\nlights: [{type: environment, radiance: 1}]\nobjects: [{shape: ", shape, ", material: m}]\n");
}

} // namespace

std::vector<Row> furnaceRows() {
    std::vector<Row> rows;
    const auto add = [&](const Solid& solid, const std::string& of, const std::string& scene, const Names& claims,
                         const Sharpness& sharpness) {
        rows.push_back({.name = solid.name + of,
                        .scene = scene,
                        .expected = 1,
                        .claims = claims,
                        .sharpness = sharpness,
                        .files = {{"icosahedron.obj", std::string(kIcosahedron)}}});
    };
    const Names onePath{"ppm", "photonmap", "path"}; // whitted's trees would grow with every face
    for (const Solid& solid : solids()) {
        // Every path brings all its weight to the sky: no noise. A path longer than 200 segments is too rare to matter.
        add(solid, " of glass", furnace(solid.shape, "{type: dielectric, ior: 1.4}", "max_depth: 200, passes: 2"),
            onePath, {.bias = 1e-5, .sees = 1e-3});
        add(solid, " of mirrors", furnace(solid.shape, "{type: mirror}", "max_depth: 200, passes: 1, min_weight: 0"),
            kAllIntegrators, {.bias = 1e-5, .sees = 1e-3});
        // Convex: every point sees half of the sky, E = pi; directions that point into the surface cost samples
        if (solid.convex) {
            add(solid, " of white plaster",
                furnace(solid.shape, "{type: diffuse, albedo: 1}", "max_depth: 2, passes: 64"), kAllIntegrators,
                {.bias = 1e-5, .sees = 0.1});
        }
    }
    return rows;
}

} // namespace hyalite::testing
