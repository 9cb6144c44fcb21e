// Direct light at one point of a white surface: radiance E / pi.
#include "transport/scene_text.h"
#include "transport/table.h"

#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double kDegree = pi / 180;

// A small white disk about the origin, tilted by `tilt` [rad] towards +x, seen 20 degrees from its normal. `items` are
// the sections with lights and further objects.
std::string litDisk(double tilt, const std::string& lights, const std::string& objects, std::uint32_t passes = 32) {
    const dvec3 normal(std::sin(tilt), std::cos(tilt), 0);
    const double view = 20 * kDegree;
    return text(cameraAt(0.5 * (std::cos(view) * normal + std::sin(view) * dvec3(0, 0, 1)), {0, 0, 0}),
                "render: {max_depth: 2, passes: ", passes, ", photons: 1000, caustic_photons: 0}\n",
                "materials: {w: {type: diffuse, albedo: 1}, black: {type: diffuse, albedo: 0}}\n", "lights: [", lights,
                "]\n", "objects:\n  - {shape: {type: disk, normal: ", normal, ", radius: 0.2}, material: w}\n",
                objects);
}

std::string emitter(const std::string& shape) {
    return text("  - {shape: {", shape, "}, emission: 1}\n");
}

Row row(const std::string& name, const std::string& scene, double irradiance, bool exact) {
    return {.name = name,
            .scene = scene,
            .expected = irradiance / pi,
            .claims = kAllIntegrators,
            .sharpness = {.bias = 1e-4, .sees = exact ? 1e-3 : 0.1}, // pixels span 1e-4 rad
            .exact = exact};
}

// Irradiance at the origin, on a surface facing +y, from a polygon of radiance 1 above it with corners
// counter-clockwise seen from its front: Lambert's formula.
double lambert(const std::vector<dvec3>& corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 a = glm::normalize(corners[i]);
        const dvec3 b = glm::normalize(corners[(i + 1) % corners.size()]);
        sum += std::acos(glm::dot(a, b)) * glm::normalize(glm::cross(b, a)).y;
    }
    return sum / 2;
}

// Lights without area, each alone: no noise, whoever samples it.
void addIdealLights(std::vector<Row>& rows) {
    const auto at = [](const char* kind, const dvec3& position, const std::string& more) {
        return text("{type: ", kind, ", position: ", position, more, "}");
    };
    // I cos / d^2
    rows.push_back(
        row("a point light overhead", litDisk(0, at("point", {0, 2, 0}, ", intensity: 3"), ""), 3.0 / 4, true));
    rows.push_back(row("a point light at 60 degrees",
                       litDisk(0, at("point", {2 * std::sin(pi / 3), 1, 0}, ", intensity: 3"), ""), 3 * 0.5 / 4, true));
    rows.push_back(row("a point light ten times as far", litDisk(0, at("point", {0, 20, 0}, ", intensity: 300"), ""),
                       3.0 / 4, true));
    rows.push_back(row("a point light over a disk tilted by 50 degrees",
                       litDisk(50 * kDegree, at("point", {0, 2, 0}, ", intensity: 3"), ""),
                       3.0 / 4 * std::cos(50 * kDegree), true));
    // A spot turned away by the angle; between 15 and 30 degrees it falls as 3 t^2 - 2 t^3, t linear in the cosine
    const auto spot = [&](double off) {
        const dvec3 axis(std::sin(off * kDegree), -std::cos(off * kDegree), 0);
        return at("spot", {0, 2, 0}, text(", intensity: 3, angle: 30, blend: 0.5, direction: ", axis));
    };
    const auto cosine = [](double degrees) { return std::cos(degrees * kDegree); };
    const double t = (cosine(22) - cosine(30)) / (cosine(15) - cosine(30));
    rows.push_back(row("the full part of a spot", litDisk(0, spot(14), ""), 3.0 / 4, true));
    rows.push_back(row("the blended part of a spot", litDisk(0, spot(22), ""), 3.0 / 4 * (3 - 2 * t) * t * t, true));
    rows.push_back(row("parallel light on a disk tilted by 60 degrees",
                       litDisk(pi / 3, "{type: directional, direction: [0, -1, 0], irradiance: 2}", ""), 1, true));
    rows.push_back(
        row("a beam on a disk tilted by 40 degrees",
            litDisk(40 * kDegree,
                    "{type: directional, direction: [0, -1, 0], irradiance: 2, radius: 0.5, center: [0.3, 3, 0]}", ""),
            2 * cosine(40), true));
    // (1 + cos) / 2 of the hemisphere over a tilted disk is above the horizon of an endless black ground
    rows.push_back(row("a sky over black ground, on a disk tilted by 50 degrees",
                       litDisk(50 * kDegree, "{type: environment, radiance: 1}",
                               "  - {shape: {type: plane, point: [0, -0.5, 0], normal: [0, 1, 0]}, material: black}\n"),
                       pi * (1 + cosine(50)) / 2, false));
    rows.push_back(row("a sky all around, on a disk", litDisk(0.3, "{type: environment, radiance: 1}", ""), pi, false));
}

