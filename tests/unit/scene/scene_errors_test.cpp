// Every mistake in a scene file is reported with its place, what is wrong and the exit code for bad input. The place
// is the dollar sign in the text.
#include "unit/scene/bad_scene.h"

using Catch::Matchers::ContainsSubstring;
using namespace hyalite;
using namespace hyalite::test;

namespace {

// A scene with a mistake in one part.
std::string withCamera(const std::string& camera) {
    return "hyalite: 1\ncamera: " + camera +
           "\nlights: [{type: point, position: [0, 1, 0]}]\n"
           "materials: {gray: {type: diffuse}}\n"
           "objects: [{shape: {type: sphere, radius: 1}, material: gray}]\n";
}
std::string withRender(const std::string& render) {
    return "hyalite: 1\nrender: " + render +
           "\nlights: [{type: point, position: [0, 1, 0]}]\n"
           "materials: {gray: {type: diffuse}}\n"
           "objects: [{shape: {type: sphere, radius: 1}, material: gray}]\n";
}
std::string withMaterial(const std::string& material) {
    return "hyalite: 1\nlights: [{type: point, position: [0, 1, 0]}]\nmaterials:\n  m: " + material +
           "\nobjects: [{shape: {type: sphere, radius: 1}, material: m}]\n";
}
std::string withLight(const std::string& light) {
    return "hyalite: 1\nmaterials: {gray: {type: diffuse}}\nlights:\n  - " + light +
           "\nobjects: [{shape: {type: sphere, radius: 1}, material: gray}]\n";
}

} // namespace

TEST_CASE("a missing scene file, a folder and an empty file are bad input") {
    TemporaryFolder folder;
    const auto empty = folder.write("empty.yaml", "");
    struct Case {
        std::filesystem::path file;
        std::string what;
    };
    for (const Case& bad : {Case{folder.path() / "none.yaml", "no such file"}, Case{folder.path(), "it is a folder"},
                            Case{empty, "the file is empty"}, Case{"/dev/null", "not a regular file"}}) {
        const auto error = errorOf([&] { return loadScene(bad.file); });
        REQUIRE(error.has_value());
        CHECK(error->code() == ExitCode::BadInput);
        CHECK_THAT(error->what(), ContainsSubstring(bad.file.string()) && ContainsSubstring(bad.what));
    }
}

TEST_CASE("the scene of the error tests is valid without its mistake") {
    TemporaryFolder folder;
    for (const std::string& text : {withCamera("{fov: 30}"), withRender("{passes: 3}"), withMaterial("{type: mirror}"),
                                    withLight("{type: point, position: [0, 1, 0]}"),
                                    withObject("{shape: {type: sphere, radius: 1}, material: gray}")}) {
        CHECK(loadScene(folder.write("scene.yaml", text)).objects.size() == 1);
    }
}

TEST_CASE("mistakes of YAML itself are reported with line and column") {
    checkAll({
        {"# only a comment\n", "contains no values"},
        // The text "30 objects" runs over the line; then a colon is out of place.
        {"hyalite: 1\ncamera: {fov: 30\nobjects$: []\n", "YAML"},
        {"hyalite: 1\nobjects: [&a [$*a]]\n", "alias is inside the value"},
        {"hyalite: 1\nobjects: &a [$*a]\n", "alias is inside the value"},
        {"hyalite: 1\nobjects: [$*nobody]\n", "YAML"},
        {"hyalite: 1\n$hyalite: 1\nobjects: []\n", "duplicate key 'hyalite'", "first in line 1"},
        {withMaterial("{type: diffuse, albedo: 0.5, $albedo: 0.6}"), "duplicate key 'albedo'"},
        {"hyalite: 1\nmaterials:\n  a: {type: mirror}\n  $a: {type: diffuse}\n", "duplicate key 'a'"},
        {"hyalite: 1\n$[a, b]: 2\n", "a key must be text"},
        {"hyalite: 1\ncamera: {fov: $!degrees 30}\n", "tag '!degrees'"},
        {"hyalite: 1\nobjects: []\n$---\nhyalite: 1\n", "second document"},
        {"$just words\n", "must be a map"},
        {"$[1, 2, 3]\n", "must be a map"},
    });
}

