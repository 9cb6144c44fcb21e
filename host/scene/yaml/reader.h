// Typed reading of a YAML tree: a Value knows its name and place and reads itself as a number, vector, colour or text
// within a range; a Reader takes a map's keys one by one and reports those that nobody asked for. A concept of the
// scene file is then a list of keys, and the default of each key is what the variable holds already.
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

// The numbers a key may hold; each end may be part of the range or not. `unit` is for the message.
struct Range {
    double low = 0;
    double high = 0;
    bool lowIncluded = true;
    bool highIncluded = true;
    std::string_view unit = {};
    bool orZero = false; // 0 is in the range, too: it stands for a choice of the program's

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
    [[nodiscard]] std::vector<Value> list() const;                  // items are named like the list
    [[nodiscard]] std::vector<Value> list(std::size_t count) const; // exactly so many
    [[nodiscard]] std::vector<double> numbers(std::size_t count, const Range& each) const;

    void read(double& out, const Range& range) const;
    void read(std::uint32_t& out, const Range& range) const;
    void read(bool& out) const;
    void read(glm::dvec3& out, const Range& each) const;
    void read(glm::uvec2& out, const Range& each) const;
    void readColor(glm::dvec3& out, const Range& each) const; // one number stands for three equal ones

private:
    [[nodiscard]] std::string describe() const; // what the value is, for "expected ..., found ..."
    [[noreturn]] void expected(const std::string& what, const std::string& hint = {}) const;

    const YamlNode* node_;
    const std::string* file_;
    std::string name_;
};

// The keys of one map. References the document, which must outlive it.
class Reader {
public:
    explicit Reader(const Value& map);

    [[nodiscard]] SourceLocation where() const { return map_.where(); }
    [[nodiscard]] const Value& map() const { return map_; }

    [[nodiscard]] std::optional<Value> find(std::string_view key); // none when the key is absent
    [[nodiscard]] Value require(std::string_view key);             // an error when it is

    // An absent key leaves `out` as it is.
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

    // Call when all keys are read: the first key in the map that was never asked for is an error.
    void finish() const;

private:
    [[noreturn]] void failUnknown(const YamlEntry& entry) const;

    Value map_;
    std::vector<std::string> asked_;
};

// A word of the file and what it stands for: a material type and the function that reads it, say.
template <class T>
struct Choice {
    std::string_view name;
    T meaning;
};

// The meaning of the word that `value` holds; any other word is an error that names the nearest.
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
