// Light from a point into a cone: shaders/lights/spot.glsl, host/reference/lights/spot.cpp.
#include "kinds/lights/light_kinds.h"
#include "scene/yaml/read_placement.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hyalite::kinds {
namespace {

using std::numbers::pi;

constexpr KeyDoc kPosition{.name = "position", .type = KeyType::Vector, .range = kCoordinate, .required = true};
constexpr KeyDoc kAxis{.name = "direction",
                       .type = KeyType::Vector,
                       .range = kDirection,
                       .required = true,
                       .text = "direction of the axis, any nonzero length"};
constexpr KeyDoc kStrength{.name = "intensity",
                           .type = KeyType::Color,
                           .range = kIntensity,
                           .defaultText = "1",
                           .text = "intensity on the axis, not all 0"};
constexpr KeyDoc kAngle{.name = "angle",
                        .range = {0.001, 180, true, true, "degrees"}, // 1 - cos is a normal float
                        .defaultText = "30",
                        .text = "angle between the axis and the edge of the cone"};
constexpr KeyDoc kBlend{.name = "blend",
                        .range = {0, 1},
                        .defaultText = "0.1",
                        .text = "outer fraction of the angle over which the intensity falls to 0"};
constexpr std::array kKeys{kPosition, kAxis, kStrength, kAngle, kBlend, kPhotonShare};

void read(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    SpotLight light;
    readKey(reader, kPosition, light.position);
    light.direction = readUnit(reader.require(kAxis.name));
    readStrength(reader, kStrength, light.intensity);
    readKey(reader, kAngle, light.angle);
    readKey(reader, kBlend, light.blend);
    readKey(reader, kPhotonShare, light.photonShare);
    light.where = reader.where();
    scene.spots.push_back(light);
}

shared::LightRecord record(const SpotLight& light) {
    // 1 - cos = 2 sin^2 of half the angle
    const auto cone = [](double degrees) {
        const double sine = std::sin(degrees * pi / 360);
        return 2 * sine * sine;
    };
    const double inner = cone(light.angle * (1 - light.blend));
    const double outer = cone(light.angle);
    shared::LightRecord r{};
    r.type = shared::kLightSpot;
    r.position = light.position;
    r.normal = light.direction;
    r.cone = glm::dvec2(inner, outer);
    r.emission = light.intensity;
    r.power = pi * (inner + outer) * light.intensity; // see lights/spot.glsl
    return r;
}

void addRecords(const Scene& scene, LightTable& table) {
    for (const SpotLight& light : scene.spots) {
        table.add(record(light), light.photonShare);
    }
}

} // namespace

constinit const LightKind kSpotLight{
    .doc = {.type = "spot",
            .schemaName = "spotLight",
            .text =
                "*Spots* have their full intensity up to (1 - `blend`) `angle` from the axis and none beyond `angle`. "
                "Between the two the intensity is 3t² - 2t³ of the full one, where t is linear in the cosine of the "
                "angle, from 0 at the outer cone to 1 at the inner one. The mean of 3t² - 2t³ is 1/2, so the power is "
                "π (2 - cos inner - cos outer) times the intensity.",
            .keys = kKeys},
    .read = read,
    .addRecords = addRecords,
    .reference = referenceLight<SpotLight>()};

} // namespace hyalite::kinds
