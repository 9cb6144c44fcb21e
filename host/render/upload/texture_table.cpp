// See texture_table.h.
#include "render/upload/texture_table.h"

#include "shaders/shared/scene_records.h"

#include <algorithm>
#include <bit>

namespace hyalite::render {

namespace {

using glm::vec2;
using glm::vec3;
using glm::vec4;

float bits(std::size_t value) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(value));
}

} // namespace

bool hasTextures(const Scene& scene) {
    return std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
        return material.colorTexture.has_value() || material.roughnessTexture.has_value();
    });
}

std::vector<vec4> textureTexels(const std::vector<Texture>& textures, const glm::dvec3& origin) {
    std::vector<vec4> table(shared::kTexelsPerTexture * textures.size(), vec4(0));
    std::size_t customNumber = 0;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        vec4* record = &table[shared::kTexelsPerTexture * i];
        if (const auto* checker = std::get_if<Checker>(&textures[i].model)) {
            record[0] = vec4(bits(checker->inWorld ? shared::kTextureCheckerWorld : shared::kTextureCheckerUv),
                             vec3(checker->colors[0]));
            record[1] = vec4(static_cast<float>(1 / checker->size), vec3(checker->colors[1]));
            record[2] = vec4(vec3(glm::mod(origin / checker->size, 2.0)), 0); // the colours repeat after two cells
            continue;
        }
        if (const auto* custom = std::get_if<CustomTexture>(&textures[i].model)) {
            record[0] = vec4(bits(shared::kTextureCustom), bits(customNumber++), vec2(0));
            record[1] = vec4(custom->parameters);
            record[2] = vec4(vec3(origin), 0);
            continue;
        }
        const Image& image = *std::get<ImageTexture>(textures[i].model).image;
        record[0] = vec4(bits(shared::kTextureImage), bits(table.size()), bits(static_cast<std::size_t>(image.width)),
                         bits(static_cast<std::size_t>(image.height)));
        for (const vec3& pixel : image.pixels) {
            table.emplace_back(pixel, 0.0F);
        }
    }
    return table;
}

std::vector<vec4> coordinateTexels(const std::vector<Mesh>& meshes, const MeshTables& tables) {
    std::vector<vec4> table;
    table.reserve(shared::kTexelsPerCoordinates * tables.fileOrder.size());
    std::size_t next = 0;
    for (const std::uint32_t number : tables.order) {
        const Mesh& mesh = meshes[number];
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& corners = mesh.triangles[tables.fileOrder[next++]];
            const auto uv = [&](int corner) { return mesh.uvs.empty() ? vec2(0) : mesh.uvs[corners[corner]]; };
            table.emplace_back(uv(0), uv(1));
            table.emplace_back(uv(2), vec2(0));
        }
    }
    return table;
}

} // namespace hyalite::render
