// Parallel light, everywhere or in a beam: shaders/lights/directional.glsl, host/reference/lights/directional.cpp.
#include "kinds/lights/light_kinds.h"
#include "scene/yaml/read_placement.h"

#include <array>

namespace hyalite::kinds {
namespace {

constexpr KeyDoc kTo{.name = "direction",
                     .type = KeyType::Vector,
                     .range = kDirection,
                     .required = true,
                     .text = "in which the light travels, any nonzero length"};
constexpr KeyDoc kStrength{.name = "irradiance",
                           .type = KeyType::Color,
                           .range = kIrradiance,
                           .defaultText = "1",
                           .text = "irradiance of a surface that faces the light, not all 0"};
constexpr KeyDoc kRadius{
    .name = "radius", .range = kLength, .defaultText = "none: the whole scene is lit", .text = "radius of a beam"};
constexpr KeyDoc kCenter{.name = "center",
                         .type = KeyType::Vector,
                         .range = kCoordinate,
                         .defaultText = "[0, 0, 0]",
                         .text = "centre of the disc where a beam starts; only with `radius`"};
constexpr std::array kKeys{kTo, kStrength, kRadius, kCenter, kPhotonShare};

void read(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    DirectionalLight light;
    light.direction = readUnit(reader.require(kTo.name));
    readStrength(reader, kStrength, light.irradiance);
    const auto center = reader.find(kCenter.name);
    if (const auto radius = reader.find(kRadius.name)) {
        light.beam = DirectionalLight::Beam{};
        radius->read(light.beam->radius, kRadius.range);
    }
    if (center) {
        if (!light.beam) {
            center->fail("'center' needs a 'radius'", "with both, the light is a beam; with neither, it is everywhere");
        }
        center->read(light.beam->center, kCenter.range);
    }
    readKey(reader, kPhotonShare, light.photonShare);
    light.where = reader.where();
    scene.directionals.push_back(light);
}

shared::LightRecord record(const Scene& scene, const DirectionalLight& light) {
    shared::LightRecord r{};
    if (light.beam) {
        r.type = shared::kLightBeam;
        r.position = light.beam->center;
        setStartDisc(r, light.beam->radius, 0);
    } else {
        r = endlessLight(scene, shared::kLightDirectional);
    }
    r.normal = light.direction;
    r.emission = light.irradiance;
    r.power = double{r.area} * light.irradiance;
    return r;
}

void addRecords(const Scene& scene, LightTable& table) {
    for (const DirectionalLight& light : scene.directionals) {
        table.add(record(scene, light), light.photonShare);
    }
}

} // namespace

constinit const LightKind kDirectionalLight{
    .doc =
        {.type = "directional",
         .schemaName = "directionalLight",
         .text =
             "*Directional* light comes from beyond the scene and lights all of it. With a `radius` it is a beam: it "
             "starts at a disc about `center`, perpendicular to the direction, and lights what is in front of the disc "
             "within `radius` of the axis; its power is `irradiance` times π `radius`².",
         .keys = kKeys,
         .rules = R"({"dependentRequired": {"center": ["radius"]}})"},
    .read = read,
    .addRecords = addRecords,
    .reference = referenceLight<reference::ParallelLight>()};

} // namespace hyalite::kinds
