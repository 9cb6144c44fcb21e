#include "transport/audit/draft.h"

#include <array>
#include <numbers>
#include <random>

namespace hyalite::testing {

namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr double kClearance = 0.1;     // of everything from the walls [m]
constexpr double kViewDistance = 0.05; // of the eye from a wall [m]: nothing is between

class Dice {
public:
    explicit Dice(std::uint64_t seed) : engine_(seed) {}
    double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    bool chance(double p) { return unit() < p; }
    template <class T, std::size_t N>
    const T& pick(const std::array<T, N>& choices) {
        return choices.at(static_cast<std::size_t>(unit() * static_cast<double>(N)));
    }
    dvec3 direction() {
        const double z = between(-1, 1);
        const double phi = between(0, 2 * pi);
        const double s = std::sqrt(1 - z * z);
        return {s * std::cos(phi), s * std::sin(phi), z};
    }

private:
    std::mt19937_64 engine_;
};

// Solids in the unit ball.
constexpr std::array<const char*, 16> kSolids{
    "{type: sphere, radius: 1}",
    "{type: sphere, radius: 1}",
    "{type: box, min: [-0.57, -0.57, -0.57], max: [0.57, 0.57, 0.57]}",
    "{type: cylinder, base: [0, -0.7, 0], top: [0, 0.7, 0], radius: 0.7}",
    "{type: cone, base: [0, -0.7, 0], top: [0, 0.7, 0], radius: 0.7, top_radius: 0.2}",
    "{type: torus, major: 0.7, minor: 0.28}",
    "{type: ellipsoid, radii: [1, 0.6, 0.8]}",
    "{type: paraboloid, center: [0, -0.6, 0], radii: [0.7, 1.2, 0.7], clip: {max: [null, 1.2, null]}}",
    "{type: hyperboloid_one_sheet, radii: [0.4, 0.6, 0.4], clip: {min: [null, -0.6, null], max: [null, 0.6, null]}}",
    "{type: hyperboloid_two_sheets, radii: [0.3, 0.3, 0.3], clip: {min: [null, -0.65, null], max: [null, 0.65, null]}}",
    "{type: hyperbolic_paraboloid, radii: [1, 0.7, 1], clip: {min: [-0.55, -0.55, -0.55], max: [0.55, 0.55, 0.55]}}",
    "{type: quadric, coefficients: [1.5, 0.2, -0.1, 0, 1.5, 0.3, 0, 1.4, 0, -1]}",
    "{type: mesh, file: icosahedron.obj, transform: [{scale: 0.5}]}",
    "{type: csg, op: union, left: {type: sphere, radius: 0.7}, right: {type: box, min: [-0.9, -0.3, -0.3], max: [0.9, "
    "0.3, 0.3]}}",
    "{type: csg, op: intersection, left: {type: sphere, radius: 1}, right: {type: box, min: [-0.7, -0.8, -0.6], max: "
    "[0.7, 0.7, 0.7]}}",
    "{type: csg, op: difference, left: {type: box, min: [-0.57, -0.57, -0.57], max: [0.57, 0.57, 0.57]}, right: {type: "
    "sphere, center: [0.4, 0.5, 0.3], radius: 0.6}}",
};

constexpr std::array<const char*, 4> kSheets{
    "{type: quad, corner: [-0.7, 0, 0.7], edges: [[1.4, 0, 0], [0, 0, -1.4]]}",
    "{type: disk, normal: [0, 1, 0], radius: 1}",
    "{type: cylinder, base: [0, -0.7, 0], top: [0, 0.7, 0], radius: 0.7, open: true}",
    "{type: paraboloid, center: [0, -0.6, 0], radii: [0.7, 1.2, 0.7], clip: {max: [null, 1.2, null]}, caps: false}",
};

// Materials of sheets and solids; glass only of solids.
std::string opaque(Dice& dice) {
    const double reflectance = dice.chance(0.3) ? 1 : dice.between(0.2, 1);
    switch (static_cast<int>(dice.between(0, 5))) {
    case 0:
        return text("{type: diffuse, albedo: ", reflectance, "}");
    case 1:
        return text("{type: mirror, reflectance: ", reflectance, "}");
    case 2:
        return text("{type: conductor, eta: ", dice.between(0.1, 2), ", k: ", dice.between(1, 8),
                    ", roughness: ", dice.chance(0.3) ? 0 : dice.unit(), "}");
    case 3:
        return text("{type: metallic_roughness, base_color: ", reflectance,
                    ", metallic: ", dice.chance(0.5) ? dice.unit() : std::round(dice.unit()),
                    ", roughness: ", dice.unit(), "}");
    default:
        return text("{type: clear_coat, base_color: ", reflectance, ", metallic: ", dice.unit(),
                    ", roughness: ", dice.unit(), ", coat: ", dice.unit(),
                    ", coat_roughness: ", dice.chance(0.5) ? 0 : dice.unit(), ", coat_ior: ", dice.between(1, 2), "}");
    }
}

std::string glass(Dice& dice) {
    return text("{type: dielectric, ior: ", dice.chance(0.1) ? dice.between(0.6, 1) : dice.between(1.05, 2.2),
                ", absorption: ", dice.chance(0.5) ? 0 : dice.between(0, 5),
                ", roughness: ", dice.chance(0.6) ? 0 : dice.unit(), "}");
}

bool isFurnace(Audit audit) {
    return audit == Audit::Furnace || audit == Audit::Nested;
}

struct Ball {
    dvec3 center;
    double radius;
};

class Drafting {
public:
    Drafting(std::uint64_t number, Audit audit) : dice_(number * 8 + static_cast<std::uint64_t>(audit)) {
        draft_.number = number;
        draft_.audit = audit;
        draft_.albedo = dice_.between(0.2, 0.8);
        draft_.settings = text("gather_rays: ", dice_.chance(0.5) ? 1 : 0,
                               ", precomputed_irradiance: ", dice_.chance(0.5) ? "true" : "false",
                               ", structure: ", dice_.chance(0.5) ? "grid" : "kdtree", ", ");
    }

