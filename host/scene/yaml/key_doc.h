// What a key of the scene file is. The parser's ranges, the JSON schema and the tables of docs/scene-format.md come
// from these rows, so that they cannot disagree.
#pragma once

#include "scene/yaml/reader.h"

#include <span>
#include <string>
#include <string_view>

namespace hyalite {

enum class KeyType {
    Number,
    WholeNumber,
    Flag,          // true or false
    Word,          // one of `words`
    Text,          // a name or a path
    Vector,        // three numbers, each in `range`
    Color,         // a number or three
    TexturedColor, // the same, or {texture: NAME}
    WholePair,     // two whole numbers
    Other,         // anything else: `schema` says what
};

struct KeyDoc {
    std::string_view name;
    KeyType type = KeyType::Number;
    Range range = {};                  // of numbers; its unit is the key's; {0, 0}: any finite number
    std::string_view defaultText = {}; // as the file would have it, or in words; empty: none
    bool required = false;
    std::string_view text = {}; // what it means: one line of Markdown, no full stop
    std::span<const std::string_view> words = {};
    std::string_view schema = {}; // KeyType::Other: a JSON schema
    // What the tables of the documentation say where the members above do not say it well
    std::string_view typeText = {};  // "two colours"
    std::string_view rangeText = {}; // "at least 1e-9 above `min` in each coordinate"
};

// A map of the scene file, such as a type of material: its keys, and what relates them.
struct MapDoc {
    std::string_view type = {};        // what its key `type` says; empty: it has none
    std::string_view schemaName = {};  // its definition in the JSON schema, as in #/$defs/metallicRoughness
    std::string_view text = {};        // what it is: a sentence for the documentation, which may be empty
    std::span<const KeyDoc> keys = {}; // without `type`
    std::string_view rules = {};       // what relates keys: a JSON object merged into the schema of the map
};

// Without the marks of code and links: [their density](progressive.md) is "their density". A list in brackets, which is
// no link, stays as it is.
[[nodiscard]] std::string plainText(std::string_view markdown);

} // namespace hyalite
