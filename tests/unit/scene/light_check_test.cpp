// Lights that no path reaches, and caustics that path and whitted leave out; also what is no reason for a warning.
#include "scene/checks/light_check.h"
#include "scene/yaml/settings.h"
#include "unit/scene/scene_test_support.h"

#include <catch2/matchers/catch_matchers_string.hpp>

using namespace hyalite;
using namespace hyalite::test;

namespace {

constexpr std::string_view kRoom = // open towards +z, 4 m wide
    "  - {shape: {type: quad, corner: [-2, -2, -2], edges: [[4, 0, 0], [0, 4, 0]]}, material: w}\n"
    "  - {shape: {type: quad, corner: [-2, -2, -2], edges: [[0, 0, 4], [4, 0, 0]]}, material: w}\n"
    "  - {shape: {type: quad, corner: [-2, 2, -2], edges: [[4, 0, 0], [0, 0, 4]]}, material: w}\n"
    "  - {shape: {type: quad, corner: [-2, -2, -2], edges: [[0, 4, 0], [0, 0, 4]]}, material: w}\n"
    "  - {shape: {type: quad, corner: [2, -2, -2], edges: [[0, 0, 4], [0, 4, 0]]}, material: w}\n";

std::vector<Warning> warningsOf(const std::string& lights, const std::string& objects,
                                const std::string& integrator = "ppm") {
    TemporaryFolder folder;
    Scene scene = loadScene(
        folder.write("scene.yaml", "hyalite: 1\ncamera: {position: [0, 0, 9]}\nlights:\n" + lights +
                                       "materials: {w: {type: diffuse}, m: {type: mirror}, g: {type: dielectric}, "
                                       "r: {type: dielectric, roughness: 0.3}, n: {type: dielectric, ior: 1}}\n"
                                       "objects:\n" +
                                       objects));
    scene.render.integrator = integrator;
    std::vector<Warning> warnings = checks::lightWarnings(scene);
    for (const Warning& warning : warnings) {
        UNSCOPED_INFO(warning.text());
    }
    return warnings;
}

std::string point(const std::string& position) {
    return "  - {type: point, position: " + position + "}\n";
}

void checkUnseen(const std::string& light, const std::string& objects, const std::string& words) {
    INFO(light);
    const auto warnings = warningsOf(light, objects);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].kind == WarningKind::UnseenLight);
    CHECK(warnings[0].where.line == 4);
    CHECK_THAT(warnings[0].what, Catch::Matchers::ContainsSubstring(words));
}

} // namespace

TEST_CASE("lights in solids, behind walls, and turned away from everything are reported") {
    const std::string room(kRoom);
    const std::string box = "  - {shape: {type: box, min: [-1, -1, -1], max: [1, 1, 1]}, material: w}\n";
    checkUnseen(point("[0, 0, 0]"), room + box, "reaches what the camera sees");
    checkUnseen("  - {type: spot, position: [0, 0, 5], direction: [0, 0, 1]}\n", room, "meets a surface");
    checkUnseen("  - {type: spot, position: [0, 0, -3], direction: [0, 0, -1]}\n", room, "meets a surface");
    checkUnseen("  - {type: directional, direction: [0, -1, 0], center: [9, 0, 0], radius: 1}\n", room,
                "meets a surface");
    checkUnseen(point("[0, -5, 0]"),
                "  - {shape: {type: plane, point: [0, -3, 0], normal: [0, 1, 0]}, material: w}\n" + room,
                "reaches what the camera sees");
}

TEST_CASE("lights that reach the picture in a roundabout way are not reported") {
    const std::string room(kRoom);
    // Over a wall, through a gap, through glass, in a mirror's view
    CHECK(warningsOf(point("[0, 0, 0]"), room).empty());
    CHECK(warningsOf(point("[0, 0, -1.5]"),
                     room + "  - {shape: {type: box, min: [-1.9, -1.9, -1], max: [1.9, 1.9, -0.9]}, material: w}\n")
              .empty());
    CHECK(warningsOf(point("[0, 0, 0]"), room + "  - {shape: {type: sphere, radius: 1}, material: g}\n").empty());
    CHECK(warningsOf(point("[0, 0, 0]"), room + "  - {shape: {type: sphere, radius: 1}, material: r}\n").empty());
    CHECK(warningsOf("  - {type: environment, radiance: 1}\n", room).empty());
    CHECK(warningsOf("  - {type: directional, direction: [0, 0, -1]}\n", room).empty());
    CHECK(warningsOf(point("[0, 0, 0]"), room + "  - {shape: {type: sphere, center: [0, 0, 4], radius: 0.1}, "
                                                "emission: 1}\n")
              .empty());
}

TEST_CASE("an emitter that faces away from all surfaces but is in the picture is not reported") {
    CHECK(warningsOf(point("[0, 0, 0]"), std::string(kRoom) +
                                             "  - {shape: {type: quad, corner: [0, 0, 5], edges: [[1, 0, 0], "
                                             "[0, 1, 0]]}, emission: 1}\n")
              .empty());
}

TEST_CASE("path leaves out the caustics of lights without a surface, whitted all, the others none") {
    const std::string glass = std::string(kRoom) + "  - {shape: {type: sphere, radius: 0.5}, material: g}\n";
    const std::string sun = "  - {type: directional, direction: [0, -1, -1]}\n";
    for (const std::string& light : {point("[0, 1.5, 0]"), sun}) {
        INFO(light);
        for (const std::string integrator : {"path", "whitted"}) {
            const auto warnings = warningsOf(light, glass, integrator);
            REQUIRE(warnings.size() == 1);
            CHECK(warnings[0].kind == WarningKind::UnseenCaustic);
            CHECK(warnings[0].where.line == 4);
            CHECK_THAT(warnings[0].what, Catch::Matchers::ContainsSubstring("the glass 'g' (the object at line 12"));
        }
        for (const std::string integrator : {"ppm", "photonmap"}) {
            CHECK(warningsOf(light, glass, integrator).empty());
        }
    }
    const std::string area = "  - {type: environment, radiance: 1}\n";
    CHECK(warningsOf(area, glass, "path").empty());
    CHECK(warningsOf(area, glass, "whitted").size() == 1);
}

TEST_CASE("rough and index-matched glass, and mirrors that send no light to diffuse surfaces, make no caustic") {
    const std::string room(kRoom);
    const auto ball = [&](const std::string& material) {
        return warningsOf(point("[0, 1.5, 0]"),
                          room + "  - {shape: {type: sphere, radius: 0.5}, material: " + material + "}\n", "path");
    };
    CHECK(ball("m").size() == 1);
    CHECK(ball("r").empty());
    CHECK(ball("n").empty());
    CHECK(ball("w").empty());
    // The mirror looks away from the room
    CHECK(warningsOf(point("[0, 0, 0]"),
                     room + "  - {shape: {type: plane, point: [0, 0, 20], normal: [0, 0, 1]}, material: w}\n", "path")
              .empty());
}

TEST_CASE("no shipped scene gives a warning that it does not accept") {
    std::size_t scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kSourceFolder / "scenes")) {
        if (entry.path().extension() == ".yaml") {
            ++scenes;
            const Scene scene = loadScene(entry.path());
            for (const std::vector<Warning>& warnings : {scene.warnings, checks::lightWarnings(scene)}) {
                for (const Warning& warning : warnings) {
                    UNSCOPED_INFO(warning.text());
                }
                CHECK(warnings.empty());
            }
        }
    }
    CHECK(scenes > 20);
}