TEST_CASE("a scene needs its version, its objects and a light") {
    checkAll({
        {"$objects: []\n", "missing key 'hyalite'"},
        {"hyalite: $2\nobjects: []\n", "unknown version", "hyalite: 1"},
        {"hyalite: $one\nobjects: []\n", "unknown version"},
        {"$hyalite: 1\n", "missing key 'objects'"},
        {"hyalite: 1\n$objetcs: []\n", "unknown key 'objetcs'", "did you mean 'objects'?"},
        {"hyalite: 1\nobjects: $[]\n", "no objects"},
        {"hyalite: 1\n$objects:\n", "'objects' must be a list, found nothing"},
        {"hyalite: 1\nobjects: []\n$light: []\n", "unknown key 'light'", "did you mean 'lights'?"},
        {"$hyalite: 1\nmaterials: {m: {type: mirror}}\n"
         "objects: [{shape: {type: sphere, radius: 1}, material: m}]\n",
         "the scene has no light", "emission"},
        {"$hyalite: 1\nobjects: [{shape: {type: quad, corner: [0,0,0], edges: [[1,0,0], [0,1,0]]}, emission: 0}]\n",
         "the scene has no light"},
    });
}

TEST_CASE("mistakes in the camera are reported at the key") {
    checkAll({
        {withCamera("$12"), "'camera' must be a map"},
        {withCamera("{$feild: 3}"), "unknown key 'feild' in 'camera'",
         "known: position, look_at, up, fov, aperture, focus_distance, resolution"},
        {withCamera("{$fow: 3}"), "unknown key 'fow'", "did you mean 'fov'?"},
        {withCamera("{fov: $wide}"), "'fov' must be a number, found the text 'wide'"},
        {withCamera("{fov: $\"39\"}"), "found the text '39'"},
        {withCamera("{fov: $[39]}"), "found a list of 1"},
        {withCamera("{fov: $0}"), "'fov' must be in (0, 180) degrees, found 0"},
        {withCamera("{fov: $180}"), "'fov' must be in (0, 180) degrees, found 180"},
        {withCamera("{fov: $.nan}"), "'fov' must be a finite number"},
        {withCamera("{fov: $nan}"), "'fov' must be a finite number"},
        {withCamera("{fov: $-.inf}"), "'fov' must be a finite number"},
        {withCamera("{fov: $1e999}"), "'fov' must be a finite number"},
        {withCamera("{resolution: [$0, 512]}"), "'resolution' must be in [1, 65536] pixels, found 0"},
        {withCamera("{resolution: [512, $-4]}"), "found -4"},
        {withCamera("{resolution: [512, $65537]}"), "found 65537"},
        {withCamera("{resolution: [512, $2.5]}"), "a whole number in [1, 65536] pixels, found 2.5"},
        {withCamera("{resolution: [$99999999999999999999, 1]}"), "a whole number"},
        {withCamera("{resolution: $[16385, 16384]}"), "more than 268435456 pixels"}, // 2^28 + 16384
        {withCamera("{resolution: $[512]}"), "a list of 2 numbers, found a list of 1"},
        {withCamera("{position: $[0, 1]}"), "a list of 3 numbers, found a list of 2"},
        {withCamera("{position: [0, 1, $up]}"), "must be a number"},
        {withCamera("{position: [0, $1e10, 0]}"), "[-1e+09, 1e+09] m"},
        {withCamera("{position: [1, 2, 3], look_at: $[1, 2, 3]}"), "same point"},
        {withCamera("${position: [0, 0, 0]}"), "same point"}, // the default look_at is the origin
        {withCamera("{position: [0, 5, 0], up: $[0, -2, 0]}"), "parallel"},
        {withCamera("${position: [0, 5, 0]}"), "parallel"}, // the default up is +y
        {withCamera("{up: $[0, 0, 0]}"), "'up' is zero"},
    });
}

TEST_CASE("mistakes in the render settings are reported at the key") {
    checkAll({
        {withRender("{integrator: $pmm}"), "unknown integrator 'pmm'", "did you mean 'ppm'?"},
        {withRender("{integrator: $[ppm]}"), "'integrator' must be text"},
        {withRender("{passes: $0}"), "'passes' must be in [1, 4294967295], found 0"},
        {withRender("{passes: $4294967296}"), "found 4294967296"},
        {withRender("{photons: $0}"), "'photons' must be in [1, 16777216], found 0"},
        {withRender("{photons: $16777217}"), "found 16777217"}, // 2^24 + 1
        {withRender("{photons: $1e5}"), "a whole number"},
        {withRender("{max_depth: $0}"), "with integrator ppm 'max_depth' must be in [1, 255], it is 0"},
        {withRender("{max_depth: $256}"), "found 256"},
        {withRender("{integrator: whitted, max_depth: $255}"),
         "with integrator whitted 'max_depth' must be in [0, 254], it is 255"},
        {withRender("{max_depth: $-1}"), "found -1"},
        {withRender("{seed: $-1}"), "'seed' must be in [0, 4294967295]"},
        {withRender("{alpha: $0}"), "'alpha' must be in (0, 1), found 0"},
        {withRender("{alpha: $1}"), "'alpha' must be in (0, 1), found 1"},
        {withRender("{radius: $-0.1}"), "'radius' must be 0 or in [1e-09, 1e+09] m, found -0.1"},
        {withRender("{radius: $1e-30}"), "'radius' must be 0 or in [1e-09, 1e+09] m, found 1e-30"},
        {withRender("{min_weight: $1.5}"), "'min_weight' must be in [0, 1]"},
        {withRender("{$photon: 1}"), "unknown key 'photon'", "did you mean 'photons'?"},
    });
}

