// See teapot_patches.h.
#include "scene/import/teapot_patches.h"

namespace hyalite {
namespace {

// A row of a quarter patch: (radius, 0), (radius, -side), (side, -radius), (0, -radius) at this height. Newell's
// circles have side = 0.56 radius where 0.5523 is the best, and the knob's are rounded further.
struct Ring {
    double radius;
    double side;
    double height;
};
struct QuarterPatch {
    TeapotPart part;
    std::array<Ring, 4> rings; // downward and outward; on the bottom inward
};
constexpr std::array<QuarterPatch, 6> kQuarters{{
    {TeapotPart::Body, {{{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125}, {1.5, 0.84, 2.4}}}},
    {TeapotPart::Body, {{{1.5, 0.84, 2.4}, {1.75, 0.98, 1.875}, {2, 1.12, 1.35}, {2, 1.12, 0.9}}}},
    {TeapotPart::Body, {{{2, 1.12, 0.9}, {2, 1.12, 0.45}, {1.5, 0.84, 0.225}, {1.5, 0.84, 0.15}}}},
    {TeapotPart::Body, {{{1.5, 0.84, 0.15}, {1.5, 0.84, 0.075}, {1.425, 0.798, 0}, {0, 0, 0}}}},
    {TeapotPart::Lid, {{{0, 0, 3.15}, {0.8, 0.45, 3.15}, {0, 0, 2.85}, {0.2, 0.112, 2.7}}}},
    {TeapotPart::Lid, {{{0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55}, {1.3, 0.728, 2.4}}}},
}};

// A row of a half patch: (x0, 0, z0), (x0, -side, z0), (x1, -side, z1), (x1, 0, z1).
struct Arch {
    double x0;
    double z0;
    double x1;
    double z1;
    double side;
};
struct HalfPatch {
    TeapotPart part;
    std::array<Arch, 4> arches; // from where it leaves the body, or the patch before
};
constexpr std::array<HalfPatch, 4> kHalves{{
    {TeapotPart::Handle,
     {{{-1.6, 2.025, -1.5, 2.25, 0.3},
       {-2.3, 2.025, -2.5, 2.25, 0.3},
       {-2.7, 2.025, -3, 2.25, 0.3},
       {-2.7, 1.8, -3, 1.8, 0.3}}}},
    {TeapotPart::Handle,
     {{{-2.7, 1.8, -3, 1.8, 0.3},
       {-2.7, 1.575, -3, 1.35, 0.3},
       {-2.5, 1.125, -2.65, 0.9375, 0.3},
       {-2, 0.9, -1.9, 0.6, 0.3}}}},
    {TeapotPart::Spout,
     {{{1.7, 1.425, 1.7, 0.6, 0.66},
       {2.6, 1.425, 3.1, 0.825, 0.66},
       {2.3, 2.1, 2.4, 2.025, 0.25},
       {2.7, 2.4, 3.3, 2.4, 0.25}}}},
    {TeapotPart::Spout,
     {{{2.7, 2.4, 3.3, 2.4, 0.25},
       {2.8, 2.475, 3.525, 2.49375, 0.25},
       {2.9, 2.475, 3.45, 2.5125, 0.15},
       {2.8, 2.4, 3.2, 2.4, 0.15}}}},
}};

// A quarter turn about the axis, the way the rows run; exact.
glm::dvec3 turned(const glm::dvec3& p) {
    return {p.y, -p.x, p.z};
}

void addQuarters(const QuarterPatch& quarter, std::vector<BicubicPatch>& patches) {
    BicubicPatch patch;
    patch.part = quarter.part;
    for (std::size_t row = 0; row < 4; ++row) {
        const Ring& ring = quarter.rings[row];
        patch.points[row] = {{{ring.radius, 0, ring.height},
                              {ring.radius, -ring.side, ring.height},
                              {ring.side, -ring.radius, ring.height},
                              {0, -ring.radius, ring.height}}};
    }
    for (int turn = 0; turn < 4; ++turn) {
        patches.push_back(patch);
        for (auto& row : patch.points) {
            for (glm::dvec3& point : row) {
                point = turned(point);
            }
        }
    }
}

void addHalves(const HalfPatch& half, std::vector<BicubicPatch>& patches) {
    BicubicPatch patch;
    BicubicPatch mirrored;
    patch.part = mirrored.part = half.part;
    for (std::size_t row = 0; row < 4; ++row) {
        const Arch& arch = half.arches[row];
        patch.points[row] = {{{arch.x0, 0, arch.z0},
                              {arch.x0, -arch.side, arch.z0},
                              {arch.x1, -arch.side, arch.z1},
                              {arch.x1, 0, arch.z1}}};
        for (std::size_t column = 0; column < 4; ++column) { // backwards, so that the outside stays outside
            const glm::dvec3& point = patch.points[row][3 - column];
            mirrored.points[row][column] = {point.x, -point.y, point.z};
        }
    }
    patches.push_back(patch);
    patches.push_back(mirrored);
}

} // namespace

std::vector<BicubicPatch> teapotPatches() {
    std::vector<BicubicPatch> patches;
    for (const QuarterPatch& quarter : kQuarters) {
        addQuarters(quarter, patches);
    }
    for (const HalfPatch& half : kHalves) {
        addHalves(half, patches);
    }
    return patches;
}

} // namespace hyalite
