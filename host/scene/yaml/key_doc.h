// What a key of the scene file is. The parser's ranges, the JSON schema and the tables of docs/scene-format.md come
// from these rows, so that they cannot disagree.
#pragma once

#include "scene/yaml/reader.h"

#include <span>
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
    Range range = {};                  // of numbers; its unit is the key's
    std::string_view defaultText = {}; // as the file would have it; empty: none
    bool required = false;
    std::string_view text = {}; // what it means: one line, no full stop
    std::span<const std::string_view> words = {};
    std::string_view schema = {}; // KeyType::Other: a JSON schema
};

} // namespace hyalite
