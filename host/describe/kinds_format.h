// The parts of the JSON schema and of docs/scene-format.md that come from the rows of materials, lights and shapes.
#pragma once

#include <string>

namespace hyalite::describe {

// The given file's text with these parts up to date. A kind that the schema lacks is added to it; the docs need the
// marks of each shape. Throw Error(BadInput) if the place of a part is missing.
[[nodiscard]] std::string schemaWithKinds(std::string schema);
[[nodiscard]] std::string docsWithKinds(std::string markdown);

} // namespace hyalite::describe