TEST_CASE("mistakes in materials and lights are reported at the key") {
    checkAll({
        {withMaterial("${albedo: 0.5}"), "missing key 'type' in 'm'"},
        {withMaterial("{type: $difuse}"), "unknown material type 'difuse'", "did you mean 'diffuse'?"},
        {withMaterial("{type: $velvet}"), "unknown material type 'velvet'",
         "known: diffuse, mirror, dielectric, conductor, metallic_roughness"},
        {withMaterial("{type: diffuse, albedo: $1.01}"), "'albedo' must be in [0, 1], found 1.01"},
        {withMaterial("{type: diffuse, albedo: [0.5, $-0.1, 0]}"), "found -0.1"},
        {withMaterial("{type: diffuse, albedo: $[0.5, 0.5]}"), "one number or a list of 3 numbers"},
        {withMaterial("{type: diffuse, $reflectance: 0.5}"), "unknown key 'reflectance' in 'm'"},
        {withMaterial("{type: mirror, reflectance: $2}"), "found 2"},
        {withMaterial("{type: dielectric, ior: $0}"), "'ior' must be in [0.01, 100], found 0"},
        {withMaterial("{type: dielectric, ior: $-1.5}"), "found -1.5"},
        {withMaterial("{type: dielectric, roughness: $1.5}"), "'roughness' must be in [0, 1], found 1.5"},
        {withMaterial("{type: conductor, metal: $glod}"), "unknown metal 'glod'", "did you mean 'gold'?"},
        {withMaterial("${type: conductor}"), "a conductor needs a 'metal', or 'eta' and 'k'", "metal: gold"},
        {withMaterial("${type: conductor, eta: 1.5}"), "a conductor needs a 'metal', or 'eta' and 'k'"},
        {withMaterial("{type: conductor, metal: gold, k: $3}"), "'metal' and 'k' exclude each other"},
        {withMaterial("{type: conductor, eta: $0, k: 1}"), "'eta' must be in [0.01, 100], found 0"},
        {withMaterial("{type: conductor, eta: 1, k: [1, $-1, 1]}"), "'k' must be in [0, 100], found -1"},
        {withMaterial("{type: metallic_roughness, metallic: $2}"), "'metallic' must be in [0, 1], found 2"},
        {withMaterial("{type: metallic_roughness, base_color: $-1}"), "found -1"},
        {withMaterial("{type: metallic_roughness, $albedo: 0.5}"), "unknown key 'albedo'"},
        {withMaterial("$diffuse"), "must be a map of keys"},
        {"hyalite: 1\nmaterials:\n  $m:\nobjects: []\n", "'m' must be a map of keys, found nothing"},
        {withLight("{type: $pont, position: [0, 1, 0]}"), "unknown light type 'pont'", "did you mean 'point'?"},
        {withLight("${type: point}"), "missing key 'position' in 'light'"},
        {withLight("{type: point, position: [0, 1, 0], intensity: [1, $-1, 1]}"), "W/sr, found -1"},
        {withLight("{type: point, position: [0, 1, 0], intensity: $0}"), "this light emits nothing"},
        {withLight("{type: point, position: [0, 1, 0], $power: 5}"), "unknown key 'power'"},
        {withLight("{type: point, position: [0, 1, 0], photon_share: $0}"), "'photon_share' must be in [0.001, 1000]"},
        {withLight("${type: spot, position: [0, 1, 0]}"), "missing key 'direction' in 'light'"},
        {withLight("{type: spot, position: [0, 1, 0], direction: $[0, 0, 0]}"), "'direction' must not be zero"},
        {withLight("{type: spot, position: [0, 1, 0], direction: [0, 1, 0], angle: $0}"), "degrees, found 0"},
        {withLight("{type: spot, position: [0, 1, 0], direction: [0, 1, 0], blend: $2}"), "in [0, 1], found 2"},
        {withLight("{type: spot, position: [0, 1, 0], direction: [0, 1, 0], intensity: $0}"),
         "this light emits nothing"},
        {withLight("{type: directional, direction: [0, 1, 0], center: $[0, 0, 0]}"), "'center' needs a 'radius'",
         "beam"},
        {withLight("{type: directional, direction: [0, 1, 0], radius: $0}"), "'radius' must be in [1e-09, 1e+09] m"},
        {withLight("{type: directional, direction: [0, 1, 0], irradiance: $0}"), "this light emits nothing"},
        {withLight("{type: environment}\n  - ${type: environment}"), "a scene has at most one environment",
         "remove this one"},
        {withLight("{type: environment, image: a.exr, radiance: $1}"), "'image' and 'radiance' exclude each other"},
        {withLight("{type: environment, radiance: $0}"), "this light emits nothing"},
        {withLight("{type: environment, scale: $0}"), "this light emits nothing"},
        {withLight("${type: environment, scale: 1e10, radiance: 1e10}"), "too bright"},
        {withLight("{type: environment, image: $none.exr}"), "none.exr: "},
        {"hyalite: 1\nlights: ${type: point}\nobjects: []\n", "'lights' must be a list, found a map"},
    });
}

