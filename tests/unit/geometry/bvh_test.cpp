// The packed hierarchy as the device reads it: every element is in one leaf, and its box lies within all the quantised
// boxes on the path to it, for any triangles.
#include "geometry/bvh_collapse.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/scene_records.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <random>
#include <span>
#include <vector>

using namespace hyalite;
using glm::dvec3;
using glm::vec3;

namespace {

using Boxes = std::vector<Aabb>;
constexpr std::uint32_t kLeafSize = 4;

struct Box {
    dvec3 low{-std::numeric_limits<double>::infinity()};
    dvec3 high{std::numeric_limits<double>::infinity()};
};

double scaleOf(std::uint32_t frame, int axis) {
    return std::ldexp(1.0, static_cast<int>(frame >> (8 * axis) & 255U) - 127);
}

// A child's box, from the layout in scene_records.h: origin + byte * 2^(exponent - 127), exactly.
Box childBox(const Bvh& bvh, std::size_t node, int child) {
    const glm::uvec4* texels = &bvh.texels[node * shared::kTexelsPerRecord];
    const auto byte = [&](std::uint32_t word) { return static_cast<double>(word >> (8 * child) & 255U); };
    const std::array<std::uint32_t, 3> low{texels[1].x, texels[1].y, texels[1].z};
    const std::array<std::uint32_t, 3> high{texels[1].w, texels[2].x, texels[2].y};
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto origin = static_cast<double>(std::bit_cast<float>(texels[0][axis]));
        const double scale = scaleOf(texels[0].w, axis);
        box.low[axis] = origin + byte(low[i]) * scale;
        box.high[axis] = origin + byte(high[i]) * scale;
    }
    return box;
}

glm::uvec4 wordsOf(const Bvh& bvh, std::size_t node) {
    return childWords(std::span(bvh.texels).subspan(node * shared::kTexelsPerRecord, shared::kTexelsPerRecord));
}

class Walk {
public:
    Walk(const Bvh& bvh, const Boxes& boxes) : bvh_(bvh), boxes_(boxes), visits_(boxes.size(), 0) {}

    void check() {
        descend(0, Box{}, 1);
        CHECK(nodesSeen_ * shared::kTexelsPerRecord == bvh_.texels.size());
        CHECK(std::all_of(visits_.begin(), visits_.end(), [](int visits) { return visits == 1; }));
        CHECK(outside_ == 0);
        CHECK(largestLeaf_ <= kLeafSize);
        CHECK(deepestStack_ <= bvh_.stackEntries);
        CHECK(bvh_.stackEntries <= shared::kTraversalStack);
    }

private:
    // `around`: intersection of all boxes on the path to this node; `stack`: entries in use when this node is popped.
    void descend(std::size_t node, const Box& around, std::uint32_t stack) {
        ++nodesSeen_;
        const glm::uvec4 words = wordsOf(bvh_, node);
        std::uint32_t children = 0;
        for (int i = 0; i < 4; ++i) {
            children += words[i] != shared::kNone ? 1U : 0U;
        }
        // In the worst order the child that is descended into is popped while all its siblings wait.
        const std::uint32_t withChildren = stack - 1 + children;
        deepestStack_ = std::max({deepestStack_, stack, withChildren});
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t word = words[i];
            if (word == shared::kNone) {
                continue;
            }
            const Box own = childBox(bvh_, node, i);
            const Box box{glm::max(around.low, own.low), glm::min(around.high, own.high)};
            if ((word & shared::kLeafBit) == 0) {
                descend(word, box, withChildren);
            } else {
                checkLeaf(word, box);
            }
        }
    }

    void checkLeaf(std::uint32_t word, const Box& box) {
        const std::uint32_t first = word & shared::kLeafFirstMask;
        const std::uint32_t count = (word & ~shared::kLeafBit) >> shared::kLeafCountShift;
        largestLeaf_ = std::max(largestLeaf_, count);
        for (std::uint32_t i = first; i < first + count; ++i) {
            const std::uint32_t element = bvh_.order.at(i);
            ++visits_.at(element);
            const dvec3 low = boxes_[element].lower;
            const dvec3 high = boxes_[element].upper;
            outside_ +=
                glm::all(glm::lessThanEqual(box.low, low)) && glm::all(glm::lessThanEqual(high, box.high)) ? 0 : 1;
        }
    }

    const Bvh& bvh_;
    const Boxes& boxes_;
    std::vector<int> visits_;
    std::size_t nodesSeen_ = 0;
    int outside_ = 0;
    std::uint32_t largestLeaf_ = 0;
    std::uint32_t deepestStack_ = 0;
};

