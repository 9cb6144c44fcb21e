// See read_lights.h. A new light is a reader here and a row of kLights.
#include "scene/load/read_lights.h"

#include "image/image_io.h"
#include "scene/model/scene_limits.h"
#include "scene/yaml/read_placement.h"

#include <algorithm>
#include <array>

namespace hyalite {
namespace {

constexpr Range kIntensity{0, kLargestEmission, true, true, "W/sr"};
constexpr Range kIrradiance{0, kLargestEmission, true, true, "W/m^2"};
constexpr Range kEnvironmentRadiance{0, kLargestEmission, true, true, "W/(m^2 sr)"};
constexpr Range kShare{1e-3, 1e3};
constexpr Range kConeAngle{0.001, 180, true, true, "degrees"}; // 1 - cos is a normal float
constexpr Range kBlend{0, 1};
constexpr Range kScale{0, kLargestEmission};
constexpr Range kTurning{-1e6, 1e6, true, true, "degrees"};

// The strength of a light: a colour that is not black.
void readStrength(Reader& reader, std::string_view key, glm::dvec3& out, const Range& range) {
    reader.optionalColor(key, out, range);
    if (out == glm::dvec3(0)) {
        reader.require(key).fail("this light is dark", "give it an " + std::string(key) + " above 0 or leave it out");
    }
}

void readPointLight(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    PointLight light;
    reader.required("position", light.position, kCoordinate);
    readStrength(reader, "intensity", light.intensity, kIntensity);
    light.photonShare = readPhotonShare(reader);
    scene.lights.push_back(light);
}

void readSpotLight(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    SpotLight light;
    reader.required("position", light.position, kCoordinate);
    light.direction = readUnit(reader.require("direction"));
    readStrength(reader, "intensity", light.intensity, kIntensity);
    reader.optional("angle", light.angle, kConeAngle);
    reader.optional("blend", light.blend, kBlend);
    light.photonShare = readPhotonShare(reader);
    scene.spots.push_back(light);
}

void readDirectionalLight(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    DirectionalLight light;
    light.direction = readUnit(reader.require("direction"));
    readStrength(reader, "irradiance", light.irradiance, kIrradiance);
    const auto center = reader.find("center");
    if (const auto radius = reader.find("radius")) {
        light.beam = DirectionalLight::Beam{};
        radius->read(light.beam->radius, kLength);
    }
    if (center) {
        if (!light.beam) {
            center->fail("a 'center' without a 'radius'",
                         "with both, the light is a beam; with neither, it is everywhere");
        }
        center->read(light.beam->center, kCoordinate);
    }
    light.photonShare = readPhotonShare(reader);
    scene.directionals.push_back(light);
}

// Its pixels, each fit to be a radiance.
Image readMap(const Value& file, const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / file.text();
    Image image;
    try {
        image = readImage(path);
    } catch (const Error& error) {
        file.fail(path.string() + ": " + error.message(), error.hint());
    }
    if (countNotFinite(image) > 0) {
        file.fail("this image holds values that are not finite");
    }
    const auto isNegative = [](const glm::vec3& c) { return c.x < 0 || c.y < 0 || c.z < 0; };
    if (std::any_of(image.pixels.begin(), image.pixels.end(), isNegative)) {
        file.fail("this image holds negative values", "radiance is never below 0");
    }
    if (std::all_of(image.pixels.begin(), image.pixels.end(), [](const glm::vec3& c) { return c == glm::vec3(0); })) {
        file.fail("this image is black", "leave the environment out");
    }
    return image;
}

void readEnvironment(Reader& reader, const std::filesystem::path& folder, Scene& scene) {
    if (scene.environment) {
        reader.map().fail("a second environment", "a scene has at most one");
    }
    Environment environment;
    const auto image = reader.find("image");
    const auto radiance = reader.find("radiance");
    if (image && radiance) {
        radiance->fail("both 'image' and 'radiance'", "an environment has one of them");
    }
    const auto scale = reader.find("scale");
    if (scale) {
        scale->read(environment.scale, kScale);
    }
    reader.optional("rotation", environment.rotation, kTurning);
    environment.photonShare = readPhotonShare(reader);
    reader.finish(); // before a large file is read for nothing
    if (image) {
        environment.image = readMap(*image, folder);
    } else {
        glm::dvec3 color(1);
        if (radiance) {
            radiance->readColor(color, kEnvironmentRadiance);
            if (color == glm::dvec3(0)) {
                radiance->fail("this light is dark", "give it a radiance above 0 or leave it out");
            }
        }
        environment.image = Image(1, 1);
        environment.image.at(0, 0) = color;
    }
    double largest = 0;
    for (const glm::vec3& c : environment.image.pixels) {
        largest = std::max(largest, static_cast<double>(std::max({c.x, c.y, c.z})));
    }
    if (!(largest * environment.scale > 0)) {
        (scale ? *scale : reader.map()).fail("this light is dark", "give it a scale above 0 or leave it out");
    }
    if (largest * environment.scale > kLargestEmission) {
        (image ? *image : reader.map())
            .fail("the environment is too bright", "its radiance is " + kEnvironmentRadiance.text());
    }
    scene.environment = std::move(environment);
}

using ReadLight = void (*)(Reader&, const std::filesystem::path&, Scene&);
constexpr std::array<Choice<ReadLight>, 4> kLights{{
    {"point", readPointLight},
    {"spot", readSpotLight},
    {"directional", readDirectionalLight},
    {"environment", readEnvironment},
}};

} // namespace

double readPhotonShare(Reader& reader) {
    double share = 1;
    reader.optional("photon_share", share, kShare);
    return share;
}

void readLight(const Value& value, const std::filesystem::path& folder, Scene& scene) {
    Reader reader(value);
    const auto read = choose<ReadLight>(reader.require("type"), "light type", kLights);
    read(reader, folder, scene);
    reader.finish();
}

} // namespace hyalite
