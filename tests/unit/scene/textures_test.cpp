// Textures in the scene file, in the materials that name them, and in mesh files.
#include "unit/scene/bad_scene.h"
#include "unit/scene/mesh_gltf_support.h"

#include "image/image_io.h"
#include "scene/import/mesh_import.h"

#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace hyalite;
using namespace hyalite::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;

namespace {

const std::string kStart = "hyalite: 1\nlights: [{type: point, position: [0, 1, 0]}]\n";
const std::string kObject = "objects: [{shape: {type: sphere, radius: 1}, material: m}]\n";

// One red above one gray pixel; the gray is stored as 188: ((188 / 255 + 0.055) / 1.055)^2.4 = 0.5029 of the light.
Image redAndGray() {
    Image image(1, 2);
    image.at(0, 0) = {1, 0, 0};
    image.at(0, 1) = glm::vec3(0.5029F);
    return image;
}

Scene loadWith(TemporaryFolder& folder, const std::string& textures, const std::string& material) {
    return loadScene(folder.write("scene.yaml", kStart + "textures: {t: " + textures + "}\nmaterials: {m: " + material +
                                                    "}\n" + kObject));
}

// A triangle in glTF with one material of one texture, whose image is as `image` says.
Gltf texturedGltf(const json& image) {
    Gltf gltf = pyramidGltf();
    const std::size_t uv =
        gltf.add(bytesOf(std::vector<float>(2 * kCorners.size(), 0.25F)), "VEC2", kFloat, kCorners.size());
    json& primitive = gltf.document["meshes"][0]["primitives"][0];
    primitive["attributes"]["TEXCOORD_0"] = uv;
    primitive["material"] = 0;
    gltf.document["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {0.5, 1, 1, 1}}, {"metallicFactor", 0}, {"baseColorTexture", {{"index", 0}}}}}}};
    gltf.document["textures"] = {{{"source", 0}}};
    gltf.document["images"] = {image};
    return gltf;
}

Scene loadGltf(TemporaryFolder& folder, const Gltf& gltf) {
    folder.write("m.gltf", gltf.text());
    return loadScene(folder.write("scene.yaml", kStart + "objects: [{shape: {type: mesh, file: m.gltf}}]\n"));
}

} // namespace

TEST_CASE("a checker has two colours, a size and a space") {
    TemporaryFolder folder;
    const Scene all = loadWith(folder, "{type: checker, colors: [0.25, [1, 0.5, 0]], size: 3, space: uv}",
                               "{type: diffuse, albedo: {texture: t}}");
    const auto& checker = std::get<Checker>(all.textures.at(0).model);
    CHECK(checker.colors[0] == glm::dvec3(0.25));
    CHECK(checker.colors[1] == glm::dvec3(1, 0.5, 0));
    CHECK(checker.size == 3);
    CHECK_FALSE(checker.inWorld);
    CHECK(all.materials.at(0).colorTexture == 0U);
    CHECK(all.materials.at(0).model.color == glm::dvec3(1)); // the texture says the rest

    const Scene defaults = loadWith(folder, "{type: checker}", "{type: mirror, reflectance: {texture: t}}");
    CHECK(std::get<Checker>(defaults.textures.at(0).model).inWorld);
    CHECK(defaults.materials.at(0).colorTexture == 0U);
    const Scene unused = loadWith(folder, "{type: checker}", "{type: mirror}");
    CHECK_FALSE(unused.materials.at(0).colorTexture.has_value());
}

TEST_CASE("metallic-roughness takes its colour and its two numbers from textures") {
    TemporaryFolder folder;
    const std::string textures = "{type: checker}, u: {type: checker, size: 2}";
    const auto read = [&](const std::string& keys) {
        return loadWith(folder, textures, "{type: metallic_roughness, base_color: {texture: t}, " + keys + "}")
            .materials.at(0);
    };
    const Material worn = read("metallic_roughness_texture: {texture: u}");
    CHECK(worn.colorTexture == 0U);
    CHECK(worn.roughnessTexture == 1U);
    const MaterialModel& model = worn.model;
    CHECK(model.color == glm::dvec3(1)); // the textures say the rest
    CHECK(model.metallic == 1);
    CHECK(model.roughness == 1);
    const Material scaled = read("metallic: 0.5, metallic_roughness_texture: {texture: u}, roughness: 0.25");
    CHECK(scaled.model.metallic == 0.5);
    CHECK(scaled.model.roughness == 0.25);
    const Material plain = read("metallic: 0.5");
    CHECK_FALSE(plain.roughnessTexture.has_value());
    CHECK(plain.model.roughness == 0.5);
}

TEST_CASE("an image is read as linear light, or as raw numbers on request") {
    TemporaryFolder folder;
    writeImage(folder.path() / "i.png", redAndGray(), {});
    writeImage(folder.path() / "i.exr", redAndGray(), {});
    const auto grayOf = [&](const std::string& keys) {
        const Scene scene = loadWith(folder, "{type: image, " + keys + "}", "{type: diffuse, albedo: {texture: t}}");
        const Image& image = *std::get<ImageTexture>(scene.textures.at(0).model).image;
        CHECK(image.at(0, 0) == glm::vec3(1, 0, 0));
        return double{image.at(0, 1).y};
    };
    CHECK_THAT(grayOf("file: i.png"), WithinAbs(0.5029, 5e-5));
    CHECK_THAT(grayOf("file: i.png, encoding: srgb"), WithinAbs(0.5029, 5e-5));
    CHECK_THAT(grayOf("file: i.png, encoding: linear"), WithinAbs(188 / 255.0, 1e-7));
    CHECK_THAT(grayOf("file: i.exr"), WithinAbs(0.5029, 1e-7));
}

TEST_CASE("mistakes in textures are reported with their place") {
    const std::string mirror = "materials: {m: {type: mirror, reflectance: {texture: t}}}\n" + kObject;
    checkAll({
        {kStart + "textures: {t: {type: $noise}}\n" + mirror, "unknown texture type 'noise'", "known: checker, image"},
        {kStart + "textures: {t: {type: checker, size: $0}}\n" + mirror, "'size' must be in"},
        {kStart + "textures: {t: {type: checker, colors: $[0, 1, 0]}}\n" + mirror, "'colors' must be a list of 2"},
        {kStart + "textures: {t: {type: checker, colors: [0, $2]}}\n" + mirror, "must be in [0, 1]"},
        {kStart + "textures: {t: {type: checker, space: $here}}\n" + mirror, "unknown space of a checker 'here'"},
        {kStart + "textures: {t: {type: image, file: $none.png}}\n" + mirror, "no such file"},
        {kStart + "textures: {t: {type: image, file: none.png, encoding: $gamma}}\n" + mirror, "unknown encoding"},
        {kStart + "textures: {u: {type: checker}}\nmaterials: {m: {type: mirror, reflectance: {texture: $t}}}\n" +
             kObject,
         "unknown texture 't'"},
        {kStart +
             "textures: {t: {type: checker}}\nmaterials: {m: {type: mirror, reflectance: {texture: t, $size: 1}}}\n" +
             kObject,
         "unknown key 'size'"},
        {kStart + "textures: {t: {type: checker}}\nmaterials: {m: {type: dielectric, absorption: ${texture: t}}}\n" +
             kObject,
         "'absorption' must be"},
        {kStart + "materials: {m: {type: dielectric, absorption: $-1}}\n" + kObject, "'absorption' must be in"},
    });
}

TEST_CASE("a shape without surface coordinates refuses a texture that needs them") {
    const std::string start = kStart +
                              "textures: {t: {type: checker, space: uv}}\nmaterials: {m: {type: diffuse, albedo: "
                              "{texture: t}}, n: {type: mirror}}\nobjects:\n  - ";
    const std::string what = "the texture 't' needs surface coordinates";
    checkAll({
        {start + "${shape: {type: plane, point: [0, 0, 0], normal: [0, 1, 0]}, material: m}\n", what, "checker"},
        {start + "${shape: {type: sphere, radius: 1}, material: m, transform: [{scale: [1, 2, 1]}]}\n", what},
        {start + "${shape: {type: mesh, file: mesh.obj}, material: m}\n", what, "",
         "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {start + "{shape: {type: csg, op: union, left: {type: sphere, radius: 1, material: m}, right: ${type: box, "
                 "min: [0, 0, 0], max: [1, 1, 1], material: m}}}\n",
         what},
    });
}

TEST_CASE("a texture with numbers beyond 1 is refused, and so is a file that is not a picture") {
    TemporaryFolder folder;
    Image bright = redAndGray();
    bright.at(0, 1).y = 1.5F;
    writeImage(folder.path() / "bright.exr", bright, {});
    folder.write("text.png", "This is no picture");
    const auto whatOf = [&](const std::string& file) {
        const auto error = errorOf([&] { loadWith(folder, "{type: image, file: " + file + "}", "{type: mirror}"); });
        REQUIRE(error.has_value());
        CHECK(error->code() == ExitCode::BadInput);
        CHECK(error->where().file == (folder.path() / file).string());
        return std::string(error->what());
    };
    CHECK_THAT(whatOf("bright.exr"), ContainsSubstring("a pixel of the texture is 1.5"));
    CHECK_THAT(whatOf("text.png"), ContainsSubstring("not a PNG, JPEG or EXR file"));
}

TEST_CASE("OBJ corners at one position with different texture coordinates become separate vertices") {
    // Two triangles of a square; the second has other coordinates at one of the two corners that they share
    const Mesh mesh = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5\n"
                               "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n",
                               "m.obj");
    REQUIRE(mesh.positions.size() == 5);
    REQUIRE(mesh.uvs.size() == 5);
    CHECK(mesh.normals.empty()); // it stays flat
    const auto uvAt = [&](std::size_t triangle, int corner) { return mesh.uvs[mesh.triangles[triangle][corner]]; };
    CHECK(uvAt(0, 0) == glm::vec2(0, 0));
    CHECK(uvAt(0, 2) == glm::vec2(1, 1));
    CHECK(uvAt(1, 0) == glm::vec2(0.5, 0)); // v is 0 where it is not written
    CHECK(mesh.triangles[0].z == mesh.triangles[1].y);
    CHECK(mesh.positions[mesh.triangles[1].x] == glm::vec3(0));
}

TEST_CASE("OBJ corners without texture coordinates in a mesh that has some get (0, 0)") {
    const Mesh mesh = parseObj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 1 1\n"
                               "f 1/1 2/1 3/1\nf 1 3 4\n",
                               "m.obj");
    CHECK(mesh.positions.size() == 6);
    CHECK(mesh.uvs[mesh.triangles[0].x] == glm::vec2(1, 1));
    CHECK(mesh.uvs[mesh.triangles[1].x] == glm::vec2(0, 0));
}

TEST_CASE("PLY texture coordinates are read by each of their names") {
    for (const auto& [u, v] : {std::pair{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}}) {
        const std::string header = std::string("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                               "property float y\nproperty float z\nproperty float ") +
                                   u + "\nproperty float " + v +
                                   "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
        const Mesh mesh = parsePly(header + "0 0 0 0 0.5\n1 0 0 1 2\n0 1 0 -1 0\n3 0 1 2\n", "m.ply");
        CHECK(mesh.uvs == std::vector<glm::vec2>{{0, 0.5}, {1, 2}, {-1, 0}});
        CHECK(mesh.normals.empty());
    }
}

TEST_CASE("a glTF material brings its texture from a file, a data URI or a buffer view") {
    TemporaryFolder folder;
    writeImage(folder.path() / "red and gray.png", redAndGray(), {});
    const std::string png = readFile(folder.path() / "red and gray.png");
    std::vector<Gltf> files{texturedGltf({{"uri", "red%20and%20gray.png"}}),
                            texturedGltf({{"uri", "data:image/png;base64," + encodeBase64(png)}}),
                            texturedGltf({{"mimeType", "image/png"}})};
    files[2].document["images"][0]["bufferView"] = files[2].addView(png);
    for (const Gltf& gltf : files) {
        const Scene scene = loadGltf(folder, gltf);
        const Material& material = scene.materials.at(scene.objects.at(0).material.value());
        CHECK(material.model.color == glm::dvec3(0.5, 1, 1));
        const Image& image = *std::get<ImageTexture>(scene.textures.at(material.colorTexture.value()).model).image;
        CHECK(image.at(0, 0) == glm::vec3(1, 0, 0));
        CHECK(scene.meshes.at(0).uvs.at(0) == glm::vec2(0.25, 0.75));
    }
}

TEST_CASE("a glTF texture that cannot be shown is refused, unless the object has a material of its own") {
    TemporaryFolder folder;
    Gltf gltf = texturedGltf({{"uri", "none.png"}});
    const auto messageOf = [&] {
        const auto error = errorOf([&] { loadGltf(folder, gltf); });
        REQUIRE(error.has_value());
        CHECK(error->code() == ExitCode::BadInput);
        return std::string(error->what());
    };
    CHECK_THAT(messageOf(), ContainsSubstring("no such file"));
    const auto scene =
        folder.write("own.yaml", kStart + "materials: {m: {type: mirror}}\n"
                                          "objects: [{shape: {type: mesh, file: m.gltf}, material: m}]\n");
    CHECK(loadScene(scene).textures.empty());
    json& info = gltf.document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
    info["texCoord"] = 1;
    CHECK_THAT(messageOf(),
               ContainsSubstring(
                   "textures[0]: this texture is not supported: it uses texture coordinates other than the first"));
    info = {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
    CHECK_THAT(messageOf(), ContainsSubstring("transforms the texture coordinates"));
    info = {{"index", 0}};
    gltf.document["images"][0]["uri"] = "../none.png";
    CHECK_THAT(messageOf(), ContainsSubstring("the image '../none.png' must be a file in the folder"));
}

TEST_CASE("a texture in GLSL is read with its parameters, and is named after its file") {
    TemporaryFolder folder;
    folder.write("wood.glsl", "vec3 wood(vec3 position, vec2 uv, vec4 parameters) {\n    return vec3(0.5);\n}\n");
    const Scene scene = loadWith(folder, "{type: custom, file: wood.glsl, parameters: [1, -2.5]}",
                                 "{type: diffuse, albedo: {texture: t}}");
    const auto& texture = std::get<CustomTexture>(scene.textures.at(0).model);
    CHECK(texture.code->function == "wood");
    CHECK(texture.code->file == (folder.path() / "wood.glsl").string());
    CHECK(texture.parameters == glm::dvec4(1, -2.5, 0, 0));
}

TEST_CASE("a material in GLSL is read with its parameters and its roughness") {
    TemporaryFolder folder;
    folder.write("film.glsl", "vec3 film(float cosine, vec4 parameters) {\n    return vec3(0.5);\n}\n");
    const auto scene = folder.write(
        "scene.yaml",
        "hyalite: 1\nmaterials: {m: {type: custom, file: film.glsl, parameters: [3, 2], roughness: 0.4}}\n" +
            std::string("lights: [{type: point, position: [0, 3, 0]}]\n"
                        "objects: [{shape: {type: sphere, radius: 1}, material: m}]\n"));
    const MaterialModel model = loadScene(scene).materials.at(0).model;
    CHECK(model.code->function == "film");
    CHECK(model.parameters == glm::dvec4(3, 2, 0, 0));
    CHECK(model.roughness == 0.4);
}

TEST_CASE("code of a scene must be in its folder, be named like its function and need no preprocessor") {
    TemporaryFolder folder;
    folder.write("outside.glsl", "vec3 outside(vec3 p, vec2 uv, vec4 k) { return p; }\n");
    const auto inner = folder.path() / "inner";
    folder.write("inner/none.glsl", "vec3 other(vec3 p, vec2 uv, vec4 k) { return p; }\n");
    folder.write("inner/wrong.glsl", "float wrong(vec3 p, vec2 uv, vec4 k) { return 1.0; }\n");
    folder.write("inner/takes.glsl",
                 "#include \"lights/light.glsl\"\nvec3 takes(vec3 p, vec2 uv, vec4 k) { return p; }\n");
    folder.write("inner/two words.glsl", "vec3 two(vec3 p, vec2 uv, vec4 k) { return p; }\n");
    folder.write("inner/good.txt", "vec3 good(vec3 p, vec2 uv, vec4 k) { return p; }\n");
    std::filesystem::create_symlink(folder.path() / "outside.glsl", inner / "link.glsl");
    const auto refusalOf = [&](const std::string& file) {
        const auto scene = folder.write("inner/scene.yaml", kStart + "textures: {t: {type: custom, file: \"" + file +
                                                                "\"}}\nmaterials: {m: {type: diffuse}}\n" + kObject);
        const auto error = errorOf([&] { return loadScene(scene); });
        REQUIRE(error.has_value());
        CHECK(error->code() == ExitCode::BadInput);
        return std::string(error->what());
    };
    CHECK_THAT(refusalOf("../outside.glsl"), ContainsSubstring("not in the scene file's folder"));
    CHECK_THAT(refusalOf((folder.path() / "outside.glsl").string()),
               ContainsSubstring("not in the scene file's folder"));
    CHECK_THAT(refusalOf("link.glsl"), ContainsSubstring("not in the scene file's folder"));
    CHECK_THAT(refusalOf("gone.glsl"), ContainsSubstring("no such file"));
    CHECK_THAT(refusalOf("none.glsl"), ContainsSubstring("does not define the function 'vec3 none(...)'"));
    CHECK_THAT(refusalOf("wrong.glsl"), ContainsSubstring("does not define the function 'vec3 wrong(...)'"));
    CHECK_THAT(refusalOf("takes.glsl"), ContainsSubstring("must not use #include"));
    CHECK_THAT(refusalOf("two words.glsl"), ContainsSubstring("named after the function"));
    CHECK_THAT(refusalOf("good.txt"), ContainsSubstring("named after the function"));
}
