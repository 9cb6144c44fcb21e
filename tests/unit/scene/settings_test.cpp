// Settings from the command line go through the scene file's readers: same keys, same ranges, errors that name the
// option.
#include "unit/scene/scene_test_support.h"

#include "scene/yaml/settings.h"
#include "scene/yaml/settings_table.h"

#include <algorithm>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <set>

using Catch::Matchers::ContainsSubstring;
using namespace hyalite;
using namespace hyalite::test;

TEST_CASE("every setting changes what it names and nothing else") {
    Scene scene;
    applySetting(scene, "render.integrator", "whitted");
    applySetting(scene, "render.max_depth", "0");
    applySetting(scene, "render.passes", "7");
    applySetting(scene, "render.photons", "16777216");
    applySetting(scene, "render.seed", "0");
    applySetting(scene, "render.sampler", "independent");
    applySetting(scene, "render.target_error", "0.03");
    applySetting(scene, "render.radius", "0.25");
    applySetting(scene, "render.alpha", "0.5");
    applySetting(scene, "render.min_weight", "0");
    applySetting(scene, "camera.fov", "20");
    applySetting(scene, "camera.aperture", "0.05");
    applySetting(scene, "camera.focus_distance", "2.5");
    applySetting(scene, "camera.position", "[1, 2, 3]");
    applySetting(scene, "camera.look_at", "[4, 5, 6]");
    applySetting(scene, "camera.up", "[0, 0, 1]");
    CHECK(scene.render.integrator == "whitted");
    CHECK(scene.render.maxDepth == 0);
    CHECK(scene.render.passes == 7);
    CHECK(scene.render.photons == 16777216);
    CHECK(scene.render.seed == 0);
    CHECK(scene.render.sampler == RandomNumbers::Independent);
    CHECK(scene.render.targetError == 0.03);
    CHECK(scene.render.radius == 0.25);
    CHECK(scene.render.alpha == 0.5);
    CHECK(scene.render.minWeight == 0);
    CHECK(scene.camera.fov == 20);
    CHECK(scene.camera.aperture == 0.05);
    CHECK(scene.camera.focusDistance == 2.5);
    CHECK(scene.camera.position == glm::dvec3(1, 2, 3));
    CHECK(scene.camera.lookAt == glm::dvec3(4, 5, 6));
    CHECK(scene.camera.up == glm::dvec3(0, 0, 1));
    CHECK(scene.camera.resolution == glm::uvec2(512, 512));
}

TEST_CASE("a resolution is written 640x480 or as a list") {
    Scene scene;
    applySetting(scene, "camera.resolution", "640x480");
    CHECK(scene.camera.resolution == glm::uvec2(640, 480));
    applySetting(scene, "camera.resolution", "[32, 16]");
    CHECK(scene.camera.resolution == glm::uvec2(32, 16));
}

TEST_CASE("a wrong setting names the option and leaves the scene as it was") {
    struct Case {
        std::string key;
        std::string value;
        std::string what;
    };
    const std::vector<Case> cases{
        {"render.photons", "0", "--set: 'photons' must be in [1, 16777216], found 0"},
        {"render.photons", "many", "--set: 'photons' must be a whole number"},
        {"render.photon", "1", "--set: unknown key 'photon' in 'render' (did you mean 'photons'?)"},
        {"redner.photons", "1", "--set: unknown setting 'redner.photons' (did you mean 'render'?)"},
        {"render", "{photons: 1}", "--set: 'render' is a group of settings"},
        {"", "1", "--set: unknown setting ''"},
        {"render.", "1", "--set: unknown key ''"},
        {"camera.resolution", "0x10", "--set: 'resolution' must be in [1, 65536] pixels, found 0"},
        {"camera.resolution", "512x", "--set: 'resolution' must be a list of 2 numbers, found the text '512x'"},
        {"camera.resolution", "65536x65536", "--set: more than 268435456 pixels"},
        {"camera.aperture", "-0.1", "--set: 'aperture' must be in [0, 1e+09] m"},
        {"camera.focus_distance", "0", "--set: 'focus_distance' must be in [1e-09, 1e+09] m"},
        {"camera.fov", "180", "--set: 'fov' must be in (0, 180) degrees"},
        {"camera.fov", "", "--set: contains no values"},
        {"camera.fov", "[1", "--set: YAML"},
        {"camera.up", "[0, 0, 1]", "--set: 'up' is parallel"}, // the default camera looks along -z
        {"camera.look_at", "[0, 0, 5]", "same point"},
        {"render.integrator", "wihtted", "--set: unknown integrator 'wihtted' (did you mean 'whitted'?)"},
        {"render.sampler", "random", "--set: unknown sampler 'random'"},
        {"render.target_error", "-0.1", "--set: 'target_error' must be in [0, 1e+09]"},
        {"render.target_error", "small", "--set: 'target_error' must be a number"},
        {"render.max_depth", "256", "--set: 'max_depth' must be in [0, 255], found 256"},
        {"render.max_depth", "0", "--set: with integrator ppm 'max_depth' must be in [1, 255], it is 0"},
        {"render.radius", "1e-30", "--set: 'radius' must be 0 or in [1e-09, 1e+09] m, found 1e-30"},
        {"render.filter", "custom", "--set: a custom filter needs a 'filter_file'"},
    };
    for (const Case& bad : cases) {
        INFO(bad.key << '=' << bad.value);
        Scene scene;
        const auto error = errorOf([&] { applySetting(scene, bad.key, bad.value); });
        REQUIRE(error.has_value());
        CHECK_THAT(error->what(), ContainsSubstring(bad.what));
        CHECK(error->code() == ExitCode::WrongUsage);
        CHECK(error->where().file == "--set");
        CHECK(error->where().line == 0);
        CHECK(scene.render.photons == 200000);
        CHECK(scene.render.maxDepth == 12);
        CHECK(scene.camera.fov == 45);
        CHECK(scene.camera.resolution == glm::uvec2(512, 512));
        CHECK(scene.camera.up == glm::dvec3(0, 1, 0));
    }
}

