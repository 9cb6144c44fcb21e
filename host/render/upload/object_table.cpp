// See object_table.h.
#include "render/upload/object_table.h"

#include "geometry/bvh.h"
#include "scene/model/bounds.h"
#include "scene/model/quadric.h"

#include <array>
#include <bit>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

namespace hyalite::render {

namespace {

using glm::dmat4;
using glm::dvec3;
using glm::dvec4;
using glm::vec3;
using glm::vec4;

// To try an object costs more than to look at a node: leaves of two are up to a tenth slower.
constexpr std::uint32_t kObjectsPerLeaf = 1;

// The far side of a box that has none: beyond kEndless of the kernels whatever the transform.
constexpr double kNoSide = 3e38;

struct ObjectRecord {
    std::array<vec4, shared::kTexelsPerObject> texels{};
    shared::InstanceRecord instance{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};
    std::uint32_t type = 0; // and flags
    std::uint32_t root = 0;
};

float bits(std::uint32_t value) {
    return std::bit_cast<float>(value);
}

vec4 row(const dmat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

ObjectRecord record(const Sphere& sphere) {
    ObjectRecord r{.type = shared::kShapeSphere};
    r.texels[0] = vec4(vec3(sphere.center), static_cast<float>(sphere.radius));
    return r;
}

// The plane through a point with two axes, and coordinates in which the axes have length one: the rows of the inverse
// of (axis0, axis1, normal).
ObjectRecord flatRecord(std::uint32_t type, const dvec3& origin, const dvec3& axis0, const dvec3& axis1) {
    const dvec3 cross = glm::cross(axis0, axis1);
    const double area2 = glm::dot(cross, cross);
    const dvec3 u = glm::cross(axis1, cross) / area2;
    const dvec3 v = glm::cross(cross, axis0) / area2;
    const dvec3 normal = cross / std::sqrt(area2);
    ObjectRecord r{.type = type};
    r.texels[0] = vec4(vec3(normal), static_cast<float>(glm::dot(normal, origin)));
    r.texels[1] = vec4(vec3(u), static_cast<float>(-glm::dot(u, origin)));
    r.texels[2] = vec4(vec3(v), static_cast<float>(-glm::dot(v, origin)));
    return r;
}

ObjectRecord record(const Quad& quad) {
    return flatRecord(shared::kShapeQuad, quad.corner, quad.edge0, quad.edge1);
}

ObjectRecord record(const Disk& disk) {
    return flatRecord(shared::kShapeDisk, disk.center, disk.axis0, disk.axis1);
}

ObjectRecord record(const Plane& plane) {
    const dvec3 n = plane.normal;
    const dvec3 across = glm::normalize(std::abs(n.x) < 0.5 ? glm::cross(n, dvec3(1, 0, 0)) //
                                                            : glm::cross(n, dvec3(0, 1, 0)));
    return flatRecord(shared::kShapePlane, plane.point, across, glm::cross(n, across));
}

// The map from world space to the shape's own about `center` (object space), with the origin in world space where a
// float can hold it; returns that origin in object space.
dvec3 setLocalSpace(ObjectRecord& r, const dmat4& objectToWorld, const dvec3& center) {
    const vec3 origin(objectToWorld * dvec4(center, 1));
    const dmat4 toObject = glm::inverse(objectToWorld);
    for (int i = 0; i < 3; ++i) {
        r.texels[static_cast<std::size_t>(i)] = vec4(vec3(row(toObject, i)), origin[i]);
    }
    return toObject * dvec4(dvec3(origin), 1);
}

// Where the form is best written about: near the middle of the box if it has one, else near its own origin.
dvec3 localCenter(const Quadric& quadric) {
    const Bounds box = objectBounds(quadric);
    const dvec3 near = isFinite(box) ? 0.5 * (box.low + box.high) : dvec3(0);
    const dvec3 center = near + formCenter(transformed(quadric.form, glm::translate(dmat4(1), -near)));
    // The centre of a slice far from it is of no use
    const bool isNear = !isFinite(box) || glm::length(center - near) <= 2 * glm::length(box.high - box.low);
    return isNear ? center : near;
}

ObjectRecord record(const Quadric& quadric) {
    ObjectRecord r{.type = shared::kShapeQuadric};
    const bool isClipped =
        quadric.clip.low != Bounds::everything().low || quadric.clip.high != Bounds::everything().high;
    if (isClipped && !quadric.capped) {
        r.type |= shared::kShapeOpen;
    }
    const dvec3 origin = setLocalSpace(r, quadric.objectToWorld, localCenter(quadric));
    const QuadricForm q = transformed(quadric.form, glm::translate(dmat4(1), -origin));
    const dvec3 low = glm::max(quadric.clip.low - origin, dvec3(-kNoSide));
    const dvec3 high = glm::min(quadric.clip.high - origin, dvec3(kNoSide));
    r.texels[4] = dvec4(q.a, q.e, q.h, q.j);
    r.texels[5] = dvec4(q.b, q.c, q.f, low.x);
    r.texels[6] = dvec4(q.d, q.g, q.i, high.x);
    r.texels[7] = dvec4(low.y, high.y, low.z, high.z);
    return r;
}

ObjectRecord record(const Torus& torus) {
    ObjectRecord r{.type = shared::kShapeTorus};
    setLocalSpace(r, torus.objectToWorld, dvec3(0));
    r.texels[4] = dvec4(torus.major, torus.minor, 0, 0);
    return r;
}

class TableBuilder {
public:
    TableBuilder(const Scene& scene, const std::vector<std::uint32_t>& meshRoots, std::uint32_t firstLight,
                 std::vector<glm::uvec4>& geometry)
        : scene_(scene), meshRoots_(meshRoots), light_(firstLight), geometry_(geometry) {}

    ObjectTable build() {
        std::vector<std::uint32_t> lights;
        std::vector<std::uint32_t> order; // scene objects
        std::vector<std::uint32_t> bounded;
        std::vector<Aabb> boxes;
        for (std::uint32_t i = 0; i < scene_.objects.size(); ++i) {
            const Object& object = scene_.objects[i];
            lights.push_back(object.emission != dvec3(0) ? light_++ : shared::kNone);
            const Bounds box = worldBounds(scene_, object);
            if (isFinite(box)) {
                bounded.push_back(i);
                boxes.push_back(rounded(box));
            } else {
                order.push_back(i);
            }
        }
        table_.endlessCount = static_cast<std::uint32_t>(order.size());
        addHierarchy(boxes, bounded, order);

        nextLeaf_ = static_cast<std::uint32_t>(order.size());
        for (const std::uint32_t object : order) {
            append(recordOf(scene_.objects[object].shape), scene_.objects[object], lights[object], object,
                   shared::kNone);
        }
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            if (const auto* csg = std::get_if<Csg>(&scene_.objects[order[i]].shape)) {
                appendLeaves(*csg, i, order[i]);
            }
        }
        return std::move(table_);
    }

private:
    // The smallest box of floats around a box of doubles.
    static Aabb rounded(const Bounds& box) {
        Aabb result;
        for (int axis = 0; axis < 3; ++axis) {
            constexpr float kInfinite = std::numeric_limits<float>::infinity();
            result.lower[axis] = std::nextafter(static_cast<float>(box.low[axis]), -kInfinite);
            result.upper[axis] = std::nextafter(static_cast<float>(box.high[axis]), kInfinite);
        }
        return result;
    }

    void addHierarchy(const std::vector<Aabb>& boxes, const std::vector<std::uint32_t>& bounded,
                      std::vector<std::uint32_t>& order) {
        Bvh bvh = buildBvh(boxes, kObjectsPerLeaf);
        table_.rootNode = static_cast<std::uint32_t>(geometry_.size() / shared::kTexelsPerRecord);
        table_.stackEntries = bvh.stackEntries;
        relocate(bvh, table_.rootNode, table_.endlessCount);
        geometry_.insert(geometry_.end(), bvh.texels.begin(), bvh.texels.end());
        for (const std::uint32_t element : bvh.order) {
            order.push_back(bounded[element]);
        }
    }

    [[nodiscard]] ObjectRecord recordOf(const Shape& shape) {
        return std::visit([&](const auto& s) { return make(s); }, shape);
    }
    template <class S>
    [[nodiscard]] ObjectRecord make(const S& shape) const {
        return record(shape);
    }
    [[nodiscard]] ObjectRecord make(const MeshInstance& instance) const {
        const bool isSmooth = !scene_.meshes[instance.mesh].normals.empty();
        ObjectRecord r{.type = shared::kShapeMesh | (isSmooth ? shared::kShapeSmooth : 0),
                       .root = meshRoots_[instance.mesh]};
        const dmat4 toObject = glm::inverse(instance.objectToWorld);
        for (int i = 0; i < 3; ++i) {
            r.texels[static_cast<std::size_t>(i)] = row(toObject, i);
        }
        r.instance = {row(instance.objectToWorld, 0), row(instance.objectToWorld, 1), row(instance.objectToWorld, 2)};
        return r;
    }
    [[nodiscard]] ObjectRecord make(const Csg& csg) {
        const auto leaves = static_cast<std::uint32_t>((csg.program.size() + 1) / 2);
        ObjectRecord r{.type = shared::kShapeCsg, .root = static_cast<std::uint32_t>(geometry_.size())};
        r.texels[0] = vec4(bits(nextLeaf_), bits(leaves), 0, 0);
        nextLeaf_ += leaves;
        table_.mostLeaves = std::max(table_.mostLeaves, leaves);
        glm::uvec4 words(0);
        for (std::uint32_t i = 0; i < csg.program.size(); ++i) {
            words[static_cast<int>(i / 16)] |= code(csg.program[i]) << 2 * (i % 16);
        }
        geometry_.push_back(words);
        return r;
    }

    static std::uint32_t code(CsgStep step) {
        switch (step) {
        case CsgStep::Leaf:
            return shared::kCsgLeaf;
        case CsgStep::Union:
            return shared::kCsgUnion;
        case CsgStep::Intersection:
            return shared::kCsgIntersection;
        case CsgStep::Difference:
            break;
        }
        return shared::kCsgDifference;
    }

    // What each leaf is to the solid, as bits of its type: reversed under an odd number of right operands of
    // differences; required where nothing is left of the solid without it.
    static std::vector<std::uint32_t> leafTypes(const Csg& csg) {
        std::vector<std::uint32_t> types;
        std::vector<std::size_t> stack; // first leaf of each operand
        for (const CsgStep step : csg.program) {
            if (step == CsgStep::Leaf) {
                stack.push_back(types.size());
                types.push_back(shared::kShapeLeaf | shared::kShapeRequired);
                continue;
            }
            const std::size_t right = stack.back();
            stack.pop_back();
            for (std::size_t leaf = stack.back(); leaf < types.size(); ++leaf) {
                const bool isTakenOff = step == CsgStep::Difference && leaf >= right;
                types[leaf] ^= isTakenOff ? shared::kShapeReversed : 0;
                if (isTakenOff || step == CsgStep::Union) {
                    types[leaf] &= ~shared::kShapeRequired;
                }
            }
        }
        return types;
    }

    void appendLeaves(const Csg& csg, std::uint32_t whole, std::uint32_t sceneObject) {
        const std::vector<std::uint32_t> types = leafTypes(csg);
        for (std::size_t i = 0; i < types.size(); ++i) {
            const Object& leaf = scene_.csgLeaves[csg.firstLeaf + i];
            const auto* plane = std::get_if<Plane>(&leaf.shape);
            ObjectRecord r = plane != nullptr ? record(halfSpace(*plane)) : recordOf(leaf.shape);
            r.type |= types[i];
            append(r, leaf, whole, sceneObject, static_cast<std::uint32_t>(csg.firstLeaf + i));
        }
    }

    // `light`: of a leaf of CSG, the device object it is part of.
    void append(ObjectRecord r, const Object& object, std::uint32_t light, std::uint32_t sceneObject,
                std::uint32_t leaf) {
        const std::uint32_t material = object.material ? static_cast<std::uint32_t>(*object.material) : shared::kNone;
        r.texels[3] = vec4(bits(r.type), bits(material), bits(light), bits(r.root));
        table_.texels.insert(table_.texels.end(), r.texels.begin(), r.texels.end());
        table_.instances.push_back(r.instance);
        table_.objectOf.push_back(sceneObject);
        table_.leafOf.push_back(leaf);
        table_.shapeTypes |= 1U << (r.type & shared::kShapeTypeMask);
    }

    const Scene& scene_;
    const std::vector<std::uint32_t>& meshRoots_;
    std::uint32_t light_;
    std::vector<glm::uvec4>& geometry_;
    std::uint32_t nextLeaf_ = 0;
    ObjectTable table_;
};

} // namespace

ObjectTable buildObjectTable(const Scene& scene, const std::vector<std::uint32_t>& meshRoots, std::uint32_t firstLight,
                             std::vector<glm::uvec4>& geometry) {
    return TableBuilder(scene, meshRoots, firstLight, geometry).build();
}

} // namespace hyalite::render
