// The list of lights. To add a light type, add a file next to this one and a row here. If it needs its own sampling,
// also add a file in shaders/lights and one in host/reference/lights, each with a line in its list.
#pragma once

#include "kinds/lights/light_kind.h"

#include <array>

namespace hyalite::kinds {

extern const LightKind kEnvironmentLight;
extern const LightKind kPointLight;
extern const LightKind kSpotLight;
extern const LightKind kDirectionalLight;
extern const LightKind kAreaLight;
extern const LightKind kSkyLight;

// In the order of the device's table.
inline constexpr std::array kLightKinds{
    &kEnvironmentLight, &kPointLight, &kSpotLight, &kDirectionalLight, &kAreaLight, &kSkyLight,
};

} // namespace hyalite::kinds
