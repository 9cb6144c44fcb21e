// Smooth faces and slabs between the eye and a wall of radiance 1: Fresnel, Beer and Lambert, and the adding method.
#include "transport/optics.h"
#include "transport/scene_text.h"
#include "transport/table.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double kDegree = pi / 180;

constexpr std::string_view kRender =
    "render: {max_depth: 60, passes: 16, photons: 1000, caustic_photons: 0, min_weight: 1e-7}\n";

Row row(const std::string& name, const std::string& scene, double radiance, double sees = 0.1) {
    return {.name = name,
            .scene = scene,
            .expected = radiance,
            .claims = kAllIntegrators,
            .sharpness = {.bias = 2e-4, .sees = sees}, // pixels span 1e-4 rad; F has a slope of up to 3 per rad
            .exact = true};
}

// The eye at `angle` to the normal of the slabs, which lie one behind the other along -z with `gap` between them. The
// wall is behind them all, or (for their reflectance) on the eye's side, in the mirror direction.
std::string slabScene(const std::vector<Slab>& slabs, double angle, double gap, bool reflected) {
    std::string materials;
    std::string objects;
    double z = 0;
    for (std::size_t i = 0; i < slabs.size(); ++i) {
        const Slab& slab = slabs[i];
        materials += text(i == 0 ? "" : ", ", "m", i, ": {type: dielectric, ior: ", slab.index,
                          ", absorption: ", slab.sigma, "}");
        objects += text("  - {shape: {type: box, min: [-50, -50, ", z - slab.thickness, "], max: [50, 50, ", z,
                        "]}, material: m", i, "}\n");
        z -= slab.thickness + gap;
    }
    const dvec3 eye(3 * std::sin(angle), 0, 3 * std::cos(angle));
    const std::string wall = reflected ? "corner: [-60, -60, 5], edges: [[0, 120, 0], [120, 0, 0]]"
                                       : text("corner: [-60, -60, ", z - 1, "], edges: [[120, 0, 0], [0, 120, 0]]");
    return text(cameraAt(eye, {0, 0, 0}), kRender, "materials: {", materials, "}\nobjects:\n", objects,
                "  - {shape: {type: quad, ", wall, "}, emission: 1}\n");
}

// The lower half of a glass ball; the eye looks through the round face at the middle of the flat
// one, at `angle` inside, and a wall of radiance 1 stands in the mirror direction. The round face is met at normal
// incidence: with F0 there and R at the flat face, (1 - F0)^2 R / (1 - F0^2 R^2).
Row halfBall(const std::string& name, double degrees) {
    const double angle = degrees * kDegree;
    const double R = fresnel(std::cos(angle), 1.5, 1);
    const double F0 = fresnel(1, 1, 1.5);
    const dvec3 away(std::sin(angle), -std::cos(angle), 0);
    const dvec3 middle(0.3, 0.2, 0.1);
    const std::string scene =
        text(cameraAt(middle + 4.0 * dvec3(-away.x, away.y, 0), middle), kRender,
             "materials: {g: {type: dielectric}}\nobjects:\n",
             "  - shape: {type: csg, op: intersection, left: {type: sphere, center: ", middle,
             ", radius: 1}, right: {type: plane, point: ", middle, ", normal: [0, 1, 0]}}\n    material: g\n",
             "  - {shape: {type: disk, center: ", middle + 3.0 * away, ", normal: ", -away,
             ", radius: 0.5}, emission: 1}\n");
    return row(name, scene, (1 - F0) * (1 - F0) * R / (1 - F0 * F0 * R * R), 0.25);
}

// A right-angled prism: in by one short face, totally reflected at 45 degrees by the long one, out by the other. Of the
// light that the way out reflects, the same way back leads to the way in, so that it is as a pane: (1 - F0) / (1 + F0).
Row prism() {
    const std::string obj = "v 0 0 -1\nv 1 0 -1\nv 0 1 -1\nv 0 0 1\nv 1 0 1\nv 0 1 1\n"
                            "f 1 3 2\nf 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n";
    const double F0 = fresnel(1, 1, 1.5);
    Row made =
        row("total reflection in a prism",
            text(cameraAt({-3, 0.4, 0.1}, {0, 0.4, 0.1}), kRender, "materials: {g: {type: dielectric}}\nobjects:\n",
                 "  - {shape: {type: mesh, file: prism.obj}, material: g}\n",
                 "  - {shape: {type: quad, corner: [-2, -1, 2], edges: [[4, 0, 0], [0, 0, -4]]}, emission: 1}\n"),
            (1 - F0) / (1 + F0));
    made.files = {{"prism.obj", obj}};
    return made;
}

// A ball that only absorbs: index 1, e^(-sigma times the chord at the distance h from its centre).
Row tintedBall(double h) {
    return row(text("the chord of a tinted ball at ", h),
               text(cameraAt({h, 0, 4}, {h, 0, 0}), kRender,
                    "materials: {g: {type: dielectric, ior: 1, absorption: 0.8}}\nobjects:\n",
                    "  - {shape: {type: sphere, radius: 1}, material: g}\n",
                    "  - {shape: {type: quad, corner: [-9, -9, -4], edges: [[18, 0, 0], [0, 18, 0]]}, emission: 1}\n"),
               std::exp(-0.8 * 2 * std::sqrt(1 - h * h)));
}

