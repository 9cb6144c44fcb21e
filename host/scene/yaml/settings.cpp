// See settings.h.
#include "scene/yaml/settings.h"

#include "base/spelling.h"
#include "scene/model/integrators.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/photon_map_settings.h"
#include "shaders/shared/limits.h"

#include <algorithm>
#include <array>
#include <limits>

namespace hyalite {
namespace {

constexpr Range kCoordinate{-kLargestLength, kLargestLength, true, true, "m"};
constexpr Range kDirection{-kLargestLength, kLargestLength};
constexpr Range kFov{0, 180, false, false, "degrees"};
constexpr Range kAperture{0, kLargestLength, true, true, "m"};
constexpr Range kFocus{kSmallestLength, kLargestLength, true, true, "m"};
constexpr Range kSide{1, kLargestSide, true, true, "pixels"};
constexpr Range kCount{1, std::numeric_limits<std::uint32_t>::max()};
constexpr Range kTargetError{0, 1e9};
constexpr Range kPhotons{1, kMostPhotons};
constexpr Range kSeed{0, std::numeric_limits<std::uint32_t>::max()};
constexpr Range kSearchRadius{0, kLargestLength, true, true, "m"};
constexpr Range kAlpha{0, 1, false, false};
constexpr Range kShare{0, 1};
// A ray after n reflections or refractions is the path's segment n + 1; segments are counted in 8 bits.
constexpr Range kBounces{0, shared::kMaxDepth - 1};
constexpr Range kSegments{1, shared::kMaxDepth};

constexpr std::array<Choice<RandomNumbers>, 2> kSamplers{{
    {"sobol", RandomNumbers::Sobol},
    {"independent", RandomNumbers::Independent},
}};

std::string readIntegrator(const Value& name) {
    const std::string word = name.text();
    if (std::ranges::find(kIntegratorNames, word) == kIntegratorNames.end()) {
        failUnknownWord(name, "integrator", std::vector<std::string>(kIntegratorNames.begin(), kIntegratorNames.end()));
    }
    return word;
}

// The place of a key, or of the map around it when the key is not written there.
Value placeOf(Reader& reader, std::string_view key) {
    const auto value = reader.find(key);
    return value ? *value : reader.map();
}

} // namespace

void readCamera(const Value& value, Camera& camera) {
    Reader reader(value);
    reader.optional("position", camera.position, kCoordinate);
    reader.optional("look_at", camera.lookAt, kCoordinate);
    reader.optional("up", camera.up, kDirection);
    reader.optional("fov", camera.fov, kFov);
    reader.optional("aperture", camera.aperture, kAperture);
    reader.optional("focus_distance", camera.focusDistance, kFocus);
    reader.optional("resolution", camera.resolution, kSide);
    reader.finish();

    if (std::uint64_t{camera.resolution.x} * camera.resolution.y > kMostPixels) {
        placeOf(reader, "resolution").fail("more than " + std::to_string(kMostPixels) + " pixels");
    }
    const glm::dvec3 view = camera.lookAt - camera.position;
    if (glm::length(view) < kSmallestLength) {
        placeOf(reader, "look_at").fail("'look_at' and 'position' of the camera are the same point");
    }
    if (glm::length(camera.up) == 0) {
        placeOf(reader, "up").fail("'up' is zero");
    }
    const glm::dvec3 sine = glm::cross(glm::normalize(view), glm::normalize(camera.up));
    if (!(glm::length(sine) >= kSmallestAngle)) {
        placeOf(reader, "up")
            .fail("'up' is parallel to the camera's view from 'position' to 'look_at'",
                  "set camera.up to another direction");
    }
}

void readRenderSettings(const Value& value, RenderSettings& render) {
    Reader reader(value);
    if (const auto name = reader.find("integrator")) {
        render.integrator = readIntegrator(*name);
    }
    reader.optional("passes", render.passes, kCount);
    reader.optional("target_error", render.targetError, kTargetError);
    reader.optional("photons", render.photons, kPhotons);
    reader.optional("seed", render.seed, kSeed);
    if (const auto name = reader.find("sampler")) {
        render.sampler = choose<RandomNumbers>(*name, "sampler", kSamplers);
    }
    reader.optional("radius", render.radius, kSearchRadius);
    reader.optional("alpha", render.alpha, kAlpha);
    reader.optional("min_weight", render.minWeight, kShare);
    readPhotonMapSettings(reader, render.photonMap);

    // Checked even when the key is absent: the integrator may be what changed.
    const Range& depth = integratorNamed(render.integrator).cameraPaths.followsAllWays ? kBounces : kSegments;
    reader.optional("max_depth", render.maxDepth, depth);
    reader.finish();
    if (!depth.contains(render.maxDepth)) {
        placeOf(reader, "integrator")
            .fail("with this integrator 'max_depth' must be " + depth.text() + ", it is " +
                      std::to_string(render.maxDepth),
                  "set render.max_depth too");
    }
    if (render.radius != 0 && render.radius < kSmallestLength) {
        placeOf(reader, "radius")
            .fail("'radius' must be 0 or at least " + numberText(kSmallestLength) + " m",
                  "0: 1/100 of the radius of the scene's bounding sphere");
    }
}

namespace {

// "640x480" as YAML; anything else as it is, for the reader to judge.
std::string resolutionAsYaml(const std::string& value) {
    const auto x = value.find('x');
    if (x == std::string::npos || !parseWhole(value.substr(0, x)) || !parseWhole(value.substr(x + 1))) {
        return value;
    }
    return '[' + value.substr(0, x) + ", " + value.substr(x + 1) + ']';
}

} // namespace

void applySetting(Scene& scene, const std::string& key, const std::string& value, const std::string& option) {
    const auto fail = [&](const std::string& what, const std::string& hint) {
        throw Error(ExitCode::WrongUsage, SourceLocation{option, 0, 0}, what, hint);
    };
    const auto dot = key.find('.');
    const std::string section = key.substr(0, dot);
    if (section != "camera" && section != "render") {
        const std::array<std::string, 2> known{"camera", "render"};
        fail("unknown setting " + inQuotes(key), spellingHint(section, known));
    }
    if (dot == std::string::npos) {
        fail(inQuotes(key) + " is a group of settings", "name one, as in render.photons");
    }

    // A map of the one key, as the scene file would hold it, read over the present settings.
    YamlNode map;
    map.kind = YamlNode::Kind::Map;
    const std::string text = key == "camera.resolution" ? resolutionAsYaml(value) : value;
    Camera camera = scene.camera;
    RenderSettings render = scene.render;
    try {
        map.entries.push_back({key.substr(dot + 1), 0, 0, parseYaml(text, option, false)});
        const Value group(map, option, section);
        if (section == "camera") {
            readCamera(group, camera);
        } else {
            readRenderSettings(group, render);
        }
    } catch (const Error& error) { // a mistake on the command line, not in a file
        throw Error(ExitCode::WrongUsage, error.where(), error.message(), error.hint());
    }
    scene.camera = camera;
    scene.render = render;
}

} // namespace hyalite
