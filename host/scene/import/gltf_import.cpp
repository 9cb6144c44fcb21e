// See gltf_import.h.
#include "scene/import/gltf_import.h"

#include "base/input_file.h"
#include "base/spelling.h"
#include "scene/import/gltf_document.h"
#include "scene/import/gltf_nodes.h"
#include "scene/import/gltf_primitive.h"
#include "scene/import/polygon_soup.h"
#include "scene/model/affine.h"
#include "scene/model/scene_limits.h"

#include <algorithm>
#include <array>
#include <map>

namespace hyalite {
namespace {

// Most objects made of one file: its nodes times the primitives of their meshes.
constexpr std::size_t kMostParts = std::size_t{1} << 20U;

// Required extensions that do not change the shape of meshes.
bool isHarmless(std::string_view extension) {
    constexpr std::array<std::string_view, 4> kKnown{"KHR_mesh_quantization", "KHR_texture_transform",
                                                     "KHR_texture_basisu", "KHR_lights_punctual"};
    return extension.starts_with("KHR_materials_") ||
           std::find(kKnown.begin(), kKnown.end(), extension) != kKnown.end();
}

void checkExtensions(const GltfValue& root) {
    const auto required = root.find("extensionsRequired");
    for (std::size_t i = 0; required && i < required->size(); ++i) {
        const GltfValue extension = required->at(i);
        if (!isHarmless(extension.text())) {
            extension.fail("the file requires the extension " + inQuotes(extension.text()) + ", which is not supported",
                           "export it without, uncompressed");
        }
    }
}

// What a material's "baseColorTexture": {"index": 3} stands for.
ImportedTexture readTexture(GltfDocument& document, const GltfValue& info) {
    const GltfValue texture = document.item("textures", info.require("index"));
    ImportedTexture imported;
    imported.place = texture.place();
    const auto set = info.find("texCoord");
    const auto extensions = info.find("extensions");
    const auto source = texture.find("source");
    if (set && set->whole() != 0) {
        imported.refusal = "it uses texture coordinates other than the first";
    } else if (extensions && extensions->find("KHR_texture_transform")) {
        imported.refusal = "it transforms the texture coordinates";
    } else if (!source) {
        imported.refusal = "it has no image in PNG or JPEG";
    } else {
        const GltfValue image = document.item("images", *source);
        const auto uri = image.find("uri");
        if (!uri) {
            imported.bytes = document.view(document.item("bufferViews", image.require("bufferView")));
        } else if (uri->text().starts_with("data:")) {
            imported.bytes = document.decodeData(*uri);
        } else {
            imported.file = document.pathOf(*uri, "image");
        }
    }
    return imported;
}

ImportedMaterial readMaterial(GltfDocument& document, const GltfValue& value) {
    ImportedMaterial material;
    if (const auto name = value.find("name")) {
        material.name = name->text();
    }
    const auto model = value.find("pbrMetallicRoughness");
    if (!model) {
        return material;
    }
    if (const auto color = model->find("baseColorFactor")) {
        const std::vector<double> numbers = color->numbers(4, 0, 1); // the fourth is opacity
        material.baseColor = {numbers[0], numbers[1], numbers[2]};
    }
    if (const auto metallic = model->find("metallicFactor")) {
        material.metallic = metallic->number(0, 1);
    }
    if (const auto roughness = model->find("roughnessFactor")) {
        material.roughness = roughness->number(0, 1);
    }
    if (const auto texture = model->find("baseColorTexture")) {
        material.baseColorTexture = readTexture(document, *texture);
    }
    if (const auto texture = model->find("metallicRoughnessTexture")) {
        material.metallicRoughnessTexture = readTexture(document, *texture);
    }
    return material;
}

class Importer {
public:
    explicit Importer(GltfDocument& document) : document_(document), root_(document.root()), primitives_(document) {}

    ImportedFile import() {
        checkExtensions(root_);
        if (const auto materials = root_.find("materials")) {
            for (std::size_t i = 0; i < materials->size(); ++i) {
                file_.materials.push_back(readMaterial(document_, materials->at(i)));
            }
        }
        for (const GltfPlacement& placement : placeGltfMeshes(document_)) {
            addParts(placement);
        }
        if (file_.parts.empty()) {
            throw Error(ExitCode::BadInput, SourceLocation{document_.file(), 0, 0},
                        "the file's scene shows no triangles");
        }
        return std::move(file_);
    }

private:
    void addParts(const GltfPlacement& placement) {
        const GltfValue mesh = root_.require("meshes").at(placement.mesh);
        const GltfValue primitives = mesh.require("primitives");
        const GltfValue node = root_.require("nodes").at(placement.node);
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const GltfValue primitive = primitives.at(i);
            checkMorphing(primitive, node);
            checkMorphing(primitive, mesh);
            const std::size_t index = findMesh(primitive);
            if (file_.meshes[index].triangles.empty()) {
                continue;
            }
            ImportedPart part{index, placement.toFile, {}, node.place() + ", " + primitive.place()};
            if (const auto material = primitive.find("material")) {
                part.material = material->index(root_, "materials");
            }
            file_.parts.push_back(std::move(part));
            if (file_.parts.size() > kMostParts) {
                primitives.fail("the file shows more than " + std::to_string(kMostParts) + " primitives");
            }
        }
    }

