// See object_table.h.
#include "render/upload/object_table.h"

#include "geometry/bvh.h"
#include "kinds/shapes/object_record.h"
#include "scene/model/bounds.h"
#include "scene/model/quadric.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hyalite::render {

namespace {

using glm::dvec3;
using glm::vec4;
using kinds::bits;
using kinds::ObjectRecord;

// Intersecting an object costs more than visiting a node: leaves of two are up to a tenth slower.
constexpr std::uint32_t kObjectsPerLeaf = 1;

class TableBuilder {
public:
    TableBuilder(const Scene& scene, const std::vector<std::uint32_t>& meshRoots, std::uint32_t firstLight,
                 std::vector<glm::uvec4>& geometry)
        : scene_(scene), light_(firstLight), geometry_(geometry), tables_{scene, meshRoots, geometry} {}

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

        tables_.nextLeaf = static_cast<std::uint32_t>(order.size());
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
        return std::visit([&](const auto& s) { return kinds::record(s, tables_); }, shape);
    }

    void appendLeaves(const Csg& csg, std::uint32_t whole, std::uint32_t sceneObject) {
        const std::vector<std::uint32_t> types = kinds::leafTypes(csg);
        table_.mostLeaves = std::max(table_.mostLeaves, kinds::leafCount(csg));
        for (std::size_t i = 0; i < types.size(); ++i) {
            const Object& leaf = scene_.csgLeaves[csg.firstLeaf + i];
            const auto* plane = std::get_if<Plane>(&leaf.shape);
            ObjectRecord r = plane != nullptr ? kinds::record(halfSpace(*plane), tables_) : recordOf(leaf.shape);
            r.type |= types[i];
            append(r, leaf, whole, sceneObject, static_cast<std::uint32_t>(csg.firstLeaf + i));
        }
    }

    // `light`: for a leaf of CSG, the device object it is part of.
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
    std::uint32_t light_;
    std::vector<glm::uvec4>& geometry_;
    kinds::ObjectTables tables_;
    ObjectTable table_;
};

} // namespace

ObjectTable buildObjectTable(const Scene& scene, const std::vector<std::uint32_t>& meshRoots, std::uint32_t firstLight,
                             std::vector<glm::uvec4>& geometry) {
    return TableBuilder(scene, meshRoots, firstLight, geometry).build();
}

} // namespace hyalite::render