void checkHierarchy(const Boxes& boxes) {
    const Bvh bvh = buildBvh(boxes, kLeafSize);
    REQUIRE(bvh.order.size() == boxes.size());
    Walk(bvh, boxes).check();
}

Aabb boxAround(std::initializer_list<vec3> points) {
    Aabb box;
    for (const vec3& point : points) {
        box.add(point);
    }
    return box;
}

// Triangles of this size at random places within the cube of this half side around the centre.
Boxes randomTriangles(int count, float halfSide, float size, const vec3& center = vec3(0)) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto vector = [&] { return vec3(unit(engine), unit(engine), unit(engine)); };
    Boxes boxes;
    for (int i = 0; i < count; ++i) {
        const vec3 place = center + halfSide * vector();
        boxes.push_back(boxAround({place, place + size * vector(), place + size * vector()}));
    }
    return boxes;
}

double areaOf(const BinaryBvh& binary, std::uint32_t slot) {
    return double{binary.nodes[slot].box.halfArea()};
}

// Every way to cut the tree below a node into up to `most` subtrees.
std::vector<std::vector<std::uint32_t>> cutsOf(const BinaryBvh& binary, std::uint32_t slot, std::size_t most) {
    std::vector<std::vector<std::uint32_t>> cuts{{slot}};
    if (binary.nodes[slot].right == 0) {
        return cuts;
    }
    for (const auto& left : cutsOf(binary, slot + 1, most)) {
        for (const auto& right : cutsOf(binary, binary.nodes[slot].right, most)) {
            if (left.size() + right.size() <= most) {
                cuts.push_back(left);
                cuts.back().insert(cuts.back().end(), right.begin(), right.end());
            }
        }
    }
    return cuts;
}

// Minimal cost of the tree below a node, as a leaf or as a node with up to four children.
double leastCost(const BinaryBvh& binary, std::uint32_t slot, std::uint32_t leafSize) {
    const BinaryNode& node = binary.nodes[slot];
    double least = node.count <= leafSize ? areaOf(binary, slot) * node.count : std::numeric_limits<double>::infinity();
    if (node.right == 0) {
        return least;
    }
    for (const auto& cut : cutsOf(binary, slot, 4)) {
        double cost = areaOf(binary, slot);
        for (const std::uint32_t child : cut) {
            cost += child == slot ? std::numeric_limits<double>::infinity() : leastCost(binary, child, leafSize);
        }
        least = std::min(least, cost);
    }
    return least;
}

// Cost of the chosen tree.
double costOf(const BinaryBvh& binary, const BvhCollapse& collapse, std::uint32_t slot) {
    if (collapse.isLeaf(slot)) {
        return areaOf(binary, slot) * binary.nodes[slot].count;
    }
    double cost = areaOf(binary, slot);
    for (const std::uint32_t child : collapse.children(slot)) {
        cost += costOf(binary, collapse, child);
    }
    return cost;
}

} // namespace

TEST_CASE("hierarchies can be built over no triangle, one triangle and few triangles") {
    const Bvh none = buildBvh({}, kLeafSize);
    REQUIRE(none.texels.size() == shared::kTexelsPerRecord);
    CHECK(wordsOf(none, 0) == glm::uvec4(shared::kNone));
    for (const int count : {1, 2, 4, 5, 17}) {
        checkHierarchy(randomTriangles(count, 1, 0.3F));
    }
}

TEST_CASE("every triangle of a large random mesh is reached") {
    checkHierarchy(randomTriangles(100000, 10, 0.1F)); // large enough for several threads
}

TEST_CASE("hierarchies of huge, tiny and far-away triangles reach them all") {
    checkHierarchy(randomTriangles(2000, 1e9F, 1e8F));
    checkHierarchy(randomTriangles(2000, 1e9F, 1e-9F));
    checkHierarchy(randomTriangles(2000, 1e-9F, 1e-10F));
    checkHierarchy(randomTriangles(2000, 1e-20F, 1e-20F));                   // areas underflow to 0
    checkHierarchy(randomTriangles(2000, 1e-38F, 1e-40F));                   // denormal
    checkHierarchy(randomTriangles(2000, 1, 0.1F, vec3(1e8F, -1e8F, 1e8F))); // steps of the coordinates are 8
}

