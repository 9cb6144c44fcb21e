// See settings.h.
#include "scene/yaml/settings.h"

#include "base/spelling.h"
#include "scene/model/integrators.h"
#include "scene/model/recentre.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/settings_table.h"

#include <functional>
#include <vector>

namespace hyalite {
namespace {

// The place where a key of the section was given; for an absent key, the place to report for the section.
using PlaceOf = std::function<SourceLocation(std::string_view key)>;

[[noreturn]] void fail(const SourceLocation& where, const std::string& what, const std::string& hint = {}) {
    throw Error(ExitCode::BadInput, where, what, hint);
}

void checkCamera(const Camera& camera, const PlaceOf& placeOf) {
    if (std::uint64_t{camera.resolution.x} * camera.resolution.y > kMostPixels) {
        fail(placeOf("resolution"), "more than " + std::to_string(kMostPixels) + " pixels");
    }
    const glm::dvec3 view = camera.lookAt - camera.position;
    if (glm::length(view) < kSmallestLength) {
        fail(placeOf("look_at"), "'look_at' and 'position' of the camera are the same point");
    }
    if (glm::length(camera.up) == 0) {
        fail(placeOf("up"), "'up' is zero");
    }
    const glm::dvec3 sine = glm::cross(glm::normalize(view), glm::normalize(camera.up));
    if (!(glm::length(sine) >= kSmallestAngle)) {
        fail(placeOf("up"), "'up' is parallel to the camera's view from 'position' to 'look_at'",
             "set camera.up to another direction");
    }
}

void checkRenderSettings(const RenderSettings& render, const PlaceOf& placeOf) {
    const Range& depth = depthRange(integratorNamed(render.integrator));
    if (!depth.contains(render.maxDepth)) {
        fail(placeOf("max_depth"),
             "with integrator " + render.integrator + " 'max_depth' must be " + depth.text() + ", it is " +
                 std::to_string(render.maxDepth),
             "change render.max_depth or render.integrator");
    }
    const PhotonMapSettings& maps = render.photonMap;
    const bool isCustom = maps.filter == PhotonFilter::Custom || maps.causticFilter == PhotonFilter::Custom;
    if (isCustom && maps.customFilter == nullptr) {
        fail(placeOf("filter_file"), "a custom filter needs a 'filter_file'", "e.g. filter_file: falloff.glsl");
    }
}

void check(Section section, const Settings& settings, const PlaceOf& placeOf) {
    if (section == Section::Camera) {
        checkCamera(settings.camera, placeOf);
    } else {
        checkRenderSettings(settings.render, placeOf);
    }
}

// Reads and checks the keys of a section in a scene file.
void readSection(const Value& map, Section section, Settings& settings) {
    Reader reader(map);
    for (const Setting& setting : settingsTable()) {
        if (setting.section != section) {
            continue;
        }
        if (const auto value = reader.find(setting.doc.name)) {
            setting.read(*value, setting.doc, settings);
        }
    }
    reader.finish();
    check(section, settings, [&](std::string_view key) {
        const auto value = reader.find(key);
        return value ? value->where() : reader.where();
    });
}

// "640x480" as YAML; anything else unchanged, for the reader to check.
std::string resolutionAsYaml(const std::string& value) {
    const auto x = value.find('x');
    if (x == std::string::npos || !parseWhole(value.substr(0, x)) || !parseWhole(value.substr(x + 1))) {
        return value;
    }
    return '[' + value.substr(0, x) + ", " + value.substr(x + 1) + ']';
}

// The row with this dotted key.
const Setting& settingNamed(const std::string& key, const SourceLocation& where) {
    const auto dot = key.find('.');
    const std::string section = key.substr(0, dot);
    const std::string name = dot == std::string::npos ? std::string() : key.substr(dot + 1);
    std::vector<std::string> names;
    for (const Setting& setting : settingsTable()) {
        if (nameOf(setting.section) != section) {
            continue;
        }
        if (setting.doc.name == name) {
            return setting;
        }
        names.emplace_back(setting.doc.name);
    }
    if (names.empty()) {
        const std::vector<std::string> sections{"camera", "render"};
        fail(where, "unknown setting " + inQuotes(key), spellingHint(section, sections));
    }
    if (dot == std::string::npos) {
        fail(where, inQuotes(key) + " is a group of settings", "name one, as in render.photons");
    }
    fail(where, "unknown key " + inQuotes(name) + " in " + inQuotes(section), spellingHint(name, names));
}

void assign(const SettingAssignment& assignment, Settings& settings) {
    const Setting& setting = settingNamed(assignment.key, {assignment.option});
    const bool isPair = setting.doc.type == KeyType::WholePair;
    const YamlPointer tree =
        parseYaml(isPair ? resolutionAsYaml(assignment.value) : assignment.value, assignment.option, false);
    setting.read(Value(*tree, assignment.option, std::string(setting.doc.name)), setting.doc, settings);
}

// Checks the rules between settings, in each section that was assigned to.
void checkAssigned(const Settings& settings, std::span<const SettingAssignment> assignments) {
    for (const Section section : {Section::Camera, Section::Render}) {
        const std::string prefix = std::string(nameOf(section)) + '.';
        const auto placeOf = [&](std::string_view key) {
            const SettingAssignment* nearest = nullptr;
            for (const SettingAssignment& assignment : assignments) {
                const bool isThis = assignment.key == prefix + std::string(key);
                if (isThis || (nearest == nullptr && assignment.key.starts_with(prefix))) {
                    nearest = &assignment;
                }
            }
            return SourceLocation{nearest == nullptr ? std::string() : nearest->option};
        };
        if (!placeOf({}).file.empty()) {
            check(section, settings, placeOf);
        }
    }
}

} // namespace

void readCamera(const Value& value, Camera& camera) {
    Settings settings{.camera = camera, .render = {}};
    readSection(value, Section::Camera, settings);
    camera = settings.camera;
}

void readRenderSettings(const Value& value, RenderSettings& render) {
    Settings settings{.camera = {}, .render = render};
    readSection(value, Section::Render, settings);
    render = settings.render;
}

void applySettings(Scene& scene, std::span<const SettingAssignment> assignments) {
    Settings settings{inWorld(scene.camera, scene), scene.render};
    try {
        for (const SettingAssignment& assignment : assignments) {
            assign(assignment, settings);
        }
        checkAssigned(settings, assignments);
    } catch (const Error& error) { // the mistake is on the command line, not in a file
        throw Error(ExitCode::WrongUsage, error.where(), error.message(), error.hint());
    }
    scene.camera = inScene(settings.camera, scene);
    scene.render = settings.render;
}

void applySetting(Scene& scene, const std::string& key, const std::string& value, const std::string& option) {
    const SettingAssignment assignment{key, value, option};
    applySettings(scene, {&assignment, 1});
}

} // namespace hyalite