    Draft made() {
        const double most = draft_.audit == Audit::Compare ? 4 : 5;
        if (isFurnace(draft_.audit)) {
            draft_.eye = place(0.05).center;
            draft_.direction = dice_.direction();
        }
        addLights();
        for (auto left = static_cast<int>(dice_.between(1, most)); left > 0; --left) {
            draft_.objects.push_back(object());
        }
        return draft_;
    }

private:
    // A free place for something of that radius; smaller if there is little room.
    Ball place(double radius) {
        for (int tries = 1;; ++tries) {
            const double reach = 1 - kClearance - radius;
            const dvec3 c(dice_.between(-reach, reach), dice_.between(-reach, reach), dice_.between(-reach, reach));
            const bool free = std::none_of(taken_.begin(), taken_.end(), [&](const Ball& other) {
                return glm::length(other.center - c) < 1.02 * (other.radius + radius);
            });
            if (free) {
                taken_.push_back({c, radius});
                return taken_.back();
            }
            if (tries % 20 == 0) {
                radius *= 0.8;
            }
        }
    }

    std::string transformTo(const Ball& ball, bool stretched) {
        const double r = ball.radius;
        const dvec3 scale = stretched ? dvec3(r, dice_.between(0.4, 1) * r, dice_.between(0.4, 1) * r) : dvec3(r);
        return text("transform: [{scale: ", scale, "}, {rotate: {axis: ", dice_.direction(),
                    ", degrees: ", dice_.between(0, 360), "}}, {translate: ", ball.center, "}]");
    }

    Part object() {
        const bool isSheet = dice_.chance(0.2);
        const std::string shape = isSheet ? dice_.pick(kSheets) : dice_.pick(kSolids);
        const bool isGlass = !isSheet && dice_.chance(0.45);
        Part part{.keys = {}, .material = isGlass ? glass(dice_) : opaque(dice_)};
        const bool overlaps = draft_.audit == Audit::Nested;
        if (overlaps && isGlass && dice_.chance(0.5)) {
            part.material.insert(1, text("priority: ", static_cast<int>(dice_.between(1, 4)), ", "));
        }
        const Ball ball = place(dice_.between(0.15, 0.45));
        if (overlaps) {
            taken_.pop_back(); // others may be there too
        }
        part.keys = "shape: " + shape + ", " + transformTo(ball, dice_.chance(0.3));
        return part;
    }

