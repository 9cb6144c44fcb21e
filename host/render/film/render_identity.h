// Everything that the passes of a render depend on besides their number. Passes of equal identities add up to one
// picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hyalite::render {

struct RenderIdentity {
    std::string scene;                                         // name of the scene file, for the picture's metadata
    std::vector<std::pair<std::string, std::string>> settings; // names and values, in a fixed order

    [[nodiscard]] std::string setting(const std::string& name) const; // "" if it is missing
};

// The first setting that differs, e.g. "render.seed is 1 there and 2 here"; empty if they are equal.
[[nodiscard]] std::string difference(const RenderIdentity& there, const RenderIdentity& here);

} // namespace hyalite::render
