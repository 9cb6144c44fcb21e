// Symmetries of transport: pictures that must be equal, or add up, whatever they show.
#include "transport/studio.h"
#include "transport/table.h"

#include <algorithm>
#include <numbers>

namespace hyalite::testing {

namespace {

using glm::dvec3;

// Samples of both pictures use the same random numbers, so that what they share has no noise.
constexpr Sharpness kSharpness{.bias = 1e-3, .sees = 0.3};

Symmetry same(const std::string& name, const std::string& one, const std::string& other, const Names& claims) {
    return {.name = name, .whole = one, .parts = {other}, .claims = claims, .sharpness = kSharpness};
}

// Where the scene stands, how it is turned, and the unit of its lengths are nobody's business.
void addPlacements(std::vector<Symmetry>& rows) {
    const Studio studio = furnishedStudio();
    const auto moved = [&](const std::string& name, const Placement& placement) {
        rows.push_back(same(name, studio.at(), studio.at(placement), kAllIntegrators));
        rows.back().sharpness.sees = 0.6; // turned, it draws other random directions
    };
    moved("the scene moved by metres", {.move = {3, -2, 7}});
    moved("the scene moved by 300 m", {.move = {300, 120, -80}});
    moved("the scene turned", {.axis = {0.3, 1, -0.5}, .degrees = 77});
    moved("the scene on its side", {.axis = {0, 0, 1}, .degrees = 90});
    moved("the scene in millimetres", {.scale = 1e3});
    moved("the scene in kilometres", {.scale = 1e-3});
    moved("the scene in units of 10 micrometres", {.scale = 1e5});
    moved("the scene in units of 10 km", {.scale = 1e-4});
}

// Light adds up, and scales.
void addLights(std::vector<Symmetry>& rows) {
    const Studio studio = furnishedStudio();
    Studio pointOnly = studio;
    pointOnly.objects.erase(pointOnly.objects.begin() + 2);
    Studio squareOnly = studio;
    squareOnly.points.clear();
    squareOnly.lights = {"type: directional, direction: [0, -1, -1], irradiance: 0.5"};
    Studio all = studio;
    all.lights = squareOnly.lights;
    rows.push_back({.name = "the lights of a scene one by one",
                    .whole = all.at(),
                    .parts = {pointOnly.at(), squareOnly.at()},
                    .claims = kAllIntegrators,
                    .sharpness = {.bias = 1e-3, .sees = 0.4}});
    Studio brighter = studio;
    brighter.points[0].intensity *= 3;
    brighter.objects[2] = "shape: {type: quad, corner: [-0.5, 2.8, -0.5], edges: [[1, 0, 0], [0, 0, 1]]}, emission: 24";
    rows.push_back(same("three times the light", studio.at(), brighter.at(), kAllIntegrators));
    rows.back().factor = 3;
    Studio tiles = studio;
    tiles.objects[2] = "shape: {type: quad, corner: [-0.5, 2.8, -0.5], edges: [[0.5, 0, 0], [0, 0, 0.5]]}, emission: 8";
    for (const char* corner : {"[0, 2.8, -0.5]", "[-0.5, 2.8, 0]", "[0, 2.8, 0]"}) {
        tiles.objects.push_back(
            text("shape: {type: quad, corner: ", corner, ", edges: [[0.5, 0, 0], [0, 0, 0.5]]}, emission: 8"));
    }
    rows.push_back(same("a light cut into four", studio.at(), tiles.at(), kAllIntegrators));
    Studio mesh = studio;
    mesh.objects[2] = "shape: {type: mesh, file: square.obj}, emission: 8";
    rows.push_back(same("a light of triangles", studio.at(), mesh.at(), kAllIntegrators));
    rows.back().files = {{"square.obj", "v -0.5 2.8 -0.5\nv 0.5 2.8 -0.5\nv 0.5 2.8 0.5\nv -0.5 2.8 0.5\nf 1 2 3 4\n"}};
    Studio shares = studio;
    shares.objects[2] += ", photon_share: 3";
    rows.push_back(same("three times the photons for a light", studio.at(), shares.at(), kAllIntegrators));
}

// The same surface said in another way: the objects of either picture besides the studio's floor, wall and light.
struct Twins {
    std::string name;
    std::vector<std::string> one;
    std::vector<std::string> other;
};

std::vector<Twins> twins() {
    const auto with = [](const std::string& shape) { return "shape: " + shape + ", material: m"; };
    const std::string ball = with("{type: sphere, center: [0.2, 0.8, 0.2], radius: 0.6}");
    const std::string box = with("{type: box, min: [-0.6, 0.2, -0.4], max: [0.5, 1.3, 0.6]}");
    const std::string small = "{type: sphere, center: [0.5, 0.9, 0.5], radius: 0.5}";
    const std::string block = "{type: box, min: [-0.6, 0.2, -0.4], max: [0.5, 1.3, 0.6]}";
    const auto csg = [&](const char* op, const std::string& left, const std::string& right) {
        return with(text("{type: csg, op: ", op, ", left: ", left, ", right: ", right, "}"));
    };
    const auto quad = [&](const char* corner, const char* edges) {
        return with(text("{type: quad, corner: ", corner, ", edges: ", edges, "}"));
    };
    return {
        {"a ball as an ellipsoid",
         {ball},
         {with("{type: ellipsoid, center: [0.2, 0.8, 0.2], radii: [0.6, 0.6, 0.6]}")}},
        // (x - 0.2)^2 + (y - 0.8)^2 + (z - 0.2)^2 - 0.36
        {"a ball as a quadric",
         {ball},
         {with("{type: quadric, coefficients: [1, 0, 0, -0.2, 1, 0, -0.8, 1, -0.2, 0.36]}")}},
        {"a ball united with itself",
         {ball},
         {csg("union", "{type: sphere, center: [0.2, 0.8, 0.2], radius: 0.6}",
              "{type: sphere, center: [0.2, 0.8, 0.2], radius: 0.6}")}},
        {"a ball scaled from another",
         {ball},
         {with("{type: sphere, radius: 2, transform: [{scale: 0.3}, {translate: [0.2, 0.8, 0.2]}]}")}},
        {"a solid less itself", {}, {csg("difference", block, block)}},
        {"an intersection the other way round",
         {csg("intersection", block, small)},
         {csg("intersection", small, block)}},
        {"a union the other way round", {csg("union", block, small)}, {csg("union", small, block)}},
        {"a box as the intersection of two",
         {box},
         {csg("intersection", "{type: box, min: [-0.6, 0.2, -2], max: [2, 1.3, 0.6]}",
              "{type: box, min: [-2, 0.1, -0.4], max: [0.5, 2, 1]}")}},
        {"a box as six squares",
         {box},
         {quad("[-0.6, 0.2, 0.6]", "[[1.1, 0, 0], [0, 1.1, 0]]"),
          quad("[-0.6, 0.2, -0.4]", "[[0, 1.1, 0], [1.1, 0, 0]]"),
          quad("[-0.6, 0.2, -0.4]", "[[0, 0, 1], [0, 1.1, 0]]"), quad("[0.5, 0.2, -0.4]", "[[0, 1.1, 0], [0, 0, 1]]"),
          quad("[-0.6, 1.3, -0.4]", "[[0, 0, 1], [1.1, 0, 0]]"),
          quad("[-0.6, 0.2, -0.4]", "[[1.1, 0, 0], [0, 0, 1]]")}},
        {"a box of triangles", {box}, {with("{type: mesh, file: box.obj}")}},
        {"a box of many triangles", {box}, {with("{type: mesh, file: fine.obj}")}},
        {"a can as its side and two lids",
         {with("{type: cylinder, base: [0, 0.2, 0], top: [0, 1.2, 0], radius: 0.5}")},
         {with("{type: cylinder, base: [0, 0.2, 0], top: [0, 1.2, 0], radius: 0.5, open: true}"),
          with("{type: disk, center: [0, 1.2, 0], normal: [0, 1, 0], radius: 0.5}"),
          with("{type: disk, center: [0, 0.2, 0], normal: [0, -1, 0], radius: 0.5}")}},
        {"a cone of two equal radii",
         {with("{type: cylinder, base: [0.1, 0.2, 0], top: [0.3, 1.2, 0.2], radius: 0.5}")},
         {with("{type: cone, base: [0.1, 0.2, 0], top: [0.3, 1.2, 0.2], radius: 0.5, top_radius: 0.5}")}},
        {"copies by repeat",
         {with("{type: torus, center: [-0.5, 0.5, 0], major: 0.3, minor: 0.1}"),
          with("{type: torus, center: [0.5, 0.8, 0], major: 0.3, minor: 0.1}")},
         {with("{type: torus, center: [-0.5, 0.5, 0], major: 0.3, minor: 0.1}, repeat: [{count: 2, transform: "
               "[{translate: [1, 0.3, 0]}]}]")}},
    };
}

// The box of the twins, each face cut into n x n squares of two triangles.
std::string boxMesh(int n) {
    const dvec3 low(-0.6, 0.2, -0.4);
    const dvec3 size(1.1, 1.1, 1);
    std::string vertices;
    std::string faces;
    int count = 0;
    const auto vertex = [&](const dvec3& unit) {
        const dvec3 p = low + size * unit;
        vertices += text("v ", p.x, ' ', p.y, ' ', p.z, '\n');
        return ++count;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = 0; side < 2; ++side) {
            for (int cell = 0; cell < n * n; ++cell) {
                const auto corner = [&](int du, int dv) {
                    dvec3 p(0);
                    p[axis] = side;
                    p[(axis + 1) % 3] = double(cell % n + du) / n;
                    p[(axis + 2) % 3] = double(cell / n + dv) / n;
                    return vertex(p);
                };
                const int a = corner(0, 0);
                const int b = side == 1 ? corner(1, 0) : corner(0, 1); // outwards
                const int c = corner(1, 1);
                const int d = side == 1 ? corner(0, 1) : corner(1, 0);
                faces += text("f ", a, ' ', b, ' ', c, "\nf ", a, ' ', c, ' ', d, '\n');
            }
        }
    }
    return vertices + faces;
}

void addTwins(std::vector<Symmetry>& rows) {
    for (const Twins& pair : twins()) {
        rows.push_back(same(pair.name, studioWith(pair.one).at(), studioWith(pair.other).at(), kAllIntegrators));
        rows.back().files = {{"box.obj", boxMesh(1)}, {"fine.obj", boxMesh(5)}};
    }
}

// Of the whole scene.
void addWholes(std::vector<Symmetry>& rows) {
    const Studio studio = furnishedStudio();
    Studio reversed = studio;
    std::reverse(reversed.objects.begin(), reversed.objects.end());
    rows.push_back(same("the objects in reverse", studio.at(), reversed.at(), kAllIntegrators));
    Studio tiles = studio;
    tiles.objects[0] = "shape: {type: quad, corner: [-2, 0, 2], edges: [[2, 0, 0], [0, 0, -2]]}, material: floor";
    for (const char* corner : {"[0, 0, 2]", "[-2, 0, 0]", "[0, 0, 0]"}) {
        tiles.objects.push_back(
            text("shape: {type: quad, corner: ", corner, ", edges: [[2, 0, 0], [0, 0, -2]]}, material: floor"));
    }
    rows.push_back(same("a floor of four tiles", studio.at(), tiles.at(), kAllIntegrators));
    Studio mirrored = studio;
    mirrored.eye.x = -mirrored.eye.x;
    for (PointOfLight& light : mirrored.points) {
        light.position.x = -light.position.x;
    }
    for (std::string& object : mirrored.objects) {
        object.insert(object.find("type:"), "transform: [{scale: [-1, 1, 1]}], ");
    }
    rows.push_back(same("the scene in a looking-glass", studio.at(), mirrored.at(), kAllIntegrators));
    rows.back().independent = Independent::Renders; // pixel by pixel they show different things
    rows.back().sharpness.sees = 0.5;
}

// A square patch of the studio.
struct Patch {
    dvec3 middle;
    dvec3 u; // unit; u x v is its normal
    dvec3 v;
    double width;
};

// One of two patches of the floor's material shines, the other is what the picture shows. The light between them, over
// all ways and bounces, is symmetric: what a patch receives from the other over its own area (the radiosity b of patch
// j by patch i obeys b_ji / A_i = b_ij / A_j).
std::string exchange(const Patch& shining, const Patch& seen, const std::vector<std::string>& objects,
                     const std::string& material) {
    Studio studio = studioWith(objects, material);
    studio.points.clear();
    const auto quad = [](const Patch& patch) {
        const dvec3 corner = patch.middle - patch.width / 2 * (patch.u + patch.v);
        return text("shape: {type: quad, corner: ", corner, ", edges: [", patch.width * patch.u, ", ",
                    patch.width * patch.v, "]}, material: floor");
    };
    studio.objects[2] = quad(shining) + ", emission: 20";
    studio.objects.push_back(quad(seen));
    const dvec3 normal = glm::cross(seen.u, seen.v);
    studio.eye = seen.middle + 0.01 * normal;
    studio.target = seen.middle;
    studio.up = seen.v;
    studio.fov = 2 * std::atan(seen.width / 2 / 0.01) * 180 / std::numbers::pi;
    return studio.at();
}

void addReciprocity(std::vector<Symmetry>& rows) {
    const double r = std::sqrt(0.5);
    const Patch left{{-1.3, 1.2, 0}, {0, 0, -1}, {r, r, 0}, 0.6};  // normal (r, -r, 0)
    const Patch right{{1.2, 0.6, 0.3}, {0, 0, 1}, {0, 1, 0}, 0.4}; // normal (-1, 0, 0)
    const std::string ball = "shape: {type: sphere, center: [0, 0.7, 0.2], radius: 0.3}, material: m";
    for (const auto& [name, material] :
         {std::pair{"a grey ball", "{type: diffuse, albedo: 0.6}"},
          {"a ball of brushed gold", "{type: conductor, metal: gold, roughness: 0.5}"},
          {"a coated ball", "{type: metallic_roughness, base_color: 0.7, roughness: 0.4}"}}) {
        rows.push_back({.name = text("light and eye swapped about ", name),
                        .whole = exchange(left, right, {ball}, material),
                        .parts = {exchange(right, left, {ball}, material)},
                        .factor = right.width * right.width / (left.width * left.width),
                        .claims = {"path"},
                        .sharpness = {.bias = 1e-4, .sees = 0.4},
                        .independent = Independent::Renders});
    }
}

} // namespace

std::vector<Symmetry> placementSymmetries() {
    std::vector<Symmetry> rows;
    addPlacements(rows);
    return rows;
}

std::vector<Symmetry> lightSymmetries() {
    std::vector<Symmetry> rows;
    addLights(rows);
    addWholes(rows);
    addReciprocity(rows);
    return rows;
}

std::vector<Symmetry> shapeSymmetries() {
    std::vector<Symmetry> rows;
    addTwins(rows);
    return rows;
}

} // namespace hyalite::testing
