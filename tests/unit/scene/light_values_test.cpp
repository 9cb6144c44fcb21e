// A scene file's lights arrive in the scene, including environment images.
#include "image/image_io.h"
#include "unit/scene/bad_scene.h"

using namespace hyalite;
using namespace hyalite::test;
using Catch::Matchers::ContainsSubstring;

namespace {

// A scene of these lights, beside an image if there is one.
Scene loadWithLights(const std::string& lights, const Image& image = {}) {
    TemporaryFolder folder;
    if (!image.pixels.empty()) {
        writeImage(folder.path() / "sky.exr", image, {});
    }
    return loadScene(folder.write("scene.yaml", "hyalite: 1\nmaterials: {gray: {type: diffuse}}\nlights:\n" + lights +
                                                    "objects: [{shape: {type: sphere, radius: 1}, material: gray}]\n"));
}

Image imageOf(const glm::vec3& first) {
    Image image(2, 1);
    image.at(0, 0) = first;
    image.at(1, 0) = {1, 2, 3};
    return image;
}

} // namespace

TEST_CASE("spots and directional lights have the values of the file, and their defaults") {
    const Scene scene = loadWithLights("  - {type: spot, position: [1, 2, 3], direction: [0, 0, -4], intensity: 7, "
                                       "angle: 60, blend: 0.25, photon_share: 3}\n"
                                       "  - {type: spot, position: [1, 2, 3], direction: [0, 3, 4]}\n"
                                       "  - {type: directional, direction: [0, -2, 0], irradiance: [1, 2, 3]}\n"
                                       "  - {type: directional, direction: [1, 0, 0], radius: 0.5, center: [7, 8, 9]}\n"
                                       "  - {type: directional, direction: [1, 0, 0], radius: 2}\n");
    REQUIRE(scene.spots.size() == 2);
    CHECK(scene.spots[0].position == glm::dvec3(1, 2, 3));
    CHECK(scene.spots[0].direction == glm::dvec3(0, 0, -1));
    CHECK(scene.spots[0].intensity == glm::dvec3(7));
    CHECK(scene.spots[0].angle == 60);
    CHECK(scene.spots[0].blend == 0.25);
    CHECK(scene.spots[0].photonShare == 3);
    CHECK(scene.spots[1].direction == glm::dvec3(0, 0.6, 0.8));
    CHECK(scene.spots[1].intensity == glm::dvec3(1));
    CHECK(scene.spots[1].angle == 30);
    CHECK(scene.spots[1].blend == 0.1);
    CHECK(scene.spots[1].photonShare == 1);
    REQUIRE(scene.directionals.size() == 3);
    CHECK(scene.directionals[0].direction == glm::dvec3(0, -1, 0));
    CHECK(scene.directionals[0].irradiance == glm::dvec3(1, 2, 3));
    CHECK_FALSE(scene.directionals[0].beam.has_value());
    REQUIRE(scene.directionals[1].beam.has_value());
    CHECK(scene.directionals[1].beam->center == glm::dvec3(7, 8, 9));
    CHECK(scene.directionals[1].beam->radius == 0.5);
    REQUIRE(scene.directionals[2].beam.has_value());
    CHECK(scene.directionals[2].beam->center == glm::dvec3(0));
    CHECK_FALSE(scene.environment.has_value());
}

TEST_CASE("an environment is an image beside the scene file, or one colour") {
    const Scene image =
        loadWithLights("  - {type: environment, image: sky.exr, scale: 2, rotation: -30}\n", imageOf({4, 5, 6}));
    REQUIRE(image.environment.has_value());
    CHECK(image.environment->image.width == 2);
    CHECK(image.environment->image.at(0, 0) == glm::vec3(4, 5, 6));
    CHECK(image.environment->image.at(1, 0) == glm::vec3(1, 2, 3));
    CHECK(image.environment->scale == 2);
    CHECK(image.environment->rotation == -30);
    const Scene color = loadWithLights("  - {type: environment, radiance: [0.5, 1, 2], photon_share: 0.5}\n");
    REQUIRE(color.environment.has_value());
    CHECK(color.environment->image.width == 1);
    CHECK(color.environment->image.height == 1);
    CHECK(color.environment->image.at(0, 0) == glm::vec3(0.5, 1, 2));
    CHECK(color.environment->photonShare == 0.5);
    const Scene white = loadWithLights("  - {type: environment}\n");
    REQUIRE(white.environment.has_value());
    CHECK(white.environment->image.at(0, 0) == glm::vec3(1));
}

TEST_CASE("an image that cannot be an environment is refused at its key") {
    struct Case {
        Image image;
        std::string what;
    };
    const std::string environment = "  - {type: environment, image: sky.exr}\n";
    Image black(2, 2);
    for (const Case& bad :
         {Case{imageOf({1, -1, 1}), "negative"}, Case{black, "black"}, Case{imageOf({1, 1e13F, 1}), "too bright"}}) {
        INFO(bad.what);
        const auto error = errorOf([&] { return loadWithLights(environment, bad.image); });
        REQUIRE(error.has_value());
        CHECK(error->code() == ExitCode::BadInput);
        CHECK(error->where().line == 4);
        CHECK(error->where().column == 32);
        CHECK_THAT(error->what(), ContainsSubstring(bad.what));
    }
    TemporaryFolder folder;
    folder.write("sky.exr", "no picture");
    const auto error = errorOf(
        [&] { return loadScene(folder.write("scene.yaml", "hyalite: 1\nlights:\n" + environment + "objects: []\n")); });
    REQUIRE(error.has_value());
    CHECK(error->where().line == 3);
    CHECK_THAT(error->what(), ContainsSubstring("neither a PNG nor an EXR file"));
}

TEST_CASE("meshes may emit light, each copy of them, and any emitting object may have a photon share") {
    TemporaryFolder folder;
    folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Scene scene = loadScene(
        folder.write("scene.yaml", "hyalite: 1\nobjects:\n"
                                   "  - {shape: {type: mesh, file: t.obj}, emission: [1, 2, 3], photon_share: 5, "
                                   "repeat: [{count: 3, transform: [{translate: [1, 0, 0]}]}]}\n"
                                   "  - {shape: {type: teapot, level: 1}, emission: 2}\n"));
    REQUIRE(scene.objects.size() == 4);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(scene.objects[i].emission == glm::dvec3(1, 2, 3));
        CHECK(scene.objects[i].photonShare == 5);
    }
    CHECK(scene.objects[3].emission == glm::dvec3(2));
    CHECK(scene.objects[3].photonShare == 1);
    // Three corners on a line
    checkReported({"hyalite: 1\nobjects: [{shape: {type: mesh, file: mesh.obj}, emission: $1}]\n",
                   "no area",
                   {},
                   "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"});
}
