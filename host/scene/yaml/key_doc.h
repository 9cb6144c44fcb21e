// Description of a scene file key. The parser's ranges, the JSON schema and the tables of docs/scene-format.md all
// come from these rows, so they cannot disagree.
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
    Color,         // one number or three
    TexturedColor, // a Color or {texture: NAME}
    WholePair,     // two whole numbers
    Other,         // anything else: `schema` defines it
};

struct KeyDoc {
    std::string_view name;
    KeyType type = KeyType::Number;
    Range range = {};                  // for numbers, with the key's unit; {0, 0}: any finite number
    std::string_view defaultText = {}; // as the file would write it, or in words; empty: none
    bool required = false;
    std::string_view text = {}; // what the key means: one line of Markdown, no full stop
    std::span<const std::string_view> words = {};
    std::string_view schema = {}; // a JSON schema, for KeyType::Other, or for texts that not every name is
    // Replace, in the tables of the documentation, the text made from the members above
    std::string_view typeText = {};  // "two colours"
    std::string_view rangeText = {}; // "at least 1e-9 above `min` in each coordinate"
};

// A map of the scene file, such as a material type: its keys and the rules between them.
struct MapDoc {
    std::string_view type = {};        // value of its key `type`; empty: the map has no such key
    std::string_view schemaName = {};  // name of its definition in the JSON schema, as in #/$defs/metallicRoughness
    std::string_view text = {};        // description: a sentence for the documentation; may be empty
    std::span<const KeyDoc> keys = {}; // without `type`
    std::string_view rules = {};       // rules between keys: a JSON object merged into the schema of the map
};

// The text without code and link markup: [their density](progressive.md) becomes "their density". A list in brackets
// is not a link and stays as it is.
[[nodiscard]] std::string plainText(std::string_view markdown);

} // namespace hyalite