    void addLights() {
        if (isFurnace(draft_.audit)) {
            return; // the walls
        }
        if (draft_.audit == Audit::Sealed) {
            draft_.lights.push_back(
                {.keys = text("type: directional, direction: ", dice_.direction(), ", irradiance: 1000")});
            draft_.lights.push_back({.keys = "type: environment, radiance: 10"});
            addSheetOutside();
            addSheetOutside();
            return;
        }
        for (auto left = static_cast<int>(dice_.between(1, 3.5)); left > 0; --left) {
            const double kind = draft_.audit == Audit::Compare ? 1 : dice_.unit();
            if (kind < 0.25) {
                addPoint();
            } else if (kind < 0.45) {
                addSpot();
            } else if (kind < 0.6) {
                addBeam();
            } else {
                addArea();
            }
        }
    }

    // Close behind a wall, with its front to the room: sunlit photons there face as the wall's own would.
    void addSheetOutside() {
        const auto axis = static_cast<int>(dice_.between(0, 3));
        dvec3 n(0);
        dvec3 a(0);
        dvec3 b(0);
        n[axis] = dice_.chance(0.5) ? 1 : -1;
        a[(axis + 1) % 3] = 6;
        b[(axis + 2) % 3] = 6;
        const dvec3 corner = -(1 + dice_.between(0.005, 0.1)) * n - 0.5 * (a + b);
        draft_.objects.push_back({.keys = text("shape: {type: quad, corner: ", corner, ", edges: [",
                                               n[axis] > 0 ? a : b, ", ", n[axis] > 0 ? b : a, "]}"),
                                  .material = "{type: diffuse, albedo: 0.7}"});
    }

    void addPoint() {
        const double intensity = dice_.between(0.1, 3);
        draft_.lights.push_back(
            {.keys = text("type: point, position: ", place(0.02).center, ", intensity: ", intensity),
             .power = 4 * pi * intensity});
    }

    void addSpot() {
        const double intensity = dice_.between(0.1, 10);
        const double angle = dice_.between(5, 120);
        const double blend = dice_.unit();
        const auto cosine = [](double degrees) { return std::cos(degrees * pi / 180); };
        draft_.lights.push_back(
            {.keys = text("type: spot, position: ", place(0.02).center, ", direction: ", dice_.direction(),
                          ", intensity: ", intensity, ", angle: ", angle, ", blend: ", blend),
             .power = pi * intensity * (2 - cosine((1 - blend) * angle) - cosine(angle))});
    }

    void addBeam() {
        const double irradiance = dice_.between(1, 50);
        const Ball ball = place(dice_.between(0.05, 0.3));
        draft_.lights.push_back({.keys = text("type: directional, direction: ", dice_.direction(), ", center: ",
                                              ball.center, ", radius: ", ball.radius, ", irradiance: ", irradiance),
                                 .power = pi * ball.radius * ball.radius * irradiance});
    }

    void addArea() {
        const double radiance = dice_.between(0.5, 5);
        const bool reflects = dice_.chance(0.5);
        const Ball ball = place(dice_.between(draft_.audit == Audit::Compare ? 0.25 : 0.08, 0.3));
        const double r = ball.radius;
        struct Emitter {
            const char* shape;
            double area; // of the unit shape
        };
        const std::array<Emitter, 4> emitters{
            Emitter{"{type: sphere, radius: 1}", 4 * pi},
            Emitter{kSheets[0], 1.4 * 1.4},
            Emitter{kSheets[1], pi},
            // 20 triangles with edges of 1 (2 in the file)
            Emitter{"{type: mesh, file: icosahedron.obj, transform: [{scale: 0.5}]}", 5 * std::sqrt(3.0)},
        };
        const Emitter& emitter = dice_.pick(emitters);
        draft_.objects.push_back(
            {.keys = text("shape: ", emitter.shape, ", emission: ", radiance, ", ", transformTo(ball, false)),
             .material = reflects ? text("{type: diffuse, albedo: ", dice_.unit(), "}") : "",
             .power = pi * radiance * emitter.area * r * r});
    }

