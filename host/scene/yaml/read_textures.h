// Reads the scene file's textures, and the references to them in materials.
#pragma once

#include "image/png.h"
#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <filesystem>
#include <optional>
#include <span>

namespace hyalite {

// Reads one entry of `textures:`; file names are relative to `folder`. Throws Error(BadInput).
[[nodiscard]] Texture readTexture(const Value& value, const std::filesystem::path& folder);

// Decodes a PNG, JPEG or EXR file; all values must lie in [0, 1]. `encoding` applies to PNG and JPEG; EXR is linear.
// Throws Error(BadInput) naming the file.
[[nodiscard]] ImageTexture decodeTexture(std::span<const std::byte> bytes, const std::string& file, Encoding encoding);

// Reads a colour or the map `{texture: name}`. For a texture, sets `texture` to its index in Scene::textures and the
// colour, which multiplies it, to white. An absent key leaves both unchanged. Throws Error(BadInput).
void readTexturedColor(Reader& reader, std::string_view key, const Range& range, const Scene& scene, glm::dvec3& color,
                       std::optional<std::size_t>& texture);

// Reads a map with the single key `texture`: the index of the named texture. Throws Error(BadInput).
[[nodiscard]] std::size_t readTextureReference(const Value& map, const Scene& scene);

// Checks that every textured surface has the coordinates that its texture needs. Throws Error(BadInput) at the object.
void checkTextures(const Scene& scene);

} // namespace hyalite
