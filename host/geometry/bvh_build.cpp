// Binned surface-area-heuristic build [Wald07]: large nodes are binned on all cores, then subtrees are built side by
// side.
#include "geometry/bvh.h"

#include "base/parallel.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <future>
#include <mutex>
#include <thread>

namespace hyalite {

namespace {

constexpr int kBins = 16;
constexpr std::uint32_t kParallelSubtree = 1U << 13U;  // below this a thread costs more than it saves
constexpr std::uint32_t kParallelElements = 1U << 18U; // nodes as large as this are binned on all cores
constexpr std::size_t kGrain = std::size_t{1} << 16U;

// An element as the build moves it: reading these in order is twice as fast as looking boxes up by index.
struct Element {
    Aabb box;
    std::uint32_t index;
};

struct Split {
    int axis = -1; // none: cut the range in half
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

// The elements of a node by bin along each axis.
struct Bins {
    struct Bin {
        Aabb box;
        std::uint32_t count = 0;
    };
    std::array<std::array<Bin, kBins>, 3> bins;

    void add(const Element& element, const Binning& binning) {
        const glm::vec3 centroid = element.box.center();
        for (int axis = 0; axis < 3; ++axis) {
            Bin& bin = bins[static_cast<std::size_t>(axis)][static_cast<std::size_t>(binning.bin(centroid, axis))];
            bin.box.add(element.box);
            ++bin.count;
        }
    }
    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < kBins; ++i) {
                bins[axis][i].box.add(other.bins[axis][i].box);
                bins[axis][i].count += other.bins[axis][i].count;
            }
        }
    }

    // The split of least cost: sum over both sides of (area / node area) * elements.
    [[nodiscard]] Split leastCost(const BinaryNode& node) const {
        Split best;
        const float nodeArea = std::max(node.box.halfArea(), std::numeric_limits<float>::min());
        for (int axis = 0; axis < 3; ++axis) {
            const auto& row = bins[static_cast<std::size_t>(axis)];
            std::array<float, kBins> rightCost{};
            Aabb box;
            std::uint32_t count = 0;
            float cost = 0;
            for (std::size_t i = kBins - 1; i > 0; --i) {
                if (row[i].count > 0) { // most bins of a small node are empty
                    box.add(row[i].box);
                    count += row[i].count;
                    cost = box.halfArea() * static_cast<float>(count);
                }
                rightCost[i] = cost;
            }
            box = {};
            count = 0;
            for (std::size_t i = 1; i < kBins; ++i) {
                if (row[i - 1].count == 0) { // the same split as before this bin
                    continue;
                }
                box.add(row[i - 1].box);
                count += row[i - 1].count;
                if (count == node.count) {
                    break;
                }
                cost = (box.halfArea() * static_cast<float>(count) + rightCost[i]) / nodeArea;
                if (cost < best.cost) {
                    best = {axis, static_cast<int>(i), cost};
                }
            }
        }
        return best;
    }
};

// Boxes around elements and around their centroids.
struct Extents {
    Aabb box;
    Aabb centroids;

    void add(const Element& element) {
        box.add(element.box);
        centroids.add(element.box.center());
    }
    void add(const Extents& other) {
        box.add(other.box);
        centroids.add(other.centroids);
    }
};

class Builder {
public:
    Builder(std::span<const Aabb> boxes, SplitMethod method)
        : method_(method), idleCores_(static_cast<int>(std::thread::hardware_concurrency()) - 1) {
        tree_.nodes.resize(boxes.empty() ? 1 : 2 * boxes.size() - 1);
        elements_.reserve(boxes.size());
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            elements_.push_back({boxes[i], i});
        }
    }

    BinaryBvh build() {
        if (!elements_.empty()) {
            buildNode(0, 0, static_cast<std::uint32_t>(elements_.size()));
        }
        tree_.order.reserve(elements_.size());
        for (const Element& element : elements_) {
            tree_.order.push_back(element.index);
        }
        return std::move(tree_);
    }

