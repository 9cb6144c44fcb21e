// See read_lights.h. A new light is a reader here and a row of kLights.
#include "scene/read_lights.h"

#include "scene/scene_limits.h"

#include <array>

namespace hyalite {
namespace {

constexpr Range kCoordinate{-kLargestLength, kLargestLength, true, true, "m"};
constexpr Range kIntensity{0, kLargestEmission, true, true, "W/sr"};

void readPointLight(Reader& reader, Scene& scene) {
    PointLight light;
    reader.required("position", light.position, kCoordinate);
    reader.optionalColor("intensity", light.intensity, kIntensity);
    if (light.intensity == glm::dvec3(0)) {
        reader.require("intensity").fail("this light is dark", "give it an intensity above 0 or leave it out");
    }
    scene.lights.push_back(light);
}

using ReadLight = void (*)(Reader&, Scene&);
constexpr std::array<Choice<ReadLight>, 1> kLights{{
    {"point", readPointLight},
}};

} // namespace

void readLight(const Value& value, Scene& scene) {
    Reader reader(value);
    const auto read = choose<ReadLight>(reader.require("type"), "light type", kLights);
    read(reader, scene);
    reader.finish();
}

} // namespace hyalite
