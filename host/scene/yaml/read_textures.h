// The scene file's textures, and the places in materials where they are named.
#pragma once

#include "image/png.h"
#include "scene/model/scene.h"
#include "scene/yaml/reader.h"

#include <filesystem>
#include <optional>
#include <span>

namespace hyalite {

// One entry of `textures:`; files are relative to `folder`. Throws Error(BadInput).
[[nodiscard]] Texture readTexture(const Value& value, const std::filesystem::path& folder);

// A picture from the bytes of a PNG, JPEG or EXR file, with nothing in it but numbers in [0, 1]; `encoding` is for the
// former two, EXR files are linear.
// Throws Error(BadInput) that names the file.
[[nodiscard]] ImageTexture decodeTexture(std::span<const std::byte> bytes, const std::string& file, Encoding encoding);

// A colour, or the map `{texture: name}` in its place: then the colour is left white, to be multiplied by the texture
// whose index in Scene::textures is set. An absent key leaves both as they are. Throws Error(BadInput).
void readTexturedColor(Reader& reader, std::string_view key, const Range& range, const Scene& scene, glm::dvec3& color,
                       std::optional<std::size_t>& texture);

// Index of the texture that a map of the one key `texture` names. Throws Error(BadInput).
[[nodiscard]] std::size_t readTextureReference(const Value& map, const Scene& scene);

// Every textured surface must have the coordinates that its texture asks for. Throws Error(BadInput) at the shape.
void checkTextures(const Scene& scene);

} // namespace hyalite
