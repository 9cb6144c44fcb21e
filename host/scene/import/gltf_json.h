// A value of a glTF file's JSON that knows its place, as in "accessors[3].count", and reads itself as what the format
// says it must be.
#pragma once

#include "base/error.h"

#include <cstdint>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

// References the document and the file's name, which must outlive it. Every read throws Error(BadInput).
class GltfValue {
public:
    GltfValue(const nlohmann::json& json, const std::string& file, std::string place = {})
        : json_(&json), file_(&file), place_(std::move(place)) {}

    [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const;

    // Of an object; none when the key is absent.
    [[nodiscard]] std::optional<GltfValue> find(const char* key) const;
    [[nodiscard]] GltfValue require(const char* key) const;

    // Of a list.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] GltfValue at(std::size_t index) const;

    [[nodiscard]] const std::string& text() const;
    [[nodiscard]] bool truth() const;
    [[nodiscard]] double number(double low = -std::numeric_limits<double>::max(),
                                double high = std::numeric_limits<double>::max()) const;
    [[nodiscard]] std::vector<double> numbers(std::size_t count, double low = -std::numeric_limits<double>::max(),
                                              double high = std::numeric_limits<double>::max()) const;
    [[nodiscard]] std::uint64_t whole(std::uint64_t low = 0, std::uint64_t high = std::uint64_t{1} << 53U) const;

    // A whole number that is an index into the list `name` at the top of the document: that item.
    [[nodiscard]] std::size_t index(const GltfValue& document, const char* name) const;

    [[nodiscard]] const std::string& place() const { return place_; }
    [[nodiscard]] const std::string& file() const { return *file_; }

private:
    [[noreturn]] void expected(const std::string& what) const;

    const nlohmann::json* json_;
    const std::string* file_;
    std::string place_; // empty: the document itself
};

} // namespace hyalite
