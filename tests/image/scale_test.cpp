// Scenes that strain single precision: solids that are large beside their distance, or small beside it; places far from
// the origin; units from a tenth of a millimetre to a hundred kilometres. On the device and in the reference.
#include "image/known_answer.h"
#include "kernel/kernel_support.h"
#include "scene/model/named_quadrics.h"
#include "scene/model/quadric.h"
#include "unit/scene/scene_test_support.h"

#include <array>
#include <iomanip>
#include <sstream>

namespace hyalite::testing {

namespace {

using glm::dmat4;

constexpr std::array kBackends{Backend::Vulkan, Backend::Reference};

Image rendered(const Scene& scene, Backend backend) {
    return renderBy({"", scene.render.integrator, backend}, scene);
}

double meanOf(const Image& image) {
    double sum = 0;
    for (const vec3& pixel : image.pixels) {
        sum += double{pixel.x};
    }
    return sum / static_cast<double>(image.pixels.size());
}

// Pixels that differ by more than this share of the expected value, or of the mean where that is larger.
std::size_t countOff(const Image& image, const Image& expected, double share) {
    const double mean = meanOf(expected);
    std::size_t off = 0;
    for (std::size_t i = 0; i < expected.pixels.size(); ++i) {
        const double value = double{expected.pixels[i].x};
        off += std::abs(double{image.pixels[i].x} - value) > share * std::max(value, mean) ? 1 : 0;
    }
    return off;
}

dmat4 at(const dvec3& place) {
    return glm::translate(dmat4(1), place);
}

// ---- Large beside their distance

// A closed box of triangles from `low` to `high`, fronts outwards.
Mesh boxMesh(const dvec3& low, const dvec3& high) {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        mesh.positions.emplace_back((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                                    (corner & 4) != 0 ? high.z : low.z);
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    return mesh;
}

Quadric boxAt(const dvec3& low, const dvec3& high) {
    Quadric box = boxQuadric((high - low) / 2.0);
    box.objectToWorld = at((low + high) / 2.0);
    return box;
}

Quadric moved(Quadric quadric, const dmat4& map) {
    quadric.objectToWorld = map * quadric.objectToWorld;
    return quadric;
}

struct Ground {
    std::string name;
    Shape solid; // about 100 m across; its surface is horizontal at the origin
};

// Solids of every kind.
std::vector<Ground> grounds() {
    const dmat4 lying = glm::rotate(dmat4(1), std::numbers::pi / 2, dvec3(1, 0, 0)); // y to z
    return {
        {"box", boxAt({-100, -100, -90}, {110, 0, 100})},
        {"sphere", Sphere{{0, -100, 0}, 100}},
        {"half-space", Plane{{0, 0, 0}, {0, 1, 0}}},
        {"cylinder's cap", moved(cylinderQuadric(100, 80), at({30, -80, -20}))},
        {"cylinder's side", moved(cylinderQuadric(100, 200), at({0, -100, -70}) * lying)},
        {"ellipsoid", Quadric{.form = ellipsoidForm({100, 60, 80}), .objectToWorld = at({0, -60, 0})}},
        {"torus", Torus{.major = 100, .minor = 40, .objectToWorld = at({-100, -40, 0})}},
        {"mesh", MeshInstance{0, dmat4(1)}},
    };
}

// The ground in front of a camera at 5 cm under parallel light, all turned about the origin.
Scene groundScene(const std::vector<Shape>& leaves, const std::vector<CsgStep>& program, const dmat4& turn) {
    const auto turned = [&](const dvec3& v) { return dvec3(turn * glm::dvec4(v, 0)); };
    Scene scene;
    scene.camera = {.position = turned({0.03, 0.025, 0.04}),
                    .lookAt = dvec3(0),
                    .up = turned({0, 1, 0}),
                    .fov = 40,
                    .resolution = {48, 48}};
    scene.render.integrator = "whitted";
    scene.render.passes = 1;
    const std::size_t gray = reference::test::addMaterial(scene, Diffuse{dvec3(0.6)});
    scene.directionals = {{.direction = turned(glm::normalize(dvec3(-1, -1, 0.5))), .irradiance = dvec3(3)}};
    scene.meshes = {boxMesh({-100, -100, -90}, {110, 0, 100})};
    for (Shape shape : leaves) {
        if (auto* sphere = std::get_if<Sphere>(&shape)) {
            sphere->center = turned(sphere->center);
        } else if (auto* plane = std::get_if<Plane>(&shape)) {
            plane->normal = turned(plane->normal);
        } else if (auto* quadric = std::get_if<Quadric>(&shape)) {
            quadric->objectToWorld = turn * quadric->objectToWorld;
        } else if (auto* torus = std::get_if<Torus>(&shape)) {
            torus->objectToWorld = turn * torus->objectToWorld;
        } else {
            std::get<MeshInstance>(shape).objectToWorld = turn;
        }
        scene.csgLeaves.push_back({.shape = shape, .material = gray, .emission = dvec3(0), .where = {}});
    }
    reference::test::addObject(scene, Csg{0, program}, gray);
    return scene;
}

// Every pixel has the radiance of a flat ground: albedo / pi * E cos = 0.6 / pi * 3 * (2/3). On a ground of radius R,
// of which the camera sees less than 0.1 m, the normal turns by 0.1 / R, and with it cos by that times the sine, 0.745:
// relative 0.1 / 40 * 0.745 / (2/3) = 0.003 at the most.
void checkGround(const std::string& name, const Scene& scene) {
    const double expected = 0.6 / std::numbers::pi * 3 * 2 / 3;
    for (const Backend backend : kBackends) {
        const Image image = rendered(scene, backend);
        const auto isWrong = [&](const vec3& pixel) { return !(std::abs(double{pixel.x} / expected - 1) < 0.004); };
        INFO(name << (backend == Backend::Vulkan ? ", device" : ", reference"));
        CHECK(std::ranges::count_if(image.pixels, isWrong) == 0);
    }
}

// ---- Small beside their distance

struct Lit {
    std::string name;
    Shape solid; // in the unit ball; light and camera look down its y axis onto a disk of radius `reach`
    double reach;
    double cosine; // mean over that disk of the cosine between normal and axis
};

// The cosine of a surface y(r) is 1 / sqrt(1 + y'(r)^2), its mean 2 / R^2 times the integral of r cosine dr up to R.
std::vector<Lit> litSolids() {
    const dmat4 down = glm::rotate(dmat4(1), std::numbers::pi, dvec3(1, 0, 0)); // upside down
    // Ball: 2/3. Cone, y = -r: 1 / sqrt 2. Paraboloid, y = -r^2 to R = 0.7: (sqrt(1 + 4 R^2) - 1) / (2 R^2).
    // Hyperboloid of two sheets, y = -sqrt(r^2 + 1/16) to r = 0.5: y' = r / |y|, so the cosine is sqrt((r^2 + k) / (2
    // r^2 + k)) with k = 1/16; by Simpson's rule with 1000 steps.
    const auto hyperbolic = [](double r) { return r * std::sqrt((r * r + 0.0625) / (2 * r * r + 0.0625)); };
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
        const double a = 0.5 * i / 1000;
        const double b = 0.5 * (i + 1) / 1000;
        sum += (b - a) / 6 * (hyperbolic(a) + 4 * hyperbolic((a + b) / 2) + hyperbolic(b));
    }
    const double parabolic = (std::sqrt(1 + 4 * 0.49) - 1) / (2 * 0.49);
    return {
        {"sphere", Sphere{dvec3(0), 0.8}, 0.8, 2.0 / 3},
        {"ball as a quadric", Quadric{.form = ellipsoidForm(dvec3(0.8))}, 0.8, 2.0 / 3},
        {"cone", moved(coneQuadric(0.6, 0, 0.6), at({0, -0.3, 0})), 0.6, std::sqrt(0.5)},
        {"cylinder", moved(cylinderQuadric(0.5, 0.8), at({0, -0.4, 0})), 0.5, 1},
        {"box", boxQuadric(dvec3(0.5)), std::sqrt(0.5), 1},
        {"paraboloid",
         Quadric{.form = {.a = 1, .g = -0.5, .h = 1},
                 .clip = {{-0.7, 0, -0.7}, {0.7, 0.49, 0.7}},
                 .objectToWorld = at({0, 0.3, 0}) * down},
         0.7, parabolic},
        {"hyperboloid of two sheets",
         Quadric{.form = {.a = 1, .e = -1, .h = 1, .j = 0.0625},
                 .clip = {{-0.5, 0, -0.5}, {0.5, std::sqrt(0.3125), 0.5}},
                 .objectToWorld = at({0, 0.3, 0}) * down},
         0.5, sum * 2 / 0.25},
    };
}

// Camera and light `distance` radii away, in a direction that is along no axis.
Scene litScene(const Lit& lit, double size, double distance, bool asCsg) {
    const dvec3 towards = glm::normalize(dvec3(0.4, 0.3, 0.866));
    const dmat4 turn = glm::rotate(dmat4(1), std::acos(towards.y), glm::cross(dvec3(0, 1, 0), towards)) *
                       glm::scale(dmat4(1), dvec3(size));
    Scene scene;
    scene.camera = {.position = distance * towards,
                    .lookAt = dvec3(0),
                    .up = {0, 1, 0},
                    .fov = 2 * std::atan(size * lit.reach * 1.1 / distance) * 180 / std::numbers::pi,
                    .resolution = {64, 64}};
    scene.render.integrator = "whitted";
    scene.render.passes = 4;
    scene.directionals = {{.direction = -towards, .irradiance = dvec3(1)}};
    const std::size_t white = reference::test::addMaterial(scene, Diffuse{dvec3(0.8)});
    Shape shape = lit.solid;
    if (auto* sphere = std::get_if<Sphere>(&shape)) {
        sphere->radius *= size;
    } else {
        auto& quadric = std::get<Quadric>(shape);
        quadric.objectToWorld = turn * quadric.objectToWorld;
    }
    if (!asCsg) {
        reference::test::addObject(scene, shape, white);
        return scene;
    }
    for (const Shape& leaf : {shape, Shape(Sphere{dvec3(0), 2 * size})}) {
        scene.csgLeaves.push_back({.shape = leaf, .material = white, .emission = dvec3(0), .where = {}});
    }
    reference::test::addObject(scene, Csg{0, {CsgStep::Leaf, CsgStep::Leaf, CsgStep::Intersection}}, white);
    return scene;
}

// The picture's square is 2.2 R wide, so the disk has the share pi / 2.2^2 of it; the box's face, whose corners lie on
// the disk's rim, 2 / 2.2^2. 16 384 samples place the edge to within 0.5 %; from a thousand radii, perspective changes
// areas by 0.2 %.
void checkLit(const Lit& lit, double size, double distance) {
    const double share = (lit.name == "box" ? 2 : std::numbers::pi) / 4.84;
    const double expected = 0.8 / std::numbers::pi * lit.cosine * share;
    for (const bool asCsg : {false, true}) {
        for (const Backend backend : kBackends) {
            const double mean = meanOf(rendered(litScene(lit, size, distance, asCsg), backend));
            INFO(lit.name << (asCsg ? " in a csg" : "") << " of " << size << " m from " << distance << " m"
                          << (backend == Backend::Vulkan ? ", device" : ", reference"));
            CHECK(std::abs(mean / expected - 1) < 0.01);
        }
    }
}

// ---- Elsewhere, and in other units

// A room with glass, csg, mesh, checker and lights of each kind; lengths times `unit`, at `place`, radiance the same.
std::string roomText(const dvec3& place, double unit) {
    std::ostringstream text;
    text << std::setprecision(17);
    const auto point = [&](double x, double y, double z) {
        std::ostringstream list;
        list << std::setprecision(17) << '[' << place.x + unit * x << ", " << place.y + unit * y << ", "
             << place.z + unit * z << ']';
        return list.str();
    };
    const auto vector = [&](double x, double y, double z) {
        std::ostringstream list;
        list << std::setprecision(17) << '[' << unit * x << ", " << unit * y << ", " << unit * z << ']';
        return list.str();
    };
    text << "hyalite: 1\n"
         << "camera: {position: " << point(1, 1.3, 2.5) << ", look_at: " << point(0, 0, 0)
         << ", fov: 40, resolution: [48, 48]}\n"
         << "render: {integrator: whitted, passes: 4, photons: 20000, radius: " << 0.1 * unit << "}\n"
         << "textures: {t: {type: checker, size: " << 0.25 * unit << "}}\n"
         << "materials:\n"
         << "  glass: {type: dielectric, ior: 1.5, absorption: " << 0.5 / unit << "}\n"
         << "  tiles: {type: diffuse, albedo: {texture: t}}\n"
         << "  white: {type: diffuse, albedo: 0.7}\n"
         << "lights:\n"
         << "  - {type: directional, direction: [-1, -2, -1.5], irradiance: 1}\n"
         << "  - {type: point, position: " << point(-1, 1.5, 1) << ", intensity: " << 2 * unit * unit << "}\n"
         << "  - {type: spot, position: " << point(1, 1.5, 0.5)
         << ", direction: [-1, -2, -0.5], intensity: " << 2 * unit * unit << ", angle: 30}\n"
         << "objects:\n"
         << "  - {shape: {type: box, min: " << point(-0.4, -0.4, -0.4) << ", max: " << point(0.4, 0.4, 0.4)
         << "}, material: glass}\n"
         << "  - {shape: {type: quad, corner: " << point(-2, -0.6, -2) << ", edges: [" << vector(0, 0, 4) << ", "
         << vector(4, 0, 0) << "]}, material: tiles}\n"
         << "  - {shape: {type: quad, corner: " << point(-1.5, 0, -1.9) << ", edges: [" << vector(1, 0, 0) << ", "
         << vector(0, 1, 0) << "]}, emission: 1}\n"
         << "  - {shape: {type: sphere, center: " << point(-1, -0.3, 0.3) << ", radius: " << 0.3 * unit
         << "}, material: white}\n"
         << "  - {shape: {type: ellipsoid, center: " << point(0.9, -0.2, 0.6) << ", radii: " << vector(0.2, 0.4, 0.3)
         << "}, material: white}\n"
         << "  - {shape: {type: mesh, file: tetrahedron.obj}, material: white}\n"
         << "  - {shape: {type: torus, center: " << point(-0.6, -0.45, 1.1) << ", major: " << 0.2 * unit
         << ", minor: " << 0.08 * unit << "}, material: white}\n"
         << "  - shape:\n      type: csg\n      op: difference\n"
         << "      left: {type: box, min: " << point(0.6, -0.6, -1.4) << ", max: " << point(1.4, 0.2, -0.6) << "}\n"
         << "      right: {type: cylinder, base: " << point(1, -0.7, -1) << ", top: " << point(1, 0.3, -1)
         << ", radius: " << 0.25 * unit << "}\n    material: white\n";
    return text.str();
}

Scene roomScene(const dvec3& place, double unit) {
    test::TemporaryFolder folder;
    std::ostringstream mesh;
    mesh << std::setprecision(17);
    for (const dvec3& corner :
         {dvec3(-0.3, -0.6, -1.3), dvec3(0.3, -0.6, -1.3), dvec3(0, -0.6, -0.8), dvec3(0, 0.2, -1.1)}) {
        const dvec3 p = place + unit * corner;
        mesh << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    mesh << "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
    folder.write("tetrahedron.obj", mesh.str());
    return loadScene(folder.write("room.yaml", roomText(place, unit)));
}

} // namespace

TEST_CASE("a ground of a hundred metres has no specks from five centimetres, whichever solid it is cut from",
          "[scale]") {
    using enum CsgStep;
    const Quadric hole = boxAt({50, -1, 50}, {60, 1, 60});
    const dmat4 turn = glm::rotate(dmat4(1), 0.7, glm::normalize(dvec3(3, 1, 2)));
    for (const Ground& ground : grounds()) {
        checkGround(ground.name + " minus a box", groundScene({ground.solid, hole}, {Leaf, Leaf, Difference}, turn));
    }
    const Shape box = grounds()[0].solid;
    checkGround("box in a ball", groundScene({box, Sphere{dvec3(0), 1000}}, {Leaf, Leaf, Intersection}, turn));
    checkGround("box and box, their tops in one plane",
                groundScene({box, boxAt({-3, -2, -5}, {4, 0, 7})}, {Leaf, Leaf, Union}, dmat4(1)));
}

TEST_CASE("solids of every form have their radiance from ten metres to a million", "[scale]") {
    for (const Lit& lit : litSolids()) {
        checkLit(lit, 1e-4, 10);
        checkLit(lit, 1, 1e5);
    }
    checkLit(litSolids()[1], 1, 1e6);
    checkLit(litSolids()[2], 10, 1e6);
}

TEST_CASE("a scene far from the origin gives the picture that it gives at the origin", "[scale]") {
    for (const Backend backend : kBackends) {
        const Image expected = rendered(roomScene(dvec3(0), 1), backend);
        for (const dvec3& place : {dvec3(1000), dvec3(1e4), dvec3(1e6, -1e6, 1e6), dvec3(345678.5, 1234.5, -5e5)}) {
            const Image image = rendered(roomScene(place, 1), backend);
            INFO((backend == Backend::Vulkan ? "device at " : "reference at ") << place.x << ' ' << place.y);
            CHECK(countOff(image, expected, 0.1) == 0);
            CHECK(std::abs(meanOf(image) / meanOf(expected) - 1) < 1e-4);
        }
    }
}

TEST_CASE("a scene gives the same picture in units from a tenth of a millimetre to a hundred kilometres", "[scale]") {
    for (const Backend backend : kBackends) {
        for (const std::string_view integrator : {"whitted", "ppm"}) {
            const auto picture = [&](double unit) {
                Scene scene = roomScene(dvec3(0), unit);
                scene.render.integrator = integrator;
                return rendered(scene, backend);
            };
            const Image expected = picture(1);
            for (const double unit : {1e-4, 1e5}) {
                const Image image = picture(unit);
                INFO(integrator << (backend == Backend::Vulkan ? ", device" : ", reference") << ", unit " << unit);
                CHECK(countOff(image, expected, 0.1) <= expected.pixels.size() / 200);
                CHECK(std::abs(meanOf(image) / meanOf(expected) - 1) < 1e-3);
            }
        }
    }
}

} // namespace hyalite::testing
