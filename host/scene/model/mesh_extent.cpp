// See mesh_extent.h.
#include "scene/model/mesh_extent.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace hyalite {
namespace {

using glm::dvec3;

constexpr std::uint32_t kCells = 8;   // along each edge of the mesh's box
constexpr double kRounding = 0x1p-45; // of the sums below, over the sum of their terms' sizes

// The cell of a point of the box, as a number.
std::uint32_t cellOf(const Bounds& box, const dvec3& point) {
    std::uint32_t cell = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double size = box.high[axis] - box.low[axis];
        const double place = size > 0 ? (point[axis] - box.low[axis]) / size * kCells : 0;
        cell = cell * kCells + static_cast<std::uint32_t>(std::clamp(place, 0.0, kCells - 1.0));
    }
    return cell;
}

} // namespace

MeshExtent::MeshExtent(const Mesh& mesh) {
    std::vector<bool> isUsed(mesh.positions.size(), false);
    for (const glm::uvec3& triangle : mesh.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            isUsed[triangle[corner]] = true;
        }
    }
    Bounds box;
    for (std::size_t i = 0; i < isUsed.size(); ++i) {
        if (isUsed[i]) {
            vertices_.emplace_back(mesh.positions[i]);
            box.add(vertices_.back());
        }
    }
    std::vector<std::pair<std::uint32_t, dvec3>> placed;
    placed.reserve(vertices_.size());
    for (const dvec3& vertex : vertices_) {
        placed.emplace_back(cellOf(box, vertex), vertex);
    }
    std::ranges::stable_sort(placed, {}, &std::pair<std::uint32_t, dvec3>::first);
    for (std::size_t begin = 0; begin < placed.size();) {
        Bounds bounds;
        std::size_t end = begin;
        for (; end < placed.size() && placed[end].first == placed[begin].first; ++end) {
            vertices_[end] = placed[end].second;
            bounds.add(placed[end].second);
        }
        for (const dvec3& part : {0.5 * (bounds.low + bounds.high), 0.5 * (bounds.high - bounds.low)}) {
            boxes_.insert(boxes_.end(), {part.x, part.y, part.z});
        }
        farthest_ = glm::max(farthest_, glm::max(glm::abs(bounds.low), glm::abs(bounds.high)));
        ends_.push_back(end);
        begin = end;
    }
}

// As the product of glm's matrix and vector, term by term.
void MeshExtent::add(std::size_t cell, const glm::dmat4& objectToWorld, Bounds& box) const {
    const dvec3* const begin = vertices_.data() + (cell == 0 ? 0 : ends_[cell - 1]);
    const dvec3* const end = vertices_.data() + ends_[cell];
    for (int axis = 0; axis < 3; ++axis) {
        const double x = objectToWorld[0][axis];
        const double y = objectToWorld[1][axis];
        const double z = objectToWorld[2][axis];
        const double moved = objectToWorld[3][axis];
        double low = box.low[axis];
        double high = box.high[axis];
        for (const dvec3* vertex = begin; vertex != end; ++vertex) {
            const double place = (x * vertex->x + y * vertex->y) + (z * vertex->z + moved);
            low = place < low ? place : low;
            high = place > high ? place : high;
        }
        box.low[axis] = low;
        box.high[axis] = high;
    }
}

// Loops over plain numbers: this runs for every instance, in builds with little optimization too.
Bounds MeshExtent::under(const glm::dmat4& objectToWorld) const {
    const std::size_t count = ends_.size();
    if (count == 0) {
        return {};
    }
    std::vector<double> reaches(6 * count); // along each axis, how far each cell reaches at most, down and up
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = objectToWorld[0][axis];
        const double y = objectToWorld[1][axis];
        const double z = objectToWorld[2][axis];
        const double moved = objectToWorld[3][axis];
        const double sizeX = std::abs(x);
        const double sizeY = std::abs(y);
        const double sizeZ = std::abs(z);
        const double slack =
            kRounding * (sizeX * farthest_.x + sizeY * farthest_.y + sizeZ * farthest_.z + std::abs(moved));
        double* low = &reaches[2 * static_cast<std::size_t>(axis) * count];
        double* high = low + count;
        const double* cell = boxes_.data();
        std::size_t lowest = 0;
        std::size_t highest = 0;
        for (std::size_t i = 0; i < count; ++i, cell += 6) {
            const double place = x * cell[0] + y * cell[1] + z * cell[2] + moved;
            const double reach = sizeX * cell[3] + sizeY * cell[4] + sizeZ * cell[5] + slack;
            low[i] = place - reach;
            high[i] = place + reach;
            lowest = low[i] < low[lowest] ? i : lowest;
            highest = high[i] > high[highest] ? i : highest;
        }
        // The farthest cells first: then few of the others can reach farther
        add(lowest, objectToWorld, box);
        add(highest, objectToWorld, box);
    }
    std::vector<unsigned char> isOut(count, 0);
    for (int axis = 0; axis < 3; ++axis) {
        const double* low = &reaches[2 * static_cast<std::size_t>(axis) * count];
        const double least = box.low[axis];
        const double most = box.high[axis];
        for (std::size_t i = 0; i < count; ++i) {
            if (!(low[i] > least && low[count + i] < most)) { // true too of what is not finite
                isOut[i] = 1;
            }
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (isOut[i] != 0) {
            add(i, objectToWorld, box);
        }
    }
    return box;
}

} // namespace hyalite