    Dice dice_;
    Draft draft_;
    std::vector<Ball> taken_;
};

// The room's walls, their fronts inside.
std::string walls(const std::string& more) {
    std::string list;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 n(0);
        dvec3 a(0);
        dvec3 b(0);
        n[axis] = 1;
        a[(axis + 1) % 3] = 2;
        b[(axis + 2) % 3] = 2;
        list += text("  - {shape: {type: quad, corner: ", -n - 0.5 * (a + b), ", edges: [", a, ", ", b,
                     "]}, material: wall", more, "}\n");
        list += text("  - {shape: {type: quad, corner: ", n - 0.5 * (a + b), ", edges: [", b, ", ", a,
                     "]}, material: wall", more, "}\n");
    }
    return list;
}

} // namespace

double Draft::power() const {
    double sum = 0;
    for (const auto* parts : {&objects, &lights}) {
        for (const Part& part : *parts) {
            sum += part.power;
        }
    }
    return sum;
}

std::size_t Draft::views() const {
    return audit == Audit::Lit ? 6 : 1;
}

std::string Draft::scene(std::size_t view) const {
    std::string camera;
    if (isFurnace(audit)) {
        const dvec3 up = std::abs(direction.y) > 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
        camera = text("camera: {position: ", eye, ", look_at: ", eye + direction, ", up: ", up,
                      ", fov: 100, resolution: [8, 8]}\n");
    } else {
        const auto wall = audit == Audit::Lit ? view : static_cast<std::size_t>(number % 6);
        dvec3 normal(0);
        dvec3 up(0);
        normal[static_cast<int>(wall / 2)] = wall % 2 == 0 ? 1 : -1;
        up[static_cast<int>((wall / 2 + 1) % 3)] = 1;
        const double width = audit == Audit::Compare ? 1.2 : 2;
        const double fov = 2 * std::atan(width / 2 / kViewDistance) * 180 / pi;
        camera = text("camera: {position: ", (kViewDistance - 1) * normal, ", look_at: ", -normal, ", up: ", up,
                      ", fov: ", fov, ", resolution: [4, 4]}\n");
    }
    std::string materials = text("materials: {wall: {type: diffuse, albedo: ", albedo, "}");
    std::string list = walls(isFurnace(audit) ? text(", emission: ", 1 - albedo) : "");
    for (std::size_t i = 0; i < objects.size(); ++i) {
        if (!objects[i].material.empty()) {
            materials += text(", m", i, ": ", objects[i].material);
        }
        list += "  - {" + objects[i].keys + (objects[i].material.empty() ? "" : text(", material: m", i)) + "}\n";
    }
    std::string sources;
    for (const Part& light : lights) {
        sources += (sources.empty() ? "{" : ", {") + light.keys + "}";
    }
    return text(camera, "render: {", settings, "max_depth: 24}\n", materials, "}\nlights: [", sources, "]\nobjects:\n",
                list);
}

Audit auditOf(std::uint64_t number) {
    constexpr std::array kAudits{Audit::Lit, Audit::Lit, Audit::Furnace, Audit::Sealed, Audit::Nested};
    return kAudits.at(number % kAudits.size());
}

Draft draftScene(std::uint64_t number, Audit audit) {
    return Drafting(number, audit).made();
}

const std::map<std::string, std::string>& draftFiles() {
    static const std::map<std::string, std::string> files{
        {"icosahedron.obj", "v 0 1 1.618034\nv 0 -1 1.618034\nv 0 1 -1.618034\nv 0 -1 -1.618034\n"
                            "v 1 1.618034 0\nv -1 1.618034 0\nv 1 -1.618034 0\nv -1 -1.618034 0\n"
                            "v 1.618034 0 1\nv -1.618034 0 1\nv 1.618034 0 -1\nv -1.618034 0 -1\n"
                            "f 1 2 9\nf 1 9 5\nf 1 5 6\nf 1 6 10\nf 1 10 2\nf 2 7 9\nf 9 7 11\n"
                            "f 9 11 5\nf 5 11 3\nf 5 3 6\nf 6 3 12\nf 6 12 10\nf 10 12 8\nf 10 8 2\n"
                            "f 2 8 7\nf 4 7 8\nf 4 11 7\nf 4 3 11\nf 4 12 3\nf 4 8 12\n"}};
    return files;
}

} // namespace hyalite::testing
