// GLSL files that a scene names: code of its own for a texture, a material or a filter of photons.
#pragma once

#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace hyalite {

// The file that `file` names, relative to `folder`: in there or below, symbolic links followed. It must define a
// function of its own name (that of the file without .glsl) that returns `type`. Throws Error(BadInput).
[[nodiscard]] std::shared_ptr<const CustomCode> readCustomCode(const Value& file, const std::filesystem::path& folder,
                                                               std::string_view type);

// 'parameters', up to four numbers that such a function is given; those that are not there are 0.
void readCodeParameters(Reader& reader, glm::dvec4& parameters);

} // namespace hyalite
