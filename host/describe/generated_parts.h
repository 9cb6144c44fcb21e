// Puts generated text into files that people write the rest of.
#pragma once

#include "scene/yaml/key_doc.h"

#include <span>
#include <string>
#include <vector>

namespace hyalite::describe {

// A table in Markdown: a row a key, and its meaning last. `extra`: a column before it, a text for each key, headed
// `extraHead`; none if that is empty.
[[nodiscard]] std::string keyTable(std::span<const KeyDoc> keys, const std::string& extraHead = {},
                                   const std::vector<std::string>& extra = {});

// One table of all types of a group, such as the lights: a row for each key, behind the type that it belongs to.
[[nodiscard]] std::string typeTable(std::span<const MapDoc> types);

// `text` with the lines between <!-- generated: NAME --> and the next <!-- end --> replaced. Throws Error(BadInput)
// where the marks are missing.
[[nodiscard]] std::string withGenerated(const std::string& text, const std::string& name, const std::string& part);

// The JSON schema of a map, as it stands after "NAME": in #/$defs.
[[nodiscard]] std::string definition(const MapDoc& map);

// `schema` with the definition NAME replaced. Throws Error(BadInput) where there is none yet.
[[nodiscard]] std::string withDefinition(const std::string& schema, const std::string& name, const std::string& part);

} // namespace hyalite::describe
