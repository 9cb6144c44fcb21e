// What the passes of a render depend on besides their number. Passes of equal identities add up to one picture.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace hyalite::render {

struct RenderIdentity {
    std::string scene;                                         // name of the scene file, for the picture's metadata
    std::vector<std::pair<std::string, std::string>> settings; // names and values, in one order

    [[nodiscard]] std::string setting(const std::string& name) const; // "" where it is not there
};

// The first setting in which the two differ, e.g. "render.seed is 1 there and 2 here"; empty where they are equal.
[[nodiscard]] std::string difference(const RenderIdentity& there, const RenderIdentity& here);

} // namespace hyalite::render