TEST_CASE("triangles of all scales in one mesh are all reached, although spatial splits run deep") {
    Boxes boxes;
    for (int i = -120; i < 30; ++i) {
        const float size = std::ldexp(1.0F, i);
        for (int k = 0; k < 20; ++k) {
            const vec3 place = size * vec3(1, 0.1F * static_cast<float>(k), 0.5F);
            boxes.push_back(boxAround({place, place + vec3(0.05F * size, 0, 0), place + vec3(0, 0, 0.05F * size)}));
        }
    }
    checkHierarchy(boxes);
}

TEST_CASE("the cheapest collapse of a binary tree into wide nodes is chosen") {
    // Few enough boxes to try all collapses
    for (const int count : {2, 3, 5, 8, 11}) {
        const Boxes boxes = randomTriangles(count, 1, 0.3F);
        const BinaryBvh binary = buildBinaryBvh(boxes, SplitMethod::SurfaceArea);
        for (const std::uint32_t leafSize : {1U, 2U, 4U}) {
            const double least = leastCost(binary, 0, leafSize);
            const double taken = costOf(binary, BvhCollapse(binary, leafSize), 0);
            CHECK(std::abs(taken - least) < 1e-5 * least);
        }
    }
}

TEST_CASE("degenerate triangles are reached like others") {
    Boxes points = randomTriangles(1000, 1, 0);
    checkHierarchy(points); // points
    Boxes segments;
    for (const Aabb& box : points) {
        segments.push_back(boxAround({box.lower, box.lower + vec3(0.5F, 0, 0)}));
    }
    checkHierarchy(segments);
    Boxes flat = randomTriangles(1000, 1, 0.2F);
    for (Aabb& box : flat) {
        box.lower.y = box.upper.y = 0;
    }
    checkHierarchy(flat);
    points.insert(points.end(), segments.begin(), segments.end());
    points.insert(points.end(), flat.begin(), flat.end());
    checkHierarchy(points);
}

TEST_CASE("triangles that share a centroid, or are identical, are split by count") {
    Boxes nested;
    for (int i = 1; i <= 5000; ++i) {
        const vec3 half = vec3(1, 2, 3) * static_cast<float>(i);
        nested.push_back(boxAround({-half, half}));
    }
    checkHierarchy(nested);
    checkHierarchy(Boxes(5000, boxAround({{1, 2, 3}, {4, 5, 6}})));
    checkHierarchy(Boxes(5000, boxAround({{0, 0, 0}})));
    checkHierarchy(Boxes(100000, boxAround({{1e9F, 1e9F, -1e9F}})));
    // Centroids a single rounding apart
    Boxes close;
    float x = 1;
    for (int i = 0; i < 64; ++i) {
        close.push_back(boxAround({{x, 0, 0}}));
        x = std::nextafter(x, 2.0F);
    }
    checkHierarchy(close);
}

TEST_CASE("one triangle as large as the mesh does not hide the small ones") {
    Boxes boxes = randomTriangles(3000, 1, 0.01F);
    for (int i = 0; i < 10; ++i) {
        boxes.push_back(boxAround({{-1e6F, -1e6F, 0}, {1e6F, 1e6F, 1}}));
    }
    checkHierarchy(boxes);
}

TEST_CASE("the same boxes always give the same hierarchy") {
    const Boxes boxes = randomTriangles(100000, 10, 0.1F);
    const Bvh once = buildBvh(boxes, kLeafSize);
    const Bvh again = buildBvh(boxes, kLeafSize);
    CHECK(once.order == again.order);
    CHECK(once.texels == again.texels);
}

TEST_CASE("a relocated hierarchy leads to the same elements at their new positions") {
    const Boxes boxes = randomTriangles(500, 1, 0.1F);
    Bvh moved = buildBvh(boxes, kLeafSize);
    const Bvh still = moved;
    relocate(moved, 1000, 20000);
    for (std::size_t node = 0; node < still.texels.size() / shared::kTexelsPerRecord; ++node) {
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t word = wordsOf(still, node)[i];
            const std::uint32_t shift = (word & shared::kLeafBit) != 0 ? 20000U : 1000U;
            CHECK(wordsOf(moved, node)[i] == (word == shared::kNone ? word : word + shift));
        }
    }
}
