// The files that a scene is made of, as the live server watches them.
#pragma once

#include "live/messages/file_stamp.h"

#include <filesystem>
#include <map>
#include <string>

namespace hyalite::live {

// The scene file and every file that it names: meshes, textures, environments, GLSL, the buffers and images of glTF
// files. Files that do not exist are left out.
[[nodiscard]] std::map<std::string, FileStamp> stampsOfScene(const std::filesystem::path& scene);

// The files that values of settings name, relative to the folder.
[[nodiscard]] std::map<std::string, FileStamp> stampsOfNamedFiles(const std::map<std::string, std::string>& settings,
                                                                  const std::filesystem::path& folder);

} // namespace hyalite::live
