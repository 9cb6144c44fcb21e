// Inserts generated text into otherwise hand-written files.
#pragma once

#include "scene/yaml/key_doc.h"

#include <span>
#include <string>
#include <vector>

namespace hyalite::describe {

// A Markdown table with a row per key; the last column is its meaning. `extra`: a column before it with a text per key
// and the heading `extraHead`; no such column if that is empty.
[[nodiscard]] std::string keyTable(std::span<const KeyDoc> keys, const std::string& extraHead = {},
                                   const std::vector<std::string>& extra = {});

// One table of all types of a group, such as the lights: a row for each key, with its type in the first column. The
// keys `ofAll` that types share come last, once, under "all".
[[nodiscard]] std::string typeTable(std::span<const MapDoc> types, std::span<const KeyDoc> ofAll = {});

// `text` with the lines between <!-- generated: NAME --> and the next <!-- end --> replaced. Throws Error(BadInput) if
// the marks are missing.
[[nodiscard]] std::string withGenerated(const std::string& text, const std::string& name, const std::string& part);

// The JSON schema of a map or a key: the text after "NAME": in #/$defs. `types`: the values of the map's key `type`, if
// several types have the same keys.
[[nodiscard]] std::string definition(const MapDoc& map, std::span<const std::string_view> types = {});
[[nodiscard]] std::string definition(const KeyDoc& key);

// `schema` with the definition NAME replaced. Throws Error(BadInput) if the schema has no such definition.
[[nodiscard]] std::string withDefinition(const std::string& schema, const std::string& name, const std::string& part);

// `schema` with an empty definition NAME before the definition `next`, unless it has the definition NAME. Throws
// Error(BadInput) if the schema has no definition `next`.
[[nodiscard]] std::string withPlaceFor(const std::string& schema, const std::string& name, const std::string& next);

} // namespace hyalite::describe
