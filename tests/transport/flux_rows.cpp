// Where all the flux of a light goes: view factors between surfaces, beams by way of mirrors and glass, and rooms that
// absorb what is emitted. The pictures are squares that contain all of the light, or all of a surface.
#include "transport/optics.h"
#include "transport/scene_text.h"
#include "transport/table.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double kDegree = pi / 180;
const dvec3 kUp(0, 1, 0);
const dvec3 kNorth(0, 0, -1);

// The photons' discs keep this radius [m]: so few photons are emitted that all of them count.
std::string render(double radius, int depth) {
    return text("render: {max_depth: ", depth, ", passes: 4, photons: 500, caustic_photons: 500, radius: ", radius,
                ", caustic_radius: ", radius,
                ", nearest: 512, caustic_nearest: 512, caustic_filter: none, gather_rays: 0}\n");
}

constexpr std::string_view kMaterials =
    "materials: {white: {type: diffuse, albedo: 1}, black: {type: diffuse, albedo: 0}, "
    "mirror: {type: mirror, reflectance: 0.8}, glass: {type: dielectric}, tint: "
    "{type: dielectric, ior: 1, absorption: 2}, gray: {type: diffuse, albedo: 0.6}}\n";

Row row(const std::string& name, const std::string& scene, double radiance, const Names& claims, double sees) {
    return {.name = name,
            .scene = scene,
            .expected = radiance,
            .claims = claims,
            .sharpness = {.bias = 1e-3, .sees = sees},
            .independent = Independent::Renders};
}

std::string floorOf(const char* material) {
    return text("  - {shape: {type: quad, corner: [-5, 0, 5], edges: [[10, 0, 0], [0, 0, -10]]}, material: ", material,
                "}\n");
}

// A picture of a square of the floor about the origin, of that width.
std::string overFloor(double width) {
    return cameraOver({0, 0, 0}, kUp, kNorth, width, 0.3);
}

// Factors of J. Howell's catalogue; the receiver is a white disk on black ground, in a picture of twice its radius.
void addDisks(std::vector<Row>& rows) {
    const double r = 0.5;        // of the receiver
    const double share = pi / 4; // of the picture
    const auto scene = [&](const std::string& light) {
        return text(overFloor(2 * r), render(0.05, 2), kMaterials, "objects:\n", floorOf("black"),
                    "  - {shape: {type: disk, center: [0, 0.001, 0], normal: [0, 1, 0], radius: ", r,
                    "}, material: white}\n  - {shape: {", light, "}, emission: 1}\n");
    };
    // C-41: X = 1 + (1 + R2^2) / R1^2, F = (X - sqrt(X^2 - 4 (R2 / R1)^2)) / 2
    const double h = 1 - 0.001;
    const double R1 = r / h;
    const double R2 = 0.8 / h;
    const double X = 1 + (1 + R2 * R2) / (R1 * R1);
    rows.push_back(row("a disk lights a disk", scene("type: disk, center: [0, 1, 0], normal: [0, -1, 0], radius: 0.8"),
                       share * (X - std::sqrt(X * X - 4 * (R2 / R1) * (R2 / R1))) / 2, kAllIntegrators, 0.1));
    // C-120: (1 - 1 / sqrt(1 + (r / h)^2)) / 2 of the sphere's flux, 4 pi^2 R^2
    const double F = (1 - h / std::hypot(h, r)) / 2;
    rows.push_back(row("a sphere lights a disk", scene("type: sphere, center: [0, 1, 0], radius: 0.3"),
                       share * 4 * pi * pi * 0.3 * 0.3 * F / (pi * r * r) / pi, kAllIntegrators, 0.4));
}

// All of a light's flux on the floor: L = flux / (pi area).
void addDirectFlux(std::vector<Row>& rows) {
    const auto scene = [](double width, const std::string& light) {
        return text(overFloor(width), render(0.05, 2), kMaterials, "lights: [{", light, "}]\nobjects:\n",
                    floorOf("white"));
    };
    const auto cosine = [](double degrees) { return std::cos(degrees * kDegree); };
    rows.push_back(
        row("all of a spot on the floor",
            scene(3, "type: spot, position: [0, 2, 0], direction: [0, -1, 0], intensity: 3, angle: 35, blend: 0.4"),
            pi * 3 * (2 - cosine(21) - cosine(35)) / (pi * 9), kAllIntegrators, 0.1));
    rows.push_back(
        row("all of a beam on the floor",
            scene(1, "type: directional, direction: [0, -1, 0], irradiance: 5, radius: 0.4, center: [0, 2, 0]"),
            5 * 0.16, kAllIntegrators, 0.1));
    // The floor as one of six faces of a cube around the light
    rows.push_back(row("a sixth of a point light on a face of a cube",
                       scene(2, "type: point, position: [0, 1, 0], intensity: 3"), 4 * pi * 3 / 6 / (pi * 4),
                       kAllIntegrators, 0.1));
}