TEST_CASE("mistakes in objects are reported at the key") {
    checkAll({
        {withObject("${material: gray}"), "missing key 'shape' in 'object'"},
        {withObject("{shape: {type: sphere, radius: 1}, material: $grey}"), "unknown material 'grey'",
         "did you mean 'gray'?"},
        {withObject("${shape: {type: sphere, radius: 1}}"), "neither a material nor an emission"},
        {withObject("{shape: {type: $shpere, radius: 1}, material: gray}"), "unknown shape 'shpere'",
         "did you mean 'sphere'?"},
        {withObject("{shape: ${type: sphere}, material: gray}"), "missing key 'radius' in 'shape'"},
        {withObject("{shape: {type: sphere, $raduis: 1}, material: gray}"), "unknown key 'raduis'",
         "did you mean 'radius'?"},
        {withObject("{shape: {type: sphere, radius: $-1}, material: gray}"), "'radius' must be in [1e-09, 1e+09] m"},
        {withObject("{shape: {type: sphere, radius: $0}, material: gray}"), "'radius' must be"},
        {withObject("{shape: {type: sphere, radius: 1, center: [0, $.nan, 0]}, material: gray}"), "finite"},
        {withObject("{shape: {type: box, min: [0, 0, 0], max: [1, 1, 1]}, emission: $1}"),
         "only quads, disks, spheres and meshes"},
        {withObject("{shape: {type: sphere, radius: 1}, material: gray, $emision: 1}"), "unknown key 'emision'",
         "did you mean 'emission'?"},
        {withObject("{shape: ${type: quad, edges: [[1,0,0],[0,1,0]]}, material: gray}"), "missing key 'corner'"},
        {withObject("{shape: {type: quad, corner: [0,0,0], edges: $[[1,0,0]]}, material: gray}"),
         "'edges' must be a list of 2, found a list of 1"},
        {withObject("{shape: {type: quad, corner: [0,0,0], edges: [[1,0,0], $[0,1]]}, material: gray}"),
         "a list of 3 numbers"},
        {withObject("{shape: {type: quad, corner: [0,0,0], edges: $[[1,0,0], [0,0,0]]}, material: gray}"),
         "an edge of this quad has no length"},
        {withObject("{shape: {type: quad, corner: [0,0,0], edges: $[[1,2,0], [-2,-4,0]]}, material: gray}"),
         "the edges of this quad are parallel"},
        {withObject("{shape: {type: quad, corner: [0,0,0], edges: [[1,0,0],[0,1,0]]}, emission: $-1}"), "found -1"},
        {withObject("{shape: {type: mesh, file: $none.obj}, material: gray}"), "no such file"},
        {withObject("{shape: {type: mesh, file: $.}, material: gray}"), "unknown mesh format"},
        {withObject("{shape: {type: mesh, file: $teapot.fbx}, material: gray}"), "unknown mesh format '.fbx'"},
        {withObject("{shape: {type: mesh, file: $''}, material: gray}"), "'file' must be text"},
        {withObject("{shape: ${type: mesh}, material: gray}"), "missing key 'file'"},
    });
}