TEST_CASE("an integrator that does not allow the current depth is refused") {
    Scene scene;
    applySetting(scene, "render.max_depth", "255");
    const auto error = errorOf([&] { applySetting(scene, "render.integrator", "whitted", "--integrator"); });
    REQUIRE(error.has_value());
    CHECK(std::string(error->what()) == "--integrator: with integrator whitted 'max_depth' must be in [0, 254], it is "
                                        "255 (change render.max_depth or render.integrator)");
}

TEST_CASE("settings that need one another are assigned in any order") {
    const SettingAssignment whitted{"render.integrator", "whitted"};
    const SettingAssignment depth{"render.max_depth", "0"};
    const SettingAssignment up{"camera.up", "[0, 0, 1]"}; // parallel to the default view
    const SettingAssignment position{"camera.position", "[5, 0, 0]"};
    const std::vector<std::vector<SettingAssignment>> orders{
        {whitted, depth, up, position}, {depth, whitted, position, up}, {up, depth, position, whitted}};
    for (const auto& order : orders) {
        Scene scene;
        applySettings(scene, order);
        CHECK(scene.render.integrator == "whitted");
        CHECK(scene.render.maxDepth == 0);
        CHECK(scene.camera.up == glm::dvec3(0, 0, 1));
    }
}

TEST_CASE("of several assignments to one setting the last counts") {
    Scene scene;
    const std::vector<SettingAssignment> twice{{"render.photons", "5", "--photons"}, {"render.photons", "7"}};
    applySettings(scene, twice);
    CHECK(scene.render.photons == 7);
}

TEST_CASE("a conflict between settings names the option of the faulty one") {
    Scene scene;
    const std::vector<SettingAssignment> bad{{"render.integrator", "whitted", "--integrator"},
                                             {"render.seed", "3", "--seed"},
                                             {"render.max_depth", "255", "--max-depth"}};
    const auto error = errorOf([&] { applySettings(scene, bad); });
    REQUIRE(error.has_value());
    CHECK(error->where().file == "--max-depth");
    CHECK(scene.render.seed == 1); // nothing is assigned
}

TEST_CASE("every setting reads back the text that it writes") {
    const Settings defaults;
    for (const Setting& setting : settingsTable()) {
        const std::string text = setting.text(defaults);
        INFO(dottedName(setting) << ": " << text);
        // No file by default; and 0 stands for the distance of look_at, but is no distance that a scene may give
        if (setting.doc.name == "filter_file" || setting.doc.name == "focus_distance") {
            continue;
        }
        Scene scene;
        applySetting(scene, dottedName(setting), text);
        CHECK(setting.text({scene.camera, scene.render}) == text);
    }
}

TEST_CASE("no two settings have the same name, option or label") {
    std::set<std::string> seen;
    for (const Setting& setting : settingsTable()) {
        INFO(dottedName(setting));
        CHECK(seen.insert(dottedName(setting)).second);
        CHECK((setting.option.empty() || seen.insert(std::string(setting.option)).second));
        CHECK((setting.label.empty() || seen.insert(std::string(setting.label)).second));
        CHECK(!setting.doc.text.empty());
    }
}

TEST_CASE("the depths of each integrator are within the range of the key") {
    const auto table = settingsTable();
    const auto row = std::ranges::find(table, std::string("render.max_depth"), dottedName);
    REQUIRE(row != table.end());
    for (const IntegratorRow& integrator : kIntegrators) {
        CHECK(row->doc.range.contains(depthRange(integrator).low));
        CHECK(row->doc.range.contains(depthRange(integrator).high));
    }
}

TEST_CASE("the integrators' rows name only settings of the table") {
    std::set<std::string> names;
    for (const Setting& setting : settingsTable()) {
        names.insert(dottedName(setting));
    }
    for (const IntegratorRow& row : kIntegrators) {
        for (const std::string_view name : row.settings) {
            INFO(row.name << ": " << name);
            CHECK((name.empty() || names.contains("render." + std::string(name))));
        }
    }
}

TEST_CASE("only settings that leave every pass unchanged may differ between checkpoints") {
    std::set<std::string> free;
    for (const Setting& setting : settingsTable()) {
        if (!setting.affectsPicture) {
            free.insert(dottedName(setting));
        }
    }
    // How many passes there are, and when to stop; the content of the filter's file is part of the shaders' hash
    CHECK(free == std::set<std::string>{"render.passes", "render.target_error", "render.filter_file"});
}

TEST_CASE("text of the documentation is plain where no Markdown is shown") {
    CHECK(plainText("stop at `passes`, see [the error](metrics.md#error); [1, 2]") ==
          "stop at passes, see the error; [1, 2]");
}
