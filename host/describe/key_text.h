// Formats a key's row for a table and as a JSON schema.
#pragma once

#include "scene/yaml/key_doc.h"

#include <string>
#include <vector>

namespace hyalite::describe {

// "number", "two whole numbers", or the row's own text.
[[nodiscard]] std::string typeText(const KeyDoc& key);

// "[0, 1]", "(0, 180)", "0, or [1e-9, 1e9]", the words in backticks, or the row's own text; empty: any value.
[[nodiscard]] std::string rangeText(const KeyDoc& key);

// The members of the JSON schema for the value, such as "type": "number" and "minimum": 0, with the description first
// and the default last. The default is included only if it is JSON, one of the key's words, or a fraction of two
// numbers; text such as "none" is only for the documentation.
[[nodiscard]] std::vector<std::string> schemaMembers(const KeyDoc& key);

// The number as short as JSON allows: 1e-9, not 1e-09.
[[nodiscard]] std::string shortNumber(double value);

} // namespace hyalite::describe
