// The shells of a mesh: the parts that hang together by edges, whether they are closed, and how they are wound.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <vector>

namespace hyalite {

struct MeshShell {
    std::vector<std::uint32_t> triangles; // ascending, without those that have two equal corners
    std::vector<std::uint32_t> turned;    // those of them wound against the first, ascending
    std::vector<std::uint32_t> open;      // those beside an open edge, ascending; empty: closed
    double volume = 0; // that it encloses [m^3], if the turned triangles are turned; negative: the first faces inward
    double area = 0;   // [m^2]

    // Closed, and not a sheet whose two sides lie on each other.
    [[nodiscard]] bool isSolid() const { return open.empty() && volume * volume > 1e-18 * area * area * area; }
};

// Positions that differ by no more than the roundings of a file with six digits are one corner, for exporters write a
// corner once for every face. If more than two triangles share an edge, or the surface has one side only, the mesh is
// one shell, none of its triangles counts as turned, and it is open unless along every edge as many run in one
// direction as in the other. O(n log n).
[[nodiscard]] std::vector<MeshShell> shellsOf(const Mesh& mesh);

// Reverses the order of the corners of these triangles.
void turn(Mesh& mesh, const std::vector<std::uint32_t>& triangles);

} // namespace hyalite
