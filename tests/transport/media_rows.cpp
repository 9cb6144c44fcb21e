// Media in media: bubbles, liquids in glasses, metals under water, eyes under water, and the shadows of what bends
// nothing.
#include "transport/optics.h"
#include "transport/scene_text.h"
#include "transport/table.h"

#include <complex>
#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double kDegree = pi / 180;
constexpr std::string_view kRender =
    "render: {max_depth: 60, passes: 16, photons: 1000, caustic_photons: 0, min_weight: 1e-7}\n";

Row row(const std::string& name, const std::string& scene, double radiance, double sees = 0.15) {
    return {.name = name,
            .scene = scene,
            .expected = radiance,
            .claims = kAllIntegrators,
            .sharpness = {.bias = 3e-4, .sees = sees}, // pixels span 1e-4 rad
            .exact = true};
}

// A box from z1 down to z0, 40 m wide.
std::string box(double z0, double z1, const char* material, double half = 20) {
    return text("  - {shape: {type: box, min: [", -half, ", ", -half, ", ", z0, "], max: [", half, ", ", half, ", ", z1,
                "]}, material: ", material, "}\n");
}

// The eye on the +z side at `angle` to the normal, a wall of radiance 1 at z = -10.
std::string behind(double angle, const std::string& materials, const std::string& objects) {
    return text(
        cameraAt({8 * std::sin(angle), 0, 8 * std::cos(angle)}, {0, 0, 0}), kRender, "materials: {", materials,
        "}\nobjects:\n  - {shape: {type: quad, corner: [-90, -90, -10], edges: [[180, 0, 0], [0, 180, 0]]}, emission: "
        "1}\n",
        objects);
}

// 3 m of tinted glass, the middle metre of which is air: layer by layer by the adding method.
void addBubbles(std::vector<Row>& rows) {
    const Slab glass{1.5, 1, 0.5};
    for (const double degrees : {0.0, 35.0}) {
        const double expected = addTouching({glass, {1, 1, 0}, glass}, degrees * kDegree).transmittance;
        const double angle = degrees * kDegree;
        const std::string tinted = "g: {type: dielectric, ior: 1.5, absorption: 0.5}";
        rows.push_back(row(text("a bubble of a relative index at ", degrees, " degrees"),
                           behind(angle, tinted + ", air: {type: dielectric, ior: 0.6666666666666666}",
                                  box(-1.5, 1.5, "g", 25) + box(-0.5, 0.5, "air")),
                           expected));
        rows.push_back(
            row(text("a bubble of a higher priority at ", degrees, " degrees"),
                behind(angle,
                       "g: {type: dielectric, ior: 1.5, absorption: 0.5, priority: 1}, air: {type: dielectric, "
                       "ior: 1, priority: 2}",
                       box(-1.5, 1.5, "g", 25) + box(-0.5, 0.5, "air")),
                expected));
        rows.push_back(
            row(text("a bubble cut out at ", degrees, " degrees"),
                behind(angle, tinted,
                       "  - {shape: {type: csg, op: difference, left: {type: box, min: [-25, -25, -1.5], max: "
                       "[25, 25, 1.5]}, right: {type: box, min: [-20, -20, -0.5], max: [20, 20, 0.5]}}, "
                       "material: g}\n"),
                expected));
    }
}

// Water between two walls of glass: a face of water and glass each, however the scene says it.
void addVessels(std::vector<Row>& rows) {
    const double angle = 30 * kDegree;
    const double expected = addTouching({{1.5, 0.05, 0}, {1.33, 0.6, 0.3}, {1.5, 0.05, 0}}, angle).transmittance;
    const std::string plain =
        "glass: {type: dielectric, ior: 1.5}, water: {type: dielectric, ior: 1.33, absorption: 0.3}";
    const std::string ranked = "glass: {type: dielectric, ior: 1.5, priority: 2}, water: {type: dielectric, ior: 1.33, "
                               "absorption: 0.3, priority: 1}";
    const std::string walls = box(-0.05, 0, "glass") + box(-0.7, -0.65, "glass");
    rows.push_back(
        row("water that touches its glass", behind(angle, plain, walls + box(-0.65, -0.05, "water")), expected));
    rows.push_back(row("water that touches its glass, by priority",
                       behind(angle, ranked, walls + box(-0.65, -0.05, "water")), expected));
    rows.push_back(row("water that reaches into its glass",
                       behind(angle, ranked, walls + box(-0.67, -0.03, "water", 19)), expected));
    // Three panes that touch are one
    rows.push_back(row("panes that touch",
                       behind(angle, plain, box(-0.2, 0, "glass") + box(-0.5, -0.2, "glass") + box(-1, -0.5, "glass")),
                       addSlabs({{1.5, 1, 0}}, angle).transmittance));
}

