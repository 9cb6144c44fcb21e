// See read_textures.h. A new texture is a reader here and a row of kTextures.
#include "scene/yaml/read_textures.h"

#include "base/input_file.h"
#include "base/spelling.h"
#include "image/exr.h"
#include "image/jpeg.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/custom_code.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kFraction{0, 1};
constexpr Range kCell{kSmallestLength, kLargestLength};

TextureModel readChecker(Reader& reader, const std::filesystem::path& /*folder*/) {
    constexpr std::array<Choice<bool>, 2> kSpaces{{{"world", true}, {"uv", false}}};
    Checker checker;
    if (const auto colors = reader.find("colors")) {
        const std::vector<Value> two = colors->list(2);
        for (std::size_t i = 0; i < two.size(); ++i) {
            two[i].readColor(checker.colors.at(i), kFraction);
        }
    }
    reader.optional("size", checker.size, kCell);
    if (const auto space = reader.find("space")) {
        checker.inWorld = choose<bool>(*space, "space of a checker", kSpaces);
    }
    return checker;
}

TextureModel readImageTexture(Reader& reader, const std::filesystem::path& folder) {
    constexpr std::array<Choice<Encoding>, 2> kEncodings{{{"srgb", Encoding::Srgb}, {"linear", Encoding::Linear}}};
    const Value file = reader.require("file");
    Encoding encoding = Encoding::Srgb;
    if (const auto name = reader.find("encoding")) {
        encoding = choose<Encoding>(*name, "encoding", kEncodings);
    }
    reader.finish(); // report a wrong key before reading a large file
    const std::filesystem::path path = folder / file.text();
    const std::string bytes = readInputFile(path, kLargestTextureFile, "texture", file.where());
    return decodeTexture(std::as_bytes(std::span(bytes)), path.string(), encoding);
}

TextureModel readCustomTexture(Reader& reader, const std::filesystem::path& folder) {
    const Value file = reader.require("file");
    CustomTexture texture;
    readCodeParameters(reader, texture.parameters);
    reader.finish();
    texture.code = readCustomCode(file, folder, "vec3");
    return texture;
}

using ReadModel = TextureModel (*)(Reader&, const std::filesystem::path&);
constexpr std::array<Choice<ReadModel>, 3> kTextures{{
    {"checker", readChecker},
    {"image", readImageTexture},
    {"custom", readCustomTexture},
}};

std::size_t findTexture(const Value& name, const Scene& scene) {
    const std::string wanted = name.text();
    std::vector<std::string> known;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        if (scene.textures[i].name == wanted) {
            return i;
        }
        known.push_back(scene.textures[i].name);
    }
    failUnknownWord(name, "texture", known);
}

// A world-space checker needs no surface coordinates. Custom code gets the world position too.
bool needsCoordinates(const Texture& texture) {
    const auto* checker = std::get_if<Checker>(&texture.model);
    return checker != nullptr ? !checker->inWorld : std::holds_alternative<ImageTexture>(texture.model);
}

// A csg counts as having them: its leaves are checked on their own.
bool hasCoordinates(const Scene& scene, const Shape& shape) {
    if (const auto* instance = std::get_if<MeshInstance>(&shape)) {
        return !scene.meshes[instance->mesh].uvs.empty();
    }
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Quad>(shape) ||
           std::holds_alternative<Disk>(shape) || std::holds_alternative<Csg>(shape);
}

void checkTextures(const Scene& scene, const Object& object) {
    if (!object.material || hasCoordinates(scene, object.shape)) {
        return;
    }
    const Material& material = scene.materials[*object.material];
    for (const auto& index : {material.colorTexture, material.roughnessTexture}) {
        if (index && needsCoordinates(scene.textures[*index])) {
            throw Error(ExitCode::BadInput, object.where,
                        "the texture " + inQuotes(scene.textures[*index].name) +
                            " needs surface coordinates, which this shape does not have",
                        "spheres, quads, disks and meshes with texture coordinates have them; a checker with space: "
                        "world works on every shape");
        }
    }
}

} // namespace

Texture readTexture(const Value& value, const std::filesystem::path& folder) {
    Reader reader(value);
    const auto read = choose<ReadModel>(reader.require("type"), "texture type", kTextures);
    Texture texture{value.name(), read(reader, folder)};
    reader.finish();
    return texture;
}

ImageTexture decodeTexture(std::span<const std::byte> bytes, const std::string& file, Encoding encoding) {
    const auto fail = [&](const std::string& what, const std::string& hint) {
        throw Error(ExitCode::BadInput, SourceLocation{file, 0, 0}, what, hint);
    };
    Image image;
    if (looksLikePng(bytes)) {
        image = decodePng(bytes, file, encoding);
    } else if (looksLikeJpeg(bytes)) {
        image = decodeJpeg(bytes, file, encoding);
    } else if (looksLikeExr(bytes)) {
        image = decodeExr(bytes, file);
    } else {
        fail("not a PNG, JPEG or EXR file", "save the texture as PNG");
    }
    if (image.pixels.size() > kMostTexels) {
        fail("the texture has more than " + std::to_string(kMostTexels) + " pixels", "make it smaller");
    }
    for (const glm::vec3& pixel : image.pixels) {
        for (int channel = 0; channel < 3; ++channel) {
            if (!(pixel[channel] >= 0 && pixel[channel] <= 1)) {
                fail("a pixel of the texture is " + numberText(pixel[channel]) + ", not in [0, 1]",
                     "a texture holds fractions of reflected light");
            }
        }
    }
    return {std::make_shared<const Image>(std::move(image))};
}

void readTexturedColor(Reader& reader, std::string_view key, const Range& range, const Scene& scene, glm::dvec3& color,
                       std::optional<std::size_t>& texture) {
    const auto value = reader.find(key);
    if (!value) {
        return;
    }
    if (value->node().kind != YamlNode::Kind::Map) {
        value->readColor(color, range);
        return;
    }
    texture = readTextureReference(*value, scene);
    color = glm::dvec3(1);
}

std::size_t readTextureReference(const Value& map, const Scene& scene) {
    Reader reader(map);
    const std::size_t texture = findTexture(reader.require("texture"), scene);
    reader.finish();
    return texture;
}

void checkTextures(const Scene& scene) {
    for (const Object& object : scene.objects) {
        checkTextures(scene, object);
    }
    for (const Object& leaf : scene.csgLeaves) {
        checkTextures(scene, leaf);
    }
}

} // namespace hyalite
