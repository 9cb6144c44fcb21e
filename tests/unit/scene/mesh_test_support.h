// Shared by the tests of mesh files: a pyramid, bytes of either order, and mistakes with their places.
#pragma once

#include "unit/scene/scene_test_support.h"

#include "scene/model/scene.h"

#include <algorithm>
#include <array>
#include <bit>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite::test {

using Triangle = std::array<glm::vec3, 3>;

inline std::vector<Triangle> trianglesOf(const Mesh& mesh) {
    std::vector<Triangle> triangles;
    for (const glm::uvec3& t : mesh.triangles) {
        triangles.push_back({mesh.positions.at(t.x), mesh.positions.at(t.y), mesh.positions.at(t.z)});
    }
    return triangles;
}

// A pyramid by hand: a square base in the plane y = 0, seen from below, and four sides up to the tip.
inline const std::vector<glm::vec3> kCorners{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0.5F, 2, 0.5F}};
inline const std::vector<std::vector<std::uint32_t>> kFaces{{0, 1, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
// The base is the fan (0 1 2), (0 2 3).
inline const std::vector<glm::uvec3> kTriangles{{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};

inline void checkPyramid(const Mesh& mesh) {
    CHECK(mesh.positions == kCorners);
    CHECK(mesh.normals.empty());
    CHECK(mesh.triangles == kTriangles);
}

// Appends a value's bytes in either order.
template <class T>
void put(std::string& bytes, T value, bool bigEndian) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (bigEndian == (std::endian::native == std::endian::little)) {
        std::reverse(raw.begin(), raw.end());
    }
    bytes.append(raw.data(), raw.size());
}

// The error of parsing marked text stands at the mark; without a mark it has no line.
inline void checkRejected(Mesh (*parse)(std::string_view, const std::string&), const std::string& marked,
                          const std::string& what) {
    INFO(marked);
    const MarkedText text(marked);
    const auto error = errorOf([&] { return parse(text.text, "mesh.file"); });
    REQUIRE(error.has_value());
    INFO(error->what());
    CHECK(error->code() == ExitCode::BadInput);
    CHECK(error->where().file == "mesh.file");
    CHECK(error->where().line == text.line);
    CHECK(error->where().column == text.column);
    CHECK_THAT(error->what(), Catch::Matchers::ContainsSubstring(what));
}

} // namespace hyalite::test
