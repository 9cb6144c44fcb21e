// What a key's row says, as the words of a table and as a JSON schema.
#pragma once

#include "scene/yaml/key_doc.h"

#include <string>
#include <vector>

namespace hyalite::describe {

// "number", "two whole numbers", or the row's own words.
[[nodiscard]] std::string typeText(const KeyDoc& key);

// "[0, 1]", "(0, 180)", "0, or [1e-9, 1e9]", the words in backticks, or the row's own words; empty where any will do.
[[nodiscard]] std::string rangeText(const KeyDoc& key);

// The members of the JSON schema that the value must satisfy, such as "type": "number" and "minimum": 0, with the
// description first and the default last. The default is there only if it is JSON, one of the key's words, or a
// fraction of two numbers: words such as "none" are for readers.
[[nodiscard]] std::vector<std::string> schemaMembers(const KeyDoc& key);

// As short as JSON allows: 1e-9, not 1e-09.
[[nodiscard]] std::string shortNumber(double value);

} // namespace hyalite::describe
