// The parts of the JSON schema and of docs/scene-format.md that follow from the program: written by
// describe_scene_format, and compared with the files by a test.
#pragma once

#include <string>

namespace hyalite::describe {

inline constexpr const char* kSchemaFile = "scenes/hyalite.schema.json";
inline constexpr const char* kDocsFile = "docs/scene-format.md";
inline constexpr const char* kUpdateCommand = "cmake --build --preset release --target scene_format";

// The files as they should be, made of their present text. Throw Error(BadInput) where that has no place for a part.
[[nodiscard]] std::string describedSchema(std::string schema);
[[nodiscard]] std::string describedDocs(std::string markdown);

} // namespace hyalite::describe
