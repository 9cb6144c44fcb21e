// See repeated_objects.h. Each shape is described by numbers that do not depend on how the file writes it, rounded to a
// grid, and looked up in a hash table.
#include "scene/load/repeated_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace hyalite {
namespace {

using glm::dvec3;

// Numbers of equal shapes are equal, whichever way round; `side` is 1 or -1, and differs for a shape back to back.
struct ShapeKey {
    std::vector<std::int64_t> numbers;
    int side = 1;
};

struct NumbersHash {
    std::size_t operator()(const std::vector<std::int64_t>& numbers) const {
        std::uint64_t state = numbers.size();
        for (const std::int64_t number : numbers) {
            state = (state ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
            state ^= state >> 32U;
        }
        return static_cast<std::size_t>(state);
    }
};

// The step of a grid for numbers up to `largest`: 2^-42 of it, far coarser than a few roundings of doubles and far
// finer than any gap a renderer can see. A power of two, and not near a step from one to the next for round numbers.
double gridStep(double largest) {
    constexpr double kOffRound = 1.234;
    return std::exp2(std::ceil(std::log2(std::max(largest, 1e-30) * kOffRound)) - 42);
}

class KeyMaker {
public:
    KeyMaker(const Scene& scene, std::vector<std::int64_t>& numbers) : scene_(scene), numbers_(numbers) {}

    int make(const Shape& shape) {
        numbers_.push_back(static_cast<std::int64_t>(shape.index()));
        return std::visit([&](const auto& one) { return add(one); }, shape);
    }

private:
    // Rounds values of one unit; their grid suits the largest of them, and is no finer than for `atLeast`.
    void put(std::span<const double> values, double atLeast = 0) {
        double largest = atLeast;
        for (const double value : values) {
            largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
        }
        const double step = gridStep(largest);
        numbers_.push_back(std::ilogb(step));
        for (const double value : values) {
            numbers_.push_back(rounded(value, step));
        }
    }
    void put(const dvec3& v, double atLeast = 0) { put(std::array{v.x, v.y, v.z}, atLeast); }
    void put(const glm::dmat4& m) {
        put(std::array{m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2], m[3][0],
                       m[3][1], m[3][2]});
    }

    static std::int64_t rounded(double value, double step) {
        constexpr double kOffGrid = 0.382; // so that round numbers lie well within a cell
        return std::isfinite(value) ? static_cast<std::int64_t>(std::floor(value / step + kOffGrid))
                                    : (value > 0 ? INT64_MAX : INT64_MIN);
    }

    // The sign of the largest component.
    static int sideOf(const dvec3& normal) {
        const dvec3 size = glm::abs(normal);
        const int axis =
            size.x > 0.999 * size.y ? (size.x > 0.999 * size.z ? 0 : 2) : (size.y > 0.999 * size.z ? 1 : 2);
        return normal[axis] < 0 ? -1 : 1;
    }

