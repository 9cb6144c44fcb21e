// C++ twins of the GLSL textures and materials that scenes define: with one, the reference can render the code and
// parity can compare it. Twins are loaded from shared objects. A twin belongs to one exact GLSL text; edited code has
// no twin.
#pragma once

#include "base/error.h"
#include "scene/model/scene.h"

#include <filesystem>
#include <vector>

namespace hyalite::reference {

// Where to look for twins.
struct TwinSources {
    std::vector<std::filesystem::path> files; // named by the user
    std::filesystem::path folder;             // every *.twin.so in it; need not exist
};

// Attaches to each of the scene's GLSL codes the twin written for its text, if there is one; `files` take precedence.
// Throws Error(WrongUsage) if a file is not a twin.
void attachTwins(Scene& scene, const TwinSources& sources);

// Twin of a texture's or material's code; nullptr if there is none.
[[nodiscard]] TextureTwin customTextureTwin(const CustomCode& code);
[[nodiscard]] ReflectanceTwin customReflectanceTwin(const CustomCode& code);

// The scene's first texture, or material, without a twin; nullptr if all have one.
[[nodiscard]] const CustomCode* textureWithoutTwin(const Scene& scene);
[[nodiscard]] const CustomCode* reflectanceWithoutTwin(const Scene& scene);

// The scene's first GLSL code without a twin; nullptr if all have one. Filters never have one.
[[nodiscard]] const CustomCode* codeWithoutTwin(const Scene& scene);

// The error for code without a twin: where the code is, and what to do about it.
[[nodiscard]] Error noTwin(const CustomCode& code);

} // namespace hyalite::reference