// Gold 1 m under water, straight from above, under a white sky: the metal's index is divided by the water's.
void addMetal(std::vector<Row>& rows) {
    const std::complex<double> n(1.442, 1.603);
    const double R = std::norm((n - 1.33) / (n + 1.33));
    const double F = fresnel(1, 1, 1.33);
    rows.push_back(
        row("gold under water",
            text(cameraAt({0, 5, 0.0001}, {0, 0, 0}), kRender,
                 "materials: {h: {type: dielectric, ior: 1.33}, au: {type: conductor, eta: 1.442, k: 1.603}}\n"
                 "lights: [{type: environment, radiance: 1}]\nobjects:\n"
                 "  - {shape: {type: box, min: [-50, -1, -50], max: [50, 1, 50]}, material: h}\n"
                 "  - {shape: {type: box, min: [-40, -0.5, -40], max: [40, 0, 40]}, material: au}\n"),
            F + (1 - F) * (1 - F) * R / (1 - F * R)));
}

// Radiance over the squared index is conserved, and water absorbs from the eye on.
void addEyes(std::vector<Row>& rows) {
    const double F = fresnel(1, 1, 1.33);
    const double a = std::exp(-0.7);
    rows.push_back(
        row("an eye under water",
            text(cameraAt({0, 0, 0}, {0, 0, -1}), kRender,
                 "materials: {h: {type: dielectric, ior: 1.33, absorption: 0.7}}\nobjects:\n"
                 "  - {shape: {type: box, min: [-5, -5, -1], max: [5, 5, 1]}, material: h}\n"
                 "  - {shape: {type: quad, corner: [-9, -9, -4], edges: [[18, 0, 0], [0, 18, 0]]}, emission: 1}\n"),
            1.33 * 1.33 * (1 - F) * a / (1 - std::pow(F * a * a, 2))));
}

// A sheet that stands for both faces of a pane.
void addThinGlass(std::vector<Row>& rows) {
    const double R = fresnel(std::cos(50 * kDegree), 1, 1.5);
    rows.push_back(
        row("a thin sheet of glass at 50 degrees",
            behind(50 * kDegree, "thin: {type: dielectric, thin: true}",
                   "  - {shape: {type: quad, corner: [-20, -20, 0], edges: [[40, 0, 0], [0, 40, 0]]}, material: "
                   "thin}\n"),
            (1 - R) / (1 + R)));
}

// A ball that bends nothing, between a point light and a floor: I / d^2 / pi, and what the ball absorbs on 1 m.
void addShadows(std::vector<Row>& rows) {
    for (const double sigma : {0.0, 0.9}) {
        rows.push_back(
            row(text("the shadow of a ball of index 1 that absorbs ", sigma),
                text(cameraAt({0, 1, 0.01}, {0, 0, 0}), kRender,
                     "materials: {w: {type: diffuse, albedo: 1}, g: {type: dielectric, ior: 1, absorption: ", sigma,
                     "}}\nlights: [{type: point, position: [0, 3, 0], intensity: 9}]\nobjects:\n",
                     "  - {shape: {type: quad, corner: [-3, 0, 3], edges: [[6, 0, 0], [0, 0, -6]]}, material: w}\n",
                     "  - {shape: {type: sphere, center: [0, 2, 0], radius: 0.5}, material: g}\n"),
                std::exp(-sigma) / pi));
        rows.back().claims = {"whitted", "path"};
    }
}

} // namespace

std::vector<Row> mediaRows() {
    std::vector<Row> rows;
    addBubbles(rows);
    addVessels(rows);
    addMetal(rows);
    addEyes(rows);
    addThinGlass(rows);
    addShadows(rows);
    return rows;
}

} // namespace hyalite::testing
