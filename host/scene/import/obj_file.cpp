// Wavefront OBJ: v, vn, vt and f. Names, groups, materials, lines and points are skipped:
// they describe no surface that a scene file places; free-form surfaces and unknown statements are errors.
#include "base/numbers.h"
#include "base/spelling.h"
#include "scene/import/mesh_import.h"
#include "scene/import/polygon_soup.h"

#include <algorithm>
#include <array>
#include <optional>

namespace hyalite {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

// Statements without effect on the surface.
constexpr std::array<std::string_view, 14> kSkipped{"o", "g",     "s",        "mg",       "usemtl", "mtllib", "l",
                                                    "p", "bevel", "c_interp", "d_interp", "lod",    "usemap", "maplib"};

struct Word {
    std::string_view text;
    int column = 0;
};

class ObjParser {
public:
    ObjParser(std::string_view bytes, std::string file) : rest_(bytes), file_(std::move(file)) {}

    Mesh parse() {
        while (nextStatement()) {
            const std::string_view keyword = words_[0].text;
            if (keyword == "v") {
                // x y z, or with a weight (4), a colour (6), both (7).
                checkCount({3, 4, 6, 7});
                soup_.positions.push_back(coordinates());
            } else if (keyword == "vn") {
                checkCount({3});
                soup_.normals.emplace_back(coordinates());
            } else if (keyword == "vt") {
                checkCount({1, 2, 3});
                soup_.uvs.push_back(textureCoordinates());
            } else if (keyword == "f") {
                addFace();
            } else if (std::find(kSkipped.begin(), kSkipped.end(), keyword) == kSkipped.end()) {
                fail(words_[0], "unknown or unsupported statement " + inQuotes(keyword),
                     "read are v, vn, vt and f; export the mesh as polygons");
            }
        }
        return buildMesh(std::move(soup_), file_);
    }

private:
    [[nodiscard]] SourceLocation at(const Word& word) const { return {file_, line_, word.column}; }
    [[noreturn]] void fail(const Word& word, const std::string& what, const std::string& hint = {}) const {
        throw Error(ExitCode::BadInput, at(word), what, hint);
    }

    // Splits the next line that holds anything into words_; false at the end. A backslash at the end of a line
    // continues it in the next.
    bool nextStatement() {
        words_.clear();
        bool continues = false;
        while (!rest_.empty() && (words_.empty() || continues)) {
            const std::size_t end = std::min(rest_.find('\n'), rest_.size());
            std::string_view line = rest_.substr(0, end);
            rest_.remove_prefix(std::min(end + 1, rest_.size()));
            line_ = ++linesRead_;
            line = line.substr(0, line.find('#'));
            const std::size_t last = line.find_last_not_of(kBlanks);
            continues = last != std::string_view::npos && line[last] == '\\';
            splitWords(continues ? line.substr(0, last) : line);
        }
        return !words_.empty();
    }

    void splitWords(std::string_view line) {
        std::size_t begin = line.find_first_not_of(kBlanks);
        while (begin != std::string_view::npos) {
            const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
            words_.push_back({line.substr(begin, end - begin), static_cast<int>(begin) + 1});
            begin = line.find_first_not_of(kBlanks, end);
        }
    }

    // How many words may follow the keyword.
    void checkCount(std::initializer_list<std::size_t> allowed) const {
        const std::size_t count = words_.size() - 1;
        if (std::find(allowed.begin(), allowed.end(), count) == allowed.end()) {
            fail(words_[0], inQuotes(words_[0].text) + " is followed by " + std::to_string(count) + " numbers");
        }
    }

    [[nodiscard]] glm::dvec3 coordinates() const {
        glm::dvec3 value;
        for (int axis = 0; axis < 3; ++axis) {
            const Word& word = words_[static_cast<std::size_t>(axis) + 1];
            const auto number = parseNumber(word.text);
            if (!number) {
                fail(word, "expected a number, found " + inQuotes(word.text));
            }
            if (!isMeshCoordinate(*number)) {
                failCoordinate(*number, at(word), {});
            }
            value[axis] = *number;
        }
        return value;
    }

    // u, then v (0 where there is none), then what only volumes use.
    [[nodiscard]] glm::vec2 textureCoordinates() const {
        glm::vec2 uv(0);
        for (int axis = 0; axis < 2 && static_cast<std::size_t>(axis) + 1 < words_.size(); ++axis) {
            const Word& word = words_[static_cast<std::size_t>(axis) + 1];
            const auto number = parseNumber(word.text);
            if (!number || !isMeshCoordinate(*number)) {
                fail(word, "expected a texture coordinate, found " + inQuotes(word.text));
            }
            uv[axis] = static_cast<float>(*number);
        }
        return uv;
    }

    // An index of the file, from 1 or backwards from -1, as one from 0.
    [[nodiscard]] std::uint32_t index(const Word& word, std::string_view text, std::size_t count,
                                      const std::string& kind) const {
        const auto number = parseWhole(text);
        if (!number) {
            fail(word, "expected the index of a " + kind + ", found " + inQuotes(text));
        }
        const auto size = static_cast<std::int64_t>(count);
        if (*number == 0 || *number > size || *number < -size) {
            fail(word, "the index " + std::to_string(*number) + " of a " + kind + " is out of range",
                 std::to_string(count) + " precede this face; they count from 1, or backwards from -1");
        }
        return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : size + *number);
    }

    // v, v/t, v//n or v/t/n.
    [[nodiscard]] Corner corner(const Word& word) const {
        const std::size_t first = word.text.find('/');
        Corner corner{index(word, word.text.substr(0, first), soup_.positions.size(), "vertex")};
        if (first == std::string_view::npos) {
            return corner;
        }
        const std::string_view rest = word.text.substr(first + 1);
        const std::size_t second = rest.find('/');
        const std::string_view texture = rest.substr(0, second);
        if (!texture.empty() || second == std::string_view::npos) {
            corner.uv = index(word, texture, soup_.uvs.size(), "texture coordinate");
        }
        if (second != std::string_view::npos) {
            corner.normal = index(word, rest.substr(second + 1), soup_.normals.size(), "normal");
        }
        return corner;
    }

    void addFace() {
        if (words_.size() < 4) {
            fail(words_[0], "face has " + std::to_string(words_.size() - 1) + " corners", "it needs at least 3");
        }
        for (std::size_t k = 1; k < words_.size(); ++k) {
            soup_.corners.push_back(corner(words_[k]));
        }
        soup_.polygons.push_back({soup_.corners.size(), line_});
    }

    std::string_view rest_;
    std::string file_;
    int line_ = 0; // of the words: the last one where a statement has several
    int linesRead_ = 0;
    std::vector<Word> words_;
    PolygonSoup soup_;
};

} // namespace

Mesh parseObj(std::string_view bytes, const std::string& file) {
    return ObjParser(bytes, file).parse();
}

} // namespace hyalite