// From a differential element to round lights (J. Howell's catalogue, section B).
void addRoundLights(std::vector<Row>& rows) {
    const auto disk = [](const dvec3& center, const dvec3& normal, double radius) {
        return emitter(text("type: disk, center: ", center, ", normal: ", normal, ", radius: ", radius));
    };
    const auto sphere = [](const dvec3& center, double radius) {
        return emitter(text("type: sphere, center: ", center, ", radius: ", radius));
    };
    // B-9: r^2 / (r^2 + h^2)
    rows.push_back(row("a disk overhead", litDisk(0, "", disk({0, 2, 0}, {0, -1, 0}, 1)), pi / 5, false));
    // B-12: a disk of radius r at the height h, its axis at the distance l, seen by an upright element that faces the
    // axis: h / 2l ((l^2 + h^2 + r^2) / sqrt((l^2 + h^2 + r^2)^2 - 4 r^2 l^2) - 1)
    const double h = 1;
    const double l = 2;
    const double r = 0.75;
    const double sum = l * l + h * h + r * r;
    rows.push_back(row("a disk seen from an upright element", litDisk(pi / 2, "", disk({l, h, 0}, {0, -1, 0}, r)),
                       pi * h / (2 * l) * (sum / std::sqrt(sum * sum - 4 * r * r * l * l) - 1), false));
    // cos (r / d)^2 while all of the sphere is above the element's horizon
    rows.push_back(row("a sphere overhead", litDisk(0, "", sphere({0, 2, 0}, 0.5)), pi / 16, false));
    rows.push_back(row("a sphere at 60 degrees", litDisk(pi / 3, "", sphere({0, 2, 0}, 0.5)), pi / 32, false));
    // Its centre on the horizon: half of it is seen; H = d / r: atan(1 / sqrt(H^2 - 1)) - sqrt(H^2 - 1) / H^2
    const double root = std::sqrt(1.6 * 1.6 - 1);
    rows.push_back(row("a sphere half below the horizon", litDisk(0, "", sphere({1.6, 0, 0}, 1), 512),
                       std::atan(1 / root) - root / (1.6 * 1.6), false));
}

// Rectangles and polygons: the catalogue's formulas, and Lambert's.
void addPolygons(std::vector<Row>& rows) {
    const auto quad = [](const dvec3& corner, const dvec3& edge0, const dvec3& edge1) {
        return emitter(text("type: quad, corner: ", corner, ", edges: [", edge0, ", ", edge1, "]"));
    };
    // B-3: a rectangle a by b parallel to the element, at the height c above it, with one corner straight above
    const double a = 1.5;
    const double b = 0.8;
    const double c = 1;
    const auto term = [c](double x, double y) {
        const double s = std::sqrt(x * x + c * c);
        return x / s * std::atan(y / s);
    };
    rows.push_back(row("a rectangle overhead", litDisk(0, "", quad({0, c, 0}, {a, 0, 0}, {0, 0, b})),
                       (term(a, b) + term(b, a)) / 2, false));
    // B-4: an upright rectangle of width b and height a at the distance c, one lower corner opposite the element
    const double d = std::sqrt(a * a + c * c);
    rows.push_back(row("an upright rectangle", litDisk(0, "", quad({c, 0, 0}, {0, 0, b}, {0, a, 0})),
                       (std::atan(b / c) - c / d * std::atan(b / d)) / 2, false));
    const dvec3 corner(-0.5, 1, 1);
    const dvec3 edge0(0.2, -0.3, -2);
    const dvec3 edge1(1.5, 0.4, 0);
    rows.push_back(row("a tilted parallelogram", litDisk(0, "", quad(corner, edge0, edge1)),
                       lambert({corner, corner + edge0, corner + edge0 + edge1, corner + edge1}), false));
    // Convex, with its front down
    const std::vector<dvec3> corners{{-0.6, 1, -0.4}, {0.3, 1.1, -0.8}, {1.2, 1.2, 0}, {0.6, 1.1, 0.8}, {-0.3, 1, 0.4}};
    std::string obj;
    for (const dvec3& p : corners) {
        obj += text("v ", p.x, ' ', p.y, ' ', p.z, '\n');
    }
    Row pentagon =
        row("a pentagon", litDisk(0, "", emitter("type: mesh, file: pentagon.obj")), lambert(corners), false);
    pentagon.files = {{"pentagon.obj", obj + "f 1 2 3 4 5\n"}};
    rows.push_back(pentagon);
}

// Light and eye straight above: only D and Fresnel's reflectance at normal incidence remain of the microfacet model
// [Walter07]: F D / 4 with D = 1 / (pi alpha^2), alpha = roughness^2.
void addRoughSurfaces(std::vector<Row>& rows) {
    const auto scene = [](const std::string& material) {
        return text(
            cameraAt({0, 1, 0}, {0, 0, 0}), "render: {max_depth: 2, photons: 1000, passes: 32}\n",
            "materials: {m: ", material, "}\nlights: [{type: point, position: [0, 2, 0], intensity: 3}]\n",
            "objects: [{shape: {type: quad, corner: [-1, 0, 1], edges: [[2, 0, 0], [0, 0, -2]]}, material: m}]\n");
    };
    const double peak = 1 / (4 * pi * 0.25 * 0.25);
    const double F = ((0.2 - 1) * (0.2 - 1) + 3.9 * 3.9) / ((0.2 + 1) * (0.2 + 1) + 3.9 * 3.9);
    rows.push_back(row("brushed metal from above", scene("{type: conductor, eta: 0.2, k: 3.9, roughness: 0.5}"),
                       pi * 3.0 / 4 * F * peak, true));
    // Base: c (1 - F0) 21 / (20 pi) [Shirley97a], F0 = 0.04
    Row coated = row("a coated base from above", scene("{type: metallic_roughness, base_color: 0.5, roughness: 0.5}"),
                     pi * 3.0 / 4 * (0.5 * 0.96 * 21 / (20 * pi) + 0.04 * peak), true);
    coated.sharpness.sees = 0.15; // paths pick base or coat
    rows.push_back(coated);
}

} // namespace

std::vector<Row> directLightRows() {
    std::vector<Row> rows;
    addIdealLights(rows);
    addRoundLights(rows);
    addPolygons(rows);
    addRoughSurfaces(rows);
    return rows;
}

} // namespace hyalite::testing
