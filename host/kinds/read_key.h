// Reads a key as its row describes it: checks the value against the range of the row.
#pragma once

#include "scene/yaml/key_doc.h"
#include "scene/yaml/reader.h"

#include <glm/glm.hpp>
#include <optional>
#include <type_traits>

namespace hyalite::kinds {

// Reads the value of the key into `out`. An absent key leaves `out` unchanged, or throws if it is required.
// Throws Error(BadInput).
template <class T>
void readKey(Reader& reader, const KeyDoc& key, T& out) {
    const auto value = key.required ? std::optional(reader.require(key.name)) : reader.find(key.name);
    if (!value) {
        return;
    }
    if constexpr (std::is_same_v<T, bool>) {
        value->read(out);
    } else if constexpr (std::is_same_v<T, glm::dvec3>) {
        key.type == KeyType::Color ? value->readColor(out, key.range) : value->read(out, key.range);
    } else {
        value->read(out, key.range);
    }
}

} // namespace hyalite::kinds
