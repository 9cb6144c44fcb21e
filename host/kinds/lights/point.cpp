// Light from a point: shaders/lights/point.glsl, host/reference/lights/point.cpp.
#include "kinds/lights/light_kinds.h"
#include "scene/yaml/read_placement.h"

#include <array>
#include <numbers>

namespace hyalite::kinds {
namespace {

using std::numbers::pi;

constexpr KeyDoc kPosition{.name = "position", .type = KeyType::Vector, .range = kCoordinate, .required = true};
constexpr KeyDoc kStrength{
    .name = "intensity", .type = KeyType::Color, .range = kIntensity, .defaultText = "1", .text = "not all 0"};
constexpr std::array kKeys{kPosition, kStrength, kPhotonShare};

void read(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    PointLight light;
    readKey(reader, kPosition, light.position);
    readStrength(reader, kStrength, light.intensity);
    readKey(reader, kPhotonShare, light.photonShare);
    light.where = reader.where();
    scene.lights.push_back(light);
}

shared::LightRecord record(const PointLight& light) {
    shared::LightRecord r{};
    r.type = shared::kLightPoint;
    r.position = light.position;
    r.emission = light.intensity;
    r.power = 4 * pi * light.intensity;
    return r;
}

void addRecords(const Scene& scene, LightTable& table) {
    for (const PointLight& light : scene.lights) {
        table.add(record(light), light.photonShare);
    }
}

} // namespace

constinit const LightKind kPointLight{.doc = {.type = "point", .schemaName = "pointLight", .keys = kKeys},
                                      .read = read,
                                      .addRecords = addRecords,
                                      .reference = referenceLight<PointLight>()};

} // namespace hyalite::kinds
