// Faces that a mesh lists more than once, as some exporters write them. Light from such a face would count twice.
#pragma once

#include "scene/model/scene.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace hyalite {

// Two triangles, numbered as before anything was dropped.
struct FacePair {
    std::uint32_t first = 0;
    std::uint32_t second = 0; // > first
};

struct RepeatedFaces {
    std::size_t count = 0; // of the triangles dropped
    FacePair example;      // the first of them, with the triangle that it repeats
    int line = 0;          // of the dropped one in the file; 0: unknown
    int lineOfFirst = 0;
};

// Drops every triangle with the corners and the orientation of an earlier one, whatever the order in which it names
// them; nullopt: there is none. Equal positions are one corner. Triangles with two equal corners are kept.
std::optional<RepeatedFaces> dropRepeatedFaces(Mesh& mesh);

// The first two triangles with the same corners and opposite orientations.
[[nodiscard]] std::optional<FacePair> findBackToBack(const Mesh& mesh);

// For polygons of any number of corners (`ends` as in PolygonSoup), the number of corners by which each must be turned
// to begin where the first polygon with the same corners in the same cyclic order begins; 0: with its own first.
// `corners`: one number per corner, equal for equal positions.
[[nodiscard]] std::vector<std::uint32_t> turnsToRepeat(std::span<const std::uint32_t> corners,
                                                       std::span<const std::size_t> ends);

} // namespace hyalite
