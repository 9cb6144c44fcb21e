// STL, binary and text: triangles with corners of their own, which are welded here. The normals that a file stores
// for each triangle are skipped: the order of its corners implies them.
#include "base/little_endian.h"
#include "base/numbers.h"
#include "base/spelling.h"
#include "scene/import/mesh_import.h"
#include "scene/import/polygon_soup.h"
#include "scene/model/mesh_weld.h"

#include <algorithm>
#include <bit>

namespace hyalite {
namespace {

// Binary: 80 bytes of any content, the number of triangles, then for each a normal, three corners and two bytes more.
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kTrianglesAt = 84;
constexpr std::size_t kTriangleBytes = 50;
constexpr std::size_t kCornersAt = 12; // in a triangle
constexpr std::size_t kFloatBytes = 4;

// Binary files may begin with "solid" as text does. A text of the size that its bytes 80 to 83 would ask of a binary
// file has more than 8 GB, for its bytes are 9 and above; and a text holds no zero byte.
bool isBinary(std::string_view bytes) {
    if (bytes.size() >= kTrianglesAt &&
        bytes.size() - kTrianglesAt == std::size_t{littleEndian(bytes.substr(kCountAt, 4))} * kTriangleBytes) {
        return true;
    }
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
    return begin == std::string_view::npos || lowerCase(bytes.substr(begin, 5)) != "solid" ||
           bytes.find('\0') != std::string_view::npos;
}

struct StlTriangles {
    std::vector<glm::dvec3> corners;  // three a triangle [m]
    std::vector<std::uint32_t> lines; // of the triangles; empty: the file is binary
};

StlTriangles parseBinary(std::string_view bytes, const std::string& file) {
    const auto fail = [&](const std::string& what, const std::string& hint) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0}, what, hint);
    };
    if (bytes.size() < kTrianglesAt) {
        fail("not an STL file: neither text that begins with 'solid' nor the 84 bytes that begin a binary file",
             "is it truncated?");
    }
    const std::size_t count = littleEndian(bytes.substr(kCountAt, 4));
    const std::size_t room = bytes.size() - kTrianglesAt;
    if (room != count * kTriangleBytes) {
        fail("the number at byte 80 declares " + std::to_string(count) + " triangles of 50 bytes, " +
                 std::to_string(room) + " bytes follow",
             room < count * kTriangleBytes ? "is it truncated?" : "is it an STL file?");
    }
    checkTriangleCount(count, file);

    std::vector<glm::dvec3> corners;
    corners.reserve(3 * count);
    for (std::size_t triangle = 0; triangle < count; ++triangle) {
        std::size_t at = kTrianglesAt + triangle * kTriangleBytes + kCornersAt;
        for (int corner = 0; corner < 3; ++corner) {
            glm::vec3 position;
            for (int axis = 0; axis < 3; ++axis, at += kFloatBytes) {
                position[axis] = std::bit_cast<float>(littleEndian(bytes.substr(at, 4)));
                if (!isMeshCoordinate(static_cast<double>(position[axis]))) {
                    failCoordinate(static_cast<double>(position[axis]), {file, 0, 0},
                                   "triangle " + std::to_string(triangle + 1) + ", byte " + std::to_string(at) + ": ");
                }
            }
            corners.emplace_back(position);
        }
    }
    return {std::move(corners), {}};
}

class TextParser {
public:
    TextParser(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

    StlTriangles parse() {
        for (std::string word = keyword(); !word.empty(); word = keyword()) { // some programs write several solids
            expect("solid", word);
            skipLine(); // its name
            for (word = keyword(); word == "facet"; word = keyword()) {
                readFacet();
            }
            expect("endsolid", word);
            skipLine();
        }
        checkTriangleCount(read_.corners.size() / 3, file_);
        return std::move(read_);
    }

private:
    static constexpr std::string_view kBlanks = " \t\r\v\f";

    void readFacet() {
        read_.lines.push_back(static_cast<std::uint32_t>(line_));
        expect("normal", keyword());
        for (int axis = 0; axis < 3; ++axis) {
            static_cast<void>(number());
        }
        expect("outer", keyword());
        expect("loop", keyword());
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex", keyword());
            glm::dvec3 position;
            for (int axis = 0; axis < 3; ++axis) {
                const double value = number();
                if (!isMeshCoordinate(value)) {
                    failCoordinate(value, where(), {});
                }
                position[axis] = value;
            }
            read_.corners.push_back(position);
        }
        expect("endloop", keyword());
        expect("endfacet", keyword());
    }

    double number() {
        const std::string_view word = next();
        const auto value = parseNumber(word);
        if (!value) {
            fail("expected a number, found " + found(word));
        }
        return *value;
    }

    // The next word, in lower case; empty at the end.
    std::string keyword() { return lowerCase(next()); }

    void expect(std::string_view wanted, const std::string& word) const {
        if (word != wanted) {
            fail("expected " + inQuotes(wanted) + ", found " + found(word));
        }
    }

    [[nodiscard]] static std::string found(std::string_view word) {
        return word.empty() ? "the end of the file" : inQuotes(word);
    }

    [[nodiscard]] SourceLocation where() const { return {file_, line_, static_cast<int>(word_ - lineBegin_) + 1}; }
    [[noreturn]] void fail(const std::string& what) const { throw Error(ExitCode::BadInput, where(), what); }

    std::string_view next() {
        while (at_ < bytes_.size() && (bytes_[at_] == '\n' || kBlanks.find(bytes_[at_]) != std::string_view::npos)) {
            if (bytes_[at_++] == '\n') {
                ++line_;
                lineBegin_ = at_;
            }
        }
        word_ = at_;
        while (at_ < bytes_.size() && bytes_[at_] != '\n' && kBlanks.find(bytes_[at_]) == std::string_view::npos) {
            ++at_;
        }
        return bytes_.substr(word_, at_ - word_);
    }

    void skipLine() { at_ = std::min(bytes_.find('\n', at_), bytes_.size()); }

    std::string_view bytes_;
    std::string file_;
    StlTriangles read_;
    std::size_t at_ = 0;
    std::size_t word_ = 0; // where the last word begins
    std::size_t lineBegin_ = 0;
    int line_ = 1;
};

} // namespace

Mesh parseStl(std::string_view bytes, const std::string& file) {
    Mesh mesh;
    mesh.file = file;
    StlTriangles read = isBinary(bytes) ? parseBinary(bytes, file) : TextParser(bytes, file).parse();
    setPositions(mesh, read.corners);
    mesh.lines = std::move(read.lines);
    const auto corners = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.triangles.reserve(corners / 3);
    for (std::uint32_t corner = 0; corner < corners; corner += 3) {
        mesh.triangles.emplace_back(corner, corner + 1, corner + 2);
    }
    weldVertices(mesh);
    return mesh;
}

} // namespace hyalite