// A beam or a spot by way of mirrors and panes. `width` is more than the light's on the surface and two radii.
void addCaustics(std::vector<Row>& rows) {
    constexpr std::string_view kBeam = "lights: [{type: directional, direction: [0, -1, 0], irradiance: 5, radius: "
                                       "0.2, center: [0, 3, 0]}]\nobjects:\n";
    const double beam = 5 * 0.04 / 0.64; // of flux / (pi area) in a picture of 0.8 m
    const auto onFloor = [&](const std::string& between, int depth) {
        return text(overFloor(0.8), render(0.15, depth), kMaterials, kBeam, floorOf("white"), between);
    };
    const double F = fresnel(1, 1, 1.5);
    rows.push_back(row("a beam through a pane",
                       onFloor("  - {shape: {type: box, min: [-1, 0.9, -1], max: [1, 1.1, 1]}, material: glass}\n", 20),
                       beam * (1 - F) / (1 + F), kPhotonIntegrators, 0.2));
    rows.push_back(
        row("a beam through a tilted tinted box",
            onFloor("  - {shape: {type: box, min: [-1, -0.1, -1], max: [1, 0.1, 1]}, material: tint, transform: "
                    "[{rotate: {axis: [0, 0, 1], degrees: 45}}, {translate: [0, 1.5, 0]}]}\n",
                    6),
            beam * std::exp(-2 * 0.2 * std::numbers::sqrt2), kPhotonIntegrators, 0.2));
    // To +x by a mirror at 45 degrees, then down by another
    constexpr std::string_view kFirst = "  - {shape: {type: quad, corner: [-1, 0, 1], edges: [[2, 0, 0], [0, 0, -2]]}, "
                                        "material: mirror, transform: [{rotate: {axis: [0, 0, 1], degrees: -45}}, "
                                        "{translate: [0, 2, 0]}]}\n";
    rows.push_back(
        row("a beam by way of a mirror",
            text(cameraOver({3, 2, 0}, {-1, 0, 0}, kUp, 0.8, 0.3), render(0.15, 4), kMaterials, kBeam, kFirst,
                 "  - {shape: {type: quad, corner: [3, 0, -2], edges: [[0, 0, 4], [0, 4, 0]]}, material: white}\n"),
            0.8 * beam, kPhotonIntegrators, 0.2));
    rows.push_back(row(
        "a beam by way of two mirrors",
        text(cameraOver({3, 0, 0}, kUp, kNorth, 0.8, 0.3), render(0.15, 5), kMaterials, kBeam, floorOf("white"), kFirst,
             "  - {shape: {type: quad, corner: [-0.6, 0, -0.6], edges: [[1.2, 0, 0], [0, 0, 1.2]]}, material: "
             "mirror, transform: [{rotate: {axis: [0, 0, 1], degrees: -45}}, {translate: [3, 2, 0]}]}\n"),
        0.64 * beam, kPhotonIntegrators, 0.2));
}

// Conics send the light of one focus to the other. The picture contains the disc about the focus, and looks up at the
// middle of a white disk there.
void addFoci(std::vector<Row>& rows) {
    const double width = 0.04;
    const auto scene = [&](double height, double radius, const std::string& light, const std::string& mirror) {
        return text(cameraOver({0, height, 0}, {0, -1, 0}, kNorth, width, 0.05), render(0.01, 4), kMaterials,
                    "lights: [{", light, "}]\nobjects:\n  - {shape: {", mirror, ", caps: false}, material: mirror}\n",
                    "  - {shape: {type: disk, center: [0, ", height, ", 0], normal: [0, -1, 0], radius: ", radius,
                    "}, material: white}\n");
    };
    // y = r^2 / 4: focal length 1 m; the disk shades its part of the beam
    rows.push_back(
        row("a burning mirror",
            scene(1, 0.03, "type: directional, direction: [0, -1, 0], irradiance: 1, radius: 0.4, center: [0, 3, 0]",
                  "type: paraboloid, radii: [1, 0.25, 1], clip: {max: [null, 0.25, null]}"),
            0.8 * (0.16 - 0.0009) / (width * width), kPhotonIntegrators, 0.5));
    // Half-axes 0.8 and 1: foci 0.6 m from the centre
    const auto cosine = [](double degrees) { return std::cos(degrees * kDegree); };
    rows.push_back(
        row("from one focus of an ellipsoid to the other",
            scene(0.6, 0.1,
                  "type: spot, position: [0, -0.6, 0], direction: [0, -1, 0], intensity: 3, angle: 40, blend: 0.2",
                  "type: ellipsoid, radii: [0.8, 1, 0.8], clip: {max: [null, 0, null]}"),
            0.8 * pi * 3 * (2 - cosine(32) - cosine(40)) / (pi * width * width), kPhotonIntegrators, 0.5));
}

// The walls of a cube with a point light in the middle absorb all it sends, and by symmetry each as much: (1 - a) E
// times 24 m^2 are 4 pi I. Discs that reach over a wall's edge miss light: of radius r at 8 m of edge around 4 m^2,
// 2 / (3 pi) r 8 / 4 of the indirect light, a share of a.
void addRooms(std::vector<Row>& rows) {
    const double radius = 0.05;
    std::string walls;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 n(0);
        dvec3 a(0);
        dvec3 b(0);
        n[axis] = 1;
        a[(axis + 1) % 3] = 2;
        b[(axis + 2) % 3] = 2;
        for (const double side : {-1.0, 1.0}) {
            walls += text("  - {shape: {type: quad, corner: ", side * n - 0.5 * (a + b), ", edges: [", side < 0 ? a : b,
                          ", ", side < 0 ? b : a, "]}, material: gray}\n");
        }
    }
    Row room = row("the walls of a cube around a light",
                   text(cameraOver({0, -1, 0}, kUp, kNorth, 2, 0.1), render(radius, 40), kMaterials,
                        "lights: [{type: point, position: [0, 0, 0], intensity: 3}]\nobjects:\n", walls),
                   0.6 / pi * 4 * pi * 3 / (24 * (1 - 0.6)), kIndirectIntegrators, 0.6);
    room.sharpness.bias = 2 / (3 * pi) * radius * 8 / 4 * 0.6 + 1e-3;
    rows.push_back(room);
}

} // namespace

std::vector<Row> fluxRows() {
    std::vector<Row> rows;
    addDisks(rows);
    addDirectFlux(rows);
    addCaustics(rows);
    addFoci(rows);
    addRooms(rows);
    return rows;
}

} // namespace hyalite::testing
