// The header of a PLY file: its encoding and the elements that follow, with their properties.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

enum class PlyEncoding { Ascii, BinaryLittleEndian, BinaryBigEndian };
enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

[[nodiscard]] std::size_t byteSize(PlyType type);
[[nodiscard]] bool isWholeType(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float32;
    std::optional<PlyType> countType; // a list: the type of the count before its items
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0; // of the header, its last line break included
    int lines = 0;
};

// Throws Error(BadInput) with the place in the file.
[[nodiscard]] PlyHeader parsePlyHeader(std::string_view bytes, const std::string& file);

} // namespace hyalite
