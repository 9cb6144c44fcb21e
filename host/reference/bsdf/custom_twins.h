// Twins in C++ of textures and materials that scenes bring along as GLSL: those that the reference can render, and
// parity compare. They are loaded from shared objects, and belong to one text of GLSL: what was edited since has none.
#pragma once

#include "base/error.h"
#include "scene/model/scene.h"

#include <filesystem>
#include <vector>

namespace hyalite::reference {

// Where twins are looked for.
struct TwinSources {
    std::vector<std::filesystem::path> files; // asked for by name
    std::filesystem::path folder;             // every *.twin.so in it; need not exist
};

// Gives each code of the scene the twin that was written after its text, if there is one; those of `files` come first.
// Throws Error(WrongUsage) where a file is no twin.
void attachTwins(Scene& scene, const TwinSources& sources);

// The twin of a texture's or material's code; nullptr: there is none.
[[nodiscard]] TextureTwin customTextureTwin(const CustomCode& code);
[[nodiscard]] ReflectanceTwin customReflectanceTwin(const CustomCode& code);

// The first of the scene's textures, or materials, that has none; nullptr: all have.
[[nodiscard]] const CustomCode* textureWithoutTwin(const Scene& scene);
[[nodiscard]] const CustomCode* reflectanceWithoutTwin(const Scene& scene);

// The first code of the scene that has no twin; nullptr: all have. A filter never has one.
[[nodiscard]] const CustomCode* codeWithoutTwin(const Scene& scene);

// Says that the code has no twin, where it stands, and what to do about it.
[[nodiscard]] Error noTwin(const CustomCode& code);

} // namespace hyalite::reference