private:
    void buildNode(std::uint32_t slot, std::uint32_t first, std::uint32_t count) {
        const std::span<Element> range = std::span(elements_).subspan(first, count);
        const auto extents = sum<Extents>(range, [](Extents& sum, const Element& element) { sum.add(element); });
        BinaryNode& node = tree_.nodes[slot];
        node.first = first;
        node.count = count;
        node.box = extents.box;
        if (count == 1) {
            return;
        }
        const Binning binning(extents.centroids);
        Split split;
        if (method_ == SplitMethod::SurfaceArea) {
            split =
                sum<Bins>(range, [&](Bins& sum, const Element& element) { sum.add(element, binning); }).leastCost(node);
        }
        const std::uint32_t leftCount = partition(range, split, binning, extents.centroids);
        node.right = slot + 2 * leftCount;
        const auto buildRight = [=, this, right = node.right] {
            buildNode(right, first + leftCount, count - leftCount);
        };
        if (count >= kParallelSubtree && takeCore()) {
            auto other = std::async(std::launch::async, [&] {
                buildRight();
                ++idleCores_;
            });
            buildNode(slot + 1, first, leftCount);
            other.get();
        } else {
            buildNode(slot + 1, first, leftCount);
            buildRight();
        }
    }

    // The sum over all threads; sums of boxes and counts do not depend on the order.
    template <class Sum, class Add>
    [[nodiscard]] static Sum sum(std::span<const Element> range, const Add& add) {
        Sum total;
        if (range.size() < kParallelElements) {
            for (const Element& element : range) {
                add(total, element);
            }
            return total;
        }
        std::mutex mutex;
        parallelFor(range.size(), kGrain, [&](std::size_t begin, std::size_t end) {
            Sum part;
            for (const Element& element : range.subspan(begin, end - begin)) {
                add(part, element);
            }
            const std::lock_guard lock(mutex);
            total.add(part);
        });
        return total;
    }

    bool takeCore() {
        int idle = idleCores_;
        while (idle > 0) {
            if (idleCores_.compare_exchange_weak(idle, idle - 1)) {
                return true;
            }
        }
        return false;
    }

    // Reorders the node's range and returns how many elements go left, at least one and not all.
    [[nodiscard]] static std::uint32_t partition(std::span<Element> range, const Split& split, const Binning& binning,
                                                 const Aabb& centroids) {
        if (split.axis >= 0) {
            const auto middle = std::partition(range.begin(), range.end(), [&](const Element& element) {
                return binning.bin(element.box.center(), split.axis) < split.bin;
            });
            return static_cast<std::uint32_t>(middle - range.begin());
        }
        // No plane separates the centroids, or medians are asked for: half the elements each, by the widest axis
        const glm::vec3 extent = centroids.extent();
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : (extent.y >= extent.z ? 1 : 2);
        const auto half = static_cast<std::uint32_t>(range.size() / 2);
        std::nth_element(range.begin(), range.begin() + half, range.end(), [&](const Element& a, const Element& b) {
            const float ca = a.box.center()[axis];
            const float cb = b.box.center()[axis];
            return ca < cb || (ca == cb && a.index < b.index);
        });
        return half;
    }

    SplitMethod method_;
    std::atomic<int> idleCores_;
    std::vector<Element> elements_;
    BinaryBvh tree_;
};

} // namespace

BinaryBvh buildBinaryBvh(std::span<const Aabb> boxes, SplitMethod method) {
    return Builder(boxes, method).build();
}

Bvh buildBvh(std::span<const Aabb> boxes, std::uint32_t leafSize) {
    Bvh bvh = packBvh(buildBinaryBvh(boxes, SplitMethod::SurfaceArea), leafSize);
    if (bvh.stackEntries > shared::kTraversalStack) {
        bvh = packBvh(buildBinaryBvh(boxes, SplitMethod::Median), leafSize);
    }
    return bvh;
}

} // namespace hyalite