    // Weights other than 0 move the vertices, which is not supported.
    static void checkMorphing(const GltfValue& primitive, const GltfValue& owner) {
        const auto weights = owner.find("weights");
        for (std::size_t i = 0; primitive.find("targets") && weights && i < weights->size(); ++i) {
            if (weights->at(i).number() != 0) {
                weights->at(i).fail("morph targets are not supported", "export the mesh in its final shape");
            }
        }
    }

    // The mesh of a primitive, that of an earlier one where both have the same data.
    std::size_t findMesh(const GltfValue& primitive) {
        const GltfValue attributes = primitive.require("attributes");
        const auto number = [](const std::optional<GltfValue>& value) {
            return value ? static_cast<std::int64_t>(value->whole()) : -1;
        };
        const std::array<std::int64_t, 5> data{number(attributes.find("POSITION")), number(attributes.find("NORMAL")),
                                               number(attributes.find("TEXCOORD_0")), number(primitive.find("indices")),
                                               number(primitive.find("mode"))};
        const auto [known, isNew] = known_.try_emplace(data, file_.meshes.size());
        if (isNew) {
            file_.meshes.push_back(primitives_.read(primitive));
        }
        return known->second;
    }

    GltfDocument& document_;
    GltfValue root_;
    GltfPrimitives primitives_;
    ImportedFile file_;
    std::map<std::array<std::int64_t, 5>, std::size_t> known_;
};

// Appends a mesh under a transform, its positions to `positions`; with `smooth`, a mesh without normals gets those of
// its faces.
void append(const Mesh& part, const glm::dmat4& toFile, bool smooth, std::vector<glm::dvec3>& positions, Mesh& mesh) {
    const glm::dmat3 linear(toFile);
    const glm::dmat3 normalMap = glm::transpose(glm::inverse(linear));
    const bool isMirrored = glm::determinant(linear) < 0;
    const auto place = [&](const glm::vec3& position) {
        return glm::dvec3(toFile * glm::dvec4(part.origin + glm::dvec3(position), 1));
    };
    const auto add = [&](glm::uvec3 triangle) { // a reflection reverses the orientation of triangles
        mesh.triangles.push_back(isMirrored ? glm::uvec3(triangle.x, triangle.z, triangle.y) : triangle);
    };
    const auto first = static_cast<std::uint32_t>(positions.size());
    if (!smooth || !part.normals.empty()) {
        for (std::size_t i = 0; i < part.positions.size(); ++i) {
            positions.push_back(place(part.positions[i]));
            if (smooth) {
                mesh.normals.emplace_back(glm::normalize(normalMap * glm::dvec3(part.normals[i])));
            }
        }
        for (const glm::uvec3& triangle : part.triangles) {
            add(triangle + first);
        }
        return;
    }
    for (const glm::uvec3& triangle : part.triangles) {
        const glm::dvec3 a = part.positions[triangle.x];
        const glm::dvec3 area =
            glm::cross(glm::dvec3(part.positions[triangle.y]) - a, glm::dvec3(part.positions[triangle.z]) - a);
        const glm::dvec3 normal = normalMap * area;
        const auto corner = static_cast<std::uint32_t>(positions.size());
        for (int k = 0; k < 3; ++k) {
            positions.push_back(place(part.positions[triangle[k]]));
            mesh.normals.emplace_back(glm::length(normal) > 0 ? glm::normalize(normal) : glm::dvec3(0, 0, 1));
        }
        add({corner, corner + 1, corner + 2});
    }
}

} // namespace

ImportedFile importGltf(const std::filesystem::path& path, const SourceLocation& where) {
    const std::string bytes = readInputFile(path, kLargestMeshFile, "mesh", where);
    return parseGltf(bytes, path.string(), path.parent_path());
}

ImportedFile parseGltf(std::string_view bytes, const std::string& file, const std::filesystem::path& folder) {
    GltfDocument document(bytes, file, folder);
    return Importer(document).import();
}

Mesh mergeParts(const ImportedFile& file) {
    Mesh mesh;
    mesh.file = file.meshes[file.parts[0].mesh].file;
    const bool isSmooth = std::any_of(file.parts.begin(), file.parts.end(), [&](const ImportedPart& part) {
        return !file.meshes[part.mesh].normals.empty();
    });
    std::size_t triangles = 0;
    for (const ImportedPart& part : file.parts) {
        triangles += file.meshes[part.mesh].triangles.size();
    }
    checkTriangleCount(triangles, mesh.file); // shared meshes count each time
    std::vector<glm::dvec3> positions;
    for (const ImportedPart& part : file.parts) {
        if (!isInvertible(part.toFile)) {
            throw Error(ExitCode::BadInput, SourceLocation{.file = mesh.file},
                        part.name + ": the transform of this part is singular: it has no inverse",
                        "a part that has no volume is no part of a solid: remove it, or scale it by another factor");
        }
        append(file.meshes[part.mesh], part.toFile, isSmooth, positions, mesh);
    }
    setPositions(mesh, positions);
    return mesh;
}

MaterialModel sceneModel(const ImportedMaterial& material) {
    return MetallicRoughness{
        .baseColor = material.baseColor, .metallic = material.metallic, .roughness = material.roughness};
}

} // namespace hyalite
