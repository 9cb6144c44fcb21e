// Typed reading of a YAML tree. A Value knows its name and place and reads itself as a number, vector, colour or text
// within a range. A Reader reads a map key by key and reports keys that were never asked for. The code that reads a map
// is then a list of its keys; the default of a key is the variable's value before the read.
#pragma once

#include "base/error.h"
#include "base/numbers.h"
#include "scene/yaml/yaml_tree.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite {

// The valid numbers of a key; each end is included or excluded. `unit` is for messages.
struct Range {
    double low = 0;
    double high = 0;
    bool lowIncluded = true;
    bool highIncluded = true;
    std::string_view unit = {};
    bool orZero = false; // 0 is valid too: it means automatic

    [[nodiscard]] bool contains(double value) const; // false for NaN
    [[nodiscard]] std::string text() const;          // "in [0, 1] m", "0 or in [1e-09, 1] m"
};

// One value of the document. Every read throws Error(BadInput) at the value's place.
class Value {
public:
    Value(const YamlNode& node, const std::string& file, std::string name)
        : node_(&node), file_(&file), name_(std::move(name)) {}

    [[nodiscard]] SourceLocation where() const { return {*file_, node_->line, node_->column}; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const YamlNode& node() const { return *node_; }
    [[nodiscard]] const std::string& file() const { return *file_; }

    [[noreturn]] void fail(const std::string& what, const std::string& hint = {}) const;

    [[nodiscard]] std::string text() const;                         // not empty
    [[nodiscard]] std::vector<Value> list() const;                  // items have the list's name
    [[nodiscard]] std::vector<Value> list(std::size_t count) const; // exactly `count` items
    [[nodiscard]] std::vector<double> numbers(std::size_t count, const Range& each) const;

    void read(double& out, const Range& range) const;
    void read(std::uint32_t& out, const Range& range) const;
    void read(bool& out) const;
    void read(glm::dvec3& out, const Range& each) const;
    void read(glm::uvec2& out, const Range& each) const;
    void readColor(glm::dvec3& out, const Range& each) const; // one number means three equal ones

private:
    [[nodiscard]] std::string describe() const; // describes the value, for "must be ..., found ..."
    [[noreturn]] void expected(const std::string& what, const std::string& hint = {}) const;

    const YamlNode* node_;
    const std::string* file_;
    std::string name_;
};

// Reads the keys of one map. References the document, which must outlive the reader.
class Reader {
public:
    explicit Reader(const Value& map);

    [[nodiscard]] SourceLocation where() const { return map_.where(); }
    [[nodiscard]] const Value& map() const { return map_; }

    [[nodiscard]] std::optional<Value> find(std::string_view key); // none when the key is absent
    [[nodiscard]] Value require(std::string_view key);             // throws when the key is absent

    // An absent key leaves `out` unchanged.
    template <class T>
    void optional(std::string_view key, T& out, const Range& range) {
        if (const auto value = find(key)) {
            value->read(out, range);
        }
    }
    void optional(std::string_view key, bool& out) {
        if (const auto value = find(key)) {
            value->read(out);
        }
    }
    void optionalColor(std::string_view key, glm::dvec3& out, const Range& each) {
        if (const auto value = find(key)) {
            value->readColor(out, each);
        }
    }
    template <class T>
    void required(std::string_view key, T& out, const Range& range) {
        require(key).read(out, range);
    }

    // Call after reading all keys: throws at the first key of the map that was never asked for.
    void finish() const;

private:
    [[noreturn]] void failUnknown(const YamlEntry& entry) const;

    Value map_;
    std::vector<std::string> asked_;
};

// A word of the file and its meaning, e.g. a material type and the function that reads it.
template <class T>
struct Choice {
    std::string_view name;
    T meaning;
};

// The meaning of the word in `value`. An unknown word throws an error that suggests the nearest known one.
template <class T>
[[nodiscard]] T choose(const Value& value, std::string_view kind, std::span<const Choice<T>> choices);

[[noreturn]] void failUnknownWord(const Value& value, std::string_view kind, std::span<const std::string> known);

template <class T>
T choose(const Value& value, std::string_view kind, std::span<const Choice<T>> choices) {
    const std::string word = value.text();
    std::vector<std::string> known;
    for (const Choice<T>& choice : choices) {
        if (choice.name == word) {
            return choice.meaning;
        }
        known.emplace_back(choice.name);
    }
    failUnknownWord(value, kind, known);
}

} // namespace hyalite
