// Binned surface-area-heuristic build [Wald07], the two halves of large nodes on different threads.
#include "geometry/bvh.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <array>
#include <future>
#include <numeric>

namespace hyalite {

namespace {

constexpr int kBins = 16;
constexpr float kNodeCost = 1.0F;                  // of a box test, in triangle tests
constexpr std::uint32_t kParallelCount = 1U << 15; // below this a thread costs more than it brings

struct Split {
    int axis = -1; // none: keep a leaf or cut the range in half
    int bin = 0;   // elements in bins below this go left
    float cost = std::numeric_limits<float>::infinity();
};

// Maps centroids of a node to bins along an axis; the same arithmetic for counting and for partitioning.
struct Binning {
    glm::vec3 lower;
    glm::vec3 scale;

    explicit Binning(const Aabb& centroids) : lower(centroids.lower), scale(0) {
        const glm::vec3 extent = centroids.extent();
        for (int axis = 0; axis < 3; ++axis) {
            const float scaled = static_cast<float>(kBins) / extent[axis];
            // An extent too small to divide by cannot separate anything
            scale[axis] = extent[axis] > 0 && scaled < std::numeric_limits<float>::max() ? scaled : 0;
        }
    }
    [[nodiscard]] int bin(const glm::vec3& centroid, int axis) const {
        return std::clamp(static_cast<int>((centroid[axis] - lower[axis]) * scale[axis]), 0, kBins - 1);
    }
};

class Builder {
public:
    Builder(std::span<const Aabb> boxes, std::uint32_t leafSize, SplitMethod method)
        : boxes_(boxes), leafSize_(leafSize), method_(method) {
        tree_.order.resize(boxes.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0U);
        tree_.nodes.resize(boxes.empty() ? 1 : 2 * boxes.size() - 1);
        centroids_.reserve(boxes.size());
        for (const Aabb& box : boxes) {
            centroids_.push_back(box.center());
        }
    }

    BinaryBvh build() {
        if (!boxes_.empty()) {
            buildNode(0, 0, static_cast<std::uint32_t>(boxes_.size()));
        }
        return std::move(tree_);
    }

private:
    void buildNode(std::uint32_t slot, std::uint32_t first, std::uint32_t count) {
        BinaryNode& node = tree_.nodes[slot];
        node.first = first;
        node.count = count;
        Aabb centroids;
        for (std::uint32_t i = first; i < first + count; ++i) {
            node.box.add(boxes_[tree_.order[i]]);
            centroids.add(centroids_[tree_.order[i]]);
        }
        if (count == 1) {
            return;
        }
        const Binning binning(centroids);
        const Split split = method_ == SplitMethod::SurfaceArea ? findSplit(node, binning) : Split{};
        const auto leafCost = static_cast<float>(count);
        if (count <= leafSize_ && !(kNodeCost + split.cost < leafCost)) {
            return;
        }
        const std::uint32_t leftCount = partition(node, split, binning, centroids);
        node.right = slot + 2 * leftCount;
        const auto buildRight = [=, this, right = node.right] {
            buildNode(right, first + leftCount, count - leftCount);
        };
        if (count >= kParallelCount) {
            auto other = std::async(std::launch::async, buildRight);
            buildNode(slot + 1, first, leftCount);
            other.get();
        } else {
            buildNode(slot + 1, first, leftCount);
            buildRight();
        }
    }

    // The split of least cost: sum over both sides of (area / node area) * elements.
    [[nodiscard]] Split findSplit(const BinaryNode& node, const Binning& binning) const {
        struct Bin {
            Aabb box;
            std::uint32_t count = 0;
        };
        std::array<std::array<Bin, kBins>, 3> bins;
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            const std::uint32_t element = tree_.order[i];
            for (int axis = 0; axis < 3; ++axis) {
                Bin& bin = bins[static_cast<std::size_t>(axis)]
                               [static_cast<std::size_t>(binning.bin(centroids_[element], axis))];
                bin.box.add(boxes_[element]);
                ++bin.count;
            }
        }
        Split best;
        const float nodeArea = std::max(node.box.halfArea(), std::numeric_limits<float>::min());
        for (int axis = 0; axis < 3; ++axis) {
            const auto& row = bins[static_cast<std::size_t>(axis)];
            std::array<float, kBins> rightCost{};
            Aabb box;
            std::uint32_t count = 0;
            for (std::size_t i = kBins - 1; i > 0; --i) {
                box.add(row[i].box);
                count += row[i].count;
                rightCost[i] = box.halfArea() * static_cast<float>(count);
            }
            box = {};
            count = 0;
            for (std::size_t i = 1; i < kBins; ++i) {
                box.add(row[i - 1].box);
                count += row[i - 1].count;
                if (count == 0 || count == node.count) {
                    continue;
                }
                const float cost = (box.halfArea() * static_cast<float>(count) + rightCost[i]) / nodeArea;
                if (cost < best.cost) {
                    best = {axis, static_cast<int>(i), cost};
                }
            }
        }
        return best;
    }

    // Reorders the node's range and returns how many elements go left, at least one and not all.
    std::uint32_t partition(const BinaryNode& node, const Split& split, const Binning& binning, const Aabb& centroids) {
        const auto begin = tree_.order.begin() + node.first;
        const auto end = begin + node.count;
        if (split.axis >= 0) {
            const auto middle = std::partition(begin, end, [&](std::uint32_t element) {
                return binning.bin(centroids_[element], split.axis) < split.bin;
            });
            return static_cast<std::uint32_t>(middle - begin);
        }
        // No plane separates the centroids, or medians are asked for: half the elements each, by the widest axis
        const glm::vec3 extent = centroids.extent();
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const auto middle = begin + node.count / 2;
        std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
            const float ca = centroids_[a][axis];
            const float cb = centroids_[b][axis];
            return ca < cb || (ca == cb && a < b);
        });
        return node.count / 2;
    }

    std::span<const Aabb> boxes_;
    std::uint32_t leafSize_;
    SplitMethod method_;
    std::vector<glm::vec3> centroids_;
    BinaryBvh tree_;
};

} // namespace

BinaryBvh buildBinaryBvh(std::span<const Aabb> boxes, std::uint32_t leafSize, SplitMethod method) {
    return Builder(boxes, leafSize, method).build();
}

Bvh buildBvh(std::span<const Aabb> boxes, std::uint32_t leafSize) {
    Bvh bvh = packBvh(buildBinaryBvh(boxes, leafSize, SplitMethod::SurfaceArea));
    if (bvh.stackEntries > shared::kTraversalStack) {
        bvh = packBvh(buildBinaryBvh(boxes, leafSize, SplitMethod::Median));
    }
    return bvh;
}

} // namespace hyalite
