// See ply_header.h.
#include "scene/import/ply_header.h"

#include "base/error.h"
#include "base/numbers.h"
#include "base/spelling.h"

#include <algorithm>
#include <array>

namespace hyalite {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

// Both generations of names are in use.
constexpr std::array<TypeName, 16> kTypes{{
    {"char", PlyType::Int8},
    {"int8", PlyType::Int8},
    {"uchar", PlyType::Uint8},
    {"uint8", PlyType::Uint8},
    {"short", PlyType::Int16},
    {"int16", PlyType::Int16},
    {"ushort", PlyType::Uint16},
    {"uint16", PlyType::Uint16},
    {"int", PlyType::Int32},
    {"int32", PlyType::Int32},
    {"uint", PlyType::Uint32},
    {"uint32", PlyType::Uint32},
    {"float", PlyType::Float32},
    {"float32", PlyType::Float32},
    {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
}};

class HeaderParser {
public:
    HeaderParser(std::string_view bytes, std::string file) : bytes_(bytes), file_(std::move(file)) {}

    PlyHeader parse() {
        nextLine();
        if (words_.size() != 1 || words_[0] != "ply") {
            fail("not a PLY file", "its first line must be 'ply'");
        }
        bool hasFormat = false;
        for (nextLine(); words_.empty() || words_[0] != "end_header"; nextLine()) {
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") {
                continue;
            }
            if (words_[0] == "format") {
                readFormat();
                hasFormat = true;
            } else if (words_[0] == "element") {
                addElement();
            } else if (words_[0] == "property") {
                addProperty();
            } else {
                fail("unknown header line " + inQuotes(words_[0]));
            }
        }
        if (!hasFormat) {
            fail("the header has no 'format' line");
        }
        return std::move(header_);
    }

private:
    [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const {
        throw Error(ExitCode::BadInput, SourceLocation{file_, header_.lines, 1}, what, hint);
    }

    void nextLine() {
        const std::size_t end = bytes_.find('\n', header_.bytes);
        if (end == std::string_view::npos) {
            ++header_.lines;
            fail("unexpected end of file in the header", "its last line must be 'end_header'");
        }
        std::string_view line = bytes_.substr(header_.bytes, end - header_.bytes);
        header_.bytes = end + 1;
        ++header_.lines;

        words_.clear();
        constexpr std::string_view kBlanks = " \t\r";
        std::size_t begin = line.find_first_not_of(kBlanks);
        while (begin != std::string_view::npos) {
            const std::size_t stop = std::min(line.find_first_of(kBlanks, begin), line.size());
            words_.push_back(line.substr(begin, stop - begin));
            begin = line.find_first_not_of(kBlanks, stop);
        }
    }

    void readFormat() {
        if (words_.size() != 3 || words_[2] != "1.0") {
            fail("expected 'format' ascii, binary_little_endian or binary_big_endian, and 1.0");
        }
        if (words_[1] == "ascii") {
            header_.encoding = PlyEncoding::Ascii;
        } else if (words_[1] == "binary_little_endian") {
            header_.encoding = PlyEncoding::BinaryLittleEndian;
        } else if (words_[1] == "binary_big_endian") {
            header_.encoding = PlyEncoding::BinaryBigEndian;
        } else {
            fail("unknown PLY format " + inQuotes(words_[1]), "known: ascii, binary_little_endian, binary_big_endian");
        }
    }

    void addElement() {
        const auto count = words_.size() == 3 ? parseWhole(words_[2]) : std::nullopt;
        if (!count || *count < 0) {
            fail("expected 'element', a name and a count");
        }
        for (const PlyElement& element : header_.elements) {
            if (element.name == words_[1]) {
                fail("duplicate element " + inQuotes(words_[1]));
            }
        }
        header_.elements.push_back({std::string(words_[1]), static_cast<std::size_t>(*count), {}});
    }

    void addProperty() {
        if (header_.elements.empty()) {
            fail("property before the first element");
        }
        PlyProperty property;
        if (words_.size() == 5 && words_[1] == "list") {
            property.countType = type(words_[2]);
            if (!isWholeType(*property.countType)) {
                fail("the count of a list must have a whole-number type, found " + inQuotes(words_[2]));
            }
            property.type = type(words_[3]);
        } else if (words_.size() == 3) {
            property.type = type(words_[1]);
        } else {
            fail("expected 'property TYPE NAME' or 'property list COUNT_TYPE TYPE NAME'");
        }
        property.name = words_.back();
        for (const PlyProperty& other : header_.elements.back().properties) {
            if (other.name == property.name) {
                fail("duplicate property " + inQuotes(property.name));
            }
        }
        header_.elements.back().properties.push_back(property);
    }

    [[nodiscard]] PlyType type(std::string_view name) const {
        for (const TypeName& known : kTypes) {
            if (known.name == name) {
                return known.type;
            }
        }
        fail("unknown type " + inQuotes(name));
    }

    std::string_view bytes_;
    std::string file_;
    PlyHeader header_;
    std::vector<std::string_view> words_; // of the present line
};

} // namespace

std::size_t byteSize(PlyType type) {
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    return kSizes[static_cast<std::size_t>(type)]; // in the enumeration's order
}

bool isWholeType(PlyType type) {
    return type != PlyType::Float32 && type != PlyType::Float64;
}

PlyHeader parsePlyHeader(std::string_view bytes, const std::string& file) {
    return HeaderParser(bytes, file).parse();
}

} // namespace hyalite