TEST_CASE("mistakes in transforms are reported at the map") {
    const auto sphere = [](const std::string& transform) {
        return withObject("{shape: {type: sphere, radius: 1}, material: gray, transform: " + transform + "}");
    };
    checkAll({
        {sphere("${scale: 2}"), "'transform' must be a list, found a map"},
        {sphere("[$scale]"), "must be a map of keys"},
        {sphere("[{$scael: 2}]"), "unknown key 'scael'", "did you mean 'scale'?"},
        {sphere("[${scale: 2, translate: [0, 0, 1]}]"), "each item of 'transform' holds one key, found 2"},
        {sphere("[${}]"), "empty"},
        {sphere("[{scale: $0}]"), "singular"},
        {sphere("[{scale: $[1, 0, 1]}]"), "singular"},
        {sphere("$[{scale: 1e-8}, {scale: 1e-8}]"), "singular"},
        {sphere("$[{scale: 1e8}, {scale: 1e8}]"), "singular"},
        {sphere("[{rotate: {axis: $[0, 0, 0], degrees: 3}}]"), "axis of a rotation must not be zero"},
        {sphere("[{rotate: ${axis: [0, 0, 1]}}]"), "missing key 'degrees'"},
        {sphere("[{rotate: {axis: [0, 0, 1], degrees: 3, $angle: 2}}]"), "unknown key 'angle'"},
        {sphere("[{translate: $[0, 0]}]"), "a list of 3 numbers"},
        {sphere("[{matrix: $[1, 0, 0]}]"), "a list of 16 numbers, found a list of 3"},
        // Rows 0 and 1 alike.
        {sphere("[{matrix: $[1,0,0,0, 1,0,0,0, 0,0,1,0, 0,0,0,1]}]"), "singular"},
        {sphere("[{matrix: $[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,1,1]}]"), "the last row"},
        {withObject("{shape: ${type: sphere, radius: 1, center: [9e8, 0, 0]}, material: gray, "
                    "transform: [{translate: [9e8, 0, 0]}]}"),
         "extends beyond 1e+09 m"},
    });
}

TEST_CASE("the example of the design document names file, line and column") {
    // Twelve lines; the object's material stands in column 15 of the last.
    const std::string text = "hyalite: 1\n"
                             "lights:\n"
                             "  - {type: point, position: [0, 1, 0]}\n"
                             "materials:\n"
                             "  white: {type: diffuse}\n"
                             "  glass: {type: dielectric}\n"
                             "objects:\n"
                             "  - shape:\n"
                             "      type: sphere\n"
                             "      radius: 1\n"
                             "      center: [0, 0, 0]\n"
                             "    material: glas\n";
    TemporaryFolder folder;
    const auto file = folder.write("scene.yaml", text);
    const auto error = errorOf([&] { return loadScene(file); });
    REQUIRE(error.has_value());
    CHECK(error->what() == file.string() + ":12:15: unknown material 'glas' (did you mean 'glass'?)");
}

TEST_CASE("deep nesting and aliases that multiply are refused at once") {
    TemporaryFolder folder;
    const auto message = [&](const std::string& text) {
        const auto error = errorOf([&] { return loadScene(folder.write("scene.yaml", text)); });
        return error ? std::string(error->what()) : std::string("no error");
    };
    // 128 levels are allowed: the outer map, the list `objects` and 126 more lists.
    CHECK_THAT(message("hyalite: 1\nobjects: " + std::string(127, '[') + std::string(127, ']') + "\n"),
               ContainsSubstring("must be a map"));
    CHECK_THAT(message("hyalite: 1\nobjects: " + std::string(128, '[') + std::string(128, ']') + "\n"),
               ContainsSubstring("nested more than 128 deep"));
    CHECK_THAT(message(std::string(200000, '[')), ContainsSubstring("nested more than 128 deep"));
    std::string dashes = "hyalite: 1\nobjects:\n";
    for (int i = 0; i < 5000; ++i) {
        dashes += "- ";
    }
    CHECK_THAT(message(dashes), ContainsSubstring("nested more than 128 deep"));

    // Ten aliases of ten of ten ...: ten levels stand for 10^10 values.
    std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int level = 1; level < 10; ++level) {
        const std::string below = "*a" + std::to_string(level - 1);
        bomb += 'a' + std::to_string(level) + ": &a" + std::to_string(level) + " [" + below;
        for (int i = 1; i < 10; ++i) {
            bomb += ", " + below;
        }
        bomb += "]\n";
    }
    CHECK_THAT(message(bomb), ContainsSubstring("more than 8388608 values"));

    // Depth counts through aliases too: 80 lists around an alias of 80 lists.
    CHECK_THAT(message("a: &a " + std::string(80, '[') + std::string(80, ']') + "\nb: " + std::string(80, '[') + "*a" +
                       std::string(80, ']') + "\n"),
               ContainsSubstring("nested more than 128 deep"));
}