    int add(const Sphere& sphere) {
        put(std::array{sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius});
        return 1;
    }
    // Its corners, in the order of their coordinates.
    int add(const Quad& quad) {
        const std::array corners{quad.corner, quad.corner + quad.edge0, quad.corner + quad.edge1,
                                 quad.corner + quad.edge0 + quad.edge1};
        double largest = 0;
        for (const dvec3& corner : corners) {
            largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
        }
        const double step = gridStep(largest);
        std::array<std::array<std::int64_t, 3>, 4> cells{};
        for (std::size_t i = 0; i < 4; ++i) {
            const dvec3& c = corners.at(i);
            cells.at(i) = {rounded(c.x, step), rounded(c.y, step), rounded(c.z, step)};
        }
        std::ranges::sort(cells);
        numbers_.push_back(std::ilogb(step));
        for (const auto& cell : cells) {
            numbers_.insert(numbers_.end(), cell.begin(), cell.end());
        }
        return sideOf(glm::cross(quad.edge0, quad.edge1));
    }
    // Its centre and the ellipse's quadratic form.
    int add(const Disk& disk) {
        const dvec3& a = disk.axis0;
        const dvec3& b = disk.axis1;
        put(disk.center, std::max(glm::length(a), glm::length(b)));
        put(std::array{a.x * a.x + b.x * b.x, a.y * a.y + b.y * b.y, a.z * a.z + b.z * b.z, a.x * a.y + b.x * b.y,
                       a.y * a.z + b.y * b.z, a.z * a.x + b.z * b.x});
        return sideOf(glm::cross(a, b));
    }
    int add(const Plane& plane) {
        const int side = sideOf(plane.normal);
        const dvec3 normal = static_cast<double>(side) * plane.normal;
        put(normal);
        put(glm::dot(plane.point, normal) * normal, 1.0); // whichever of its points the file names
        return side;
    }
    int add(const Quadric& quadric) {
        const QuadricForm& q = quadric.form;
        put(std::array{q.a, q.b, q.c, q.d, q.e, q.f, q.g, q.h, q.i, q.j});
        put(quadric.clip.low);
        put(quadric.clip.high);
        put(quadric.objectToWorld);
        numbers_.push_back(quadric.capped ? 1 : 0);
        return 1;
    }
    int add(const Torus& torus) {
        put(std::array{torus.major, torus.minor, 0.0});
        put(torus.objectToWorld);
        return 1;
    }
    int add(const MeshInstance& instance) {
        numbers_.push_back(static_cast<std::int64_t>(instance.mesh));
        put(instance.objectToWorld);
        return 1;
    }
    int add(const Csg& csg) {
        std::size_t leaf = csg.firstLeaf;
        for (const CsgStep step : csg.program) {
            numbers_.push_back(static_cast<std::int64_t>(step));
            if (step == CsgStep::Leaf) {
                const Object& object = scene_.csgLeaves[leaf++];
                make(object.shape);
                numbers_.push_back(object.material ? static_cast<std::int64_t>(*object.material) : -1);
            }
        }
        return 1;
    }

    const Scene& scene_;
    std::vector<std::int64_t>& numbers_;
};

ShapeKey keyOf(const Scene& scene, const Object& object) {
    ShapeKey key;
    key.side = KeyMaker(scene, key.numbers).make(object.shape);
    return key;
}

bool emits(const Object& object) {
    return object.emission != dvec3(0);
}

bool isGlass(const Scene& scene, const Object& object) {
    return object.material && scene.materials[*object.material].model.type == shared::kMaterialDielectric;
}

std::string placeOf(const Object& object) {
    return "the object at line " + std::to_string(object.where.line) + " column " + std::to_string(object.where.column);
}

// Whether to drop the object, which is in the place of an earlier one on the same side.
bool isRepetition(Scene& scene, const Object& object, const Object& earlier) {
    if (emits(object) && emits(earlier) && object.emission != earlier.emission) {
        throw Error(ExitCode::BadInput, object.where, "this light has the shape and the place of " + placeOf(earlier),
                    "a surface has one emission: remove one of them, or move it");
    }
    const bool isSame = object.material == earlier.material && object.emission == earlier.emission;
    warn(scene, {WarningKind::RepeatedObject, object.where,
                 "this object has the shape and the place of " + placeOf(earlier) +
                     (isSame ? " and is left out" : ": rounding decides which of them shows"),
                 "remove one of them"});
    return isSame;
}

} // namespace

void dropRepeatedObjects(Scene& scene) {
    std::unordered_map<std::vector<std::int64_t>, std::array<std::size_t, 2>, NumbersHash> known; // by side
    constexpr std::size_t kNone = SIZE_MAX;
    std::vector<Object> kept;
    kept.reserve(scene.objects.size());
    for (Object& object : scene.objects) {
        ShapeKey key = keyOf(scene, object);
        auto& sides = known.try_emplace(std::move(key.numbers), std::array{kNone, kNone}).first->second;
        const std::size_t side = key.side > 0 ? 0 : 1;
        if (sides.at(side) != kNone) {
            if (isRepetition(scene, object, kept[sides.at(side)])) {
                continue;
            }
        } else if (sides.at(1 - side) != kNone) {
            const Object& back = kept[sides.at(1 - side)];
            if (emits(object) || emits(back) || isGlass(scene, object) || isGlass(scene, back)) {
                warn(scene, {WarningKind::BackToBack, object.where,
                             "this object lies back to back with " + placeOf(back) +
                                 ": rounding decides which of them a ray meets",
                             "leave a gap of at least 1e-5 of their distance from the origin"});
            }
        }
        sides.at(side) = sides.at(side) == kNone ? kept.size() : sides.at(side);
        kept.push_back(std::move(object));
    }
    scene.objects = std::move(kept);
}

} // namespace hyalite
