// Reads the GLSL files that a scene names: custom code for a texture, a material or a photon filter.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace hyalite {

// Reads the GLSL file that `file` names relative to `folder`. After following symbolic links, the file must be in that
// folder or below. It must define a function named after the file (without .glsl) that returns `type`.
// Throws Error(BadInput).
[[nodiscard]] std::shared_ptr<const CustomCode> readCustomCode(const Value& file, const std::filesystem::path& folder,
                                                               std::string_view type);

// Reads the key `parameters`: up to four numbers to pass to the custom function. Missing ones are 0.
void readCodeParameters(Reader& reader, glm::dvec4& parameters);

} // namespace hyalite