// A polished plate seen at this angle, with a wall of radiance 1 all over the mirror direction.
std::string plate(double angle, const std::string& material) {
    const dvec3 eye(3 * std::sin(angle), 0, 3 * std::cos(angle));
    return text(cameraAt(eye, {0, 0, 0}), kRender, "materials: {m: ", material, "}\nobjects:\n",
                "  - {shape: {type: quad, corner: [-1, -1, 0], edges: [[2, 0, 0], [0, 2, 0]]}, material: m}\n",
                "  - {shape: {type: quad, corner: [-90, -90, 5], edges: [[0, 180, 0], [180, 0, 0]]}, emission: 1}\n");
}

} // namespace

std::vector<Row> faceRows() {
    std::vector<Row> rows;
    // Deep glass that lets nothing back: the first face alone reflects
    const Slab deep{1.5, 10, 1000};
    const double brewster = std::atan(1.5);
    for (const auto& [name, angle] :
         {std::pair{"at normal incidence", 0.0}, {"at Brewster's angle", brewster}, {"at 75 degrees", 75 * kDegree}}) {
        rows.push_back(row(text("a face of glass ", name), slabScene({deep}, angle, 0, true),
                           fresnel(std::cos(angle), 1, 1.5), 0.25));
    }
    rows.push_back(halfBall("just below the critical angle", 40));
    rows.push_back(halfBall("just above the critical angle", 43));
    rows.push_back(prism());
    for (const double degrees : {0.0, 60.0}) {
        const double angle = degrees * kDegree;
        rows.push_back(row(text("polished metal at ", degrees, " degrees"),
                           plate(angle, "{type: conductor, eta: 1.442, k: 1.603}"),
                           metalFresnel(std::cos(angle), 1.442, 1.603)));
    }
    // Two mirrors at right angles send the light back to where it came from, after one reflection at each
    rows.push_back(
        row("two mirrors at right angles",
            text(cameraAt({1, 3, 0}, {1, 0.001, 0}), kRender,
                 "materials: {a: {type: mirror, reflectance: 0.8}, b: {type: mirror, reflectance: 0.7}}\nobjects:\n",
                 "  - {shape: {type: quad, corner: [0, 0, 5], edges: [[5, 5, 0], [0, 0, -10]]}, material: a}\n",
                 "  - {shape: {type: quad, corner: [0, 0, 5], edges: [[0, 0, -10], [-5, 5, 0]]}, material: b}\n",
                 "  - {shape: {type: quad, corner: [-8, 4, -4], edges: [[16, 0, 0], [0, 0, 8]]}, emission: 1}\n"),
            0.56));
    return rows;
}

std::vector<Row> slabRows() {
    std::vector<Row> rows;
    const Slab clear{1.5, 0.2, 0};
    const Slab tinted{1.5, 0.2, 2};
    const Slab water{1.33, 0.5, 0.5};
    const Slab dense{1.8, 0.1, 0};
    struct Case {
        std::string name;
        std::vector<Slab> slabs;
        double degrees;
        bool reflected;
    };
    const std::vector<Case> cases{
        {"a clear pane", {clear}, 0, false},
        {"a clear pane at 75 degrees", {clear}, 75, false},
        {"a tinted pane at 50 degrees", {tinted}, 50, false},
        {"a pane that bends nothing at 60 degrees", {{1, 0.2, 2}}, 60, false},
        {"the reflection of a clear pane at 60 degrees", {clear}, 60, true},
        {"the reflection of a tinted pane", {tinted}, 0, true},
        {"two panes", {clear, clear}, 0, false},
        {"two panes at 60 degrees", {clear, clear}, 60, false},
        {"three panes of three kinds at 30 degrees", {water, dense, tinted}, 30, false},
        {"the reflection of three panes of three kinds at 45 degrees", {water, dense, tinted}, 45, true},
        {"a pane of an index below 1 at 30 degrees", {{0.8, 0.2, 1}}, 30, false},
        {"five panes at 20 degrees", {clear, clear, clear, clear, clear}, 20, false},
    };
    for (const Case& c : cases) {
        const Stack stack = addSlabs(c.slabs, c.degrees * kDegree);
        rows.push_back(row(c.name, slabScene(c.slabs, c.degrees * kDegree, 0.3, c.reflected),
                           c.reflected ? stack.reflectance : stack.transmittance, c.reflected ? 0.3 : 0.15));
        if (c.slabs.size() > 3) {
            rows.back().claims = {"ppm", "photonmap", "path"}; // whitted's tree has 10 faces to branch at
        }
    }
    rows.push_back(tintedBall(0));
    rows.push_back(tintedBall(0.7));
    return rows;
}

} // namespace hyalite::testing
