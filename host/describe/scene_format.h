// The generated parts of the JSON schema and of docs/scene-format.md. describe_scene_format writes them; a test
// compares them with the files.
#pragma once

#include <string>

namespace hyalite::describe {

inline constexpr const char* kSchemaFile = "scenes/hyalite.schema.json";
inline constexpr const char* kDocsFile = "docs/scene-format.md";
inline constexpr const char* kUpdateCommand = "cmake --build --preset release --target scene_format";

// The given file's text with its generated parts up to date. Throw Error(BadInput) if the place of a part is missing.
[[nodiscard]] std::string describedSchema(std::string schema);
[[nodiscard]] std::string describedDocs(std::string markdown);

} // namespace hyalite::describe
