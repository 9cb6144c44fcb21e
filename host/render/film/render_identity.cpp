#include "render/film/render_identity.h"

namespace hyalite::render {

std::string nameOf(RandomNumbers sampler) {
    return sampler == RandomNumbers::Sobol ? "sobol" : "independent";
}

std::string RenderIdentity::setting(const std::string& name) const {
    for (const auto& [key, value] : settings) {
        if (key == name) {
            return value;
        }
    }
    return {};
}

std::string difference(const RenderIdentity& there, const RenderIdentity& here) {
    for (const auto& [name, value] : here.settings) {
        if (there.setting(name) != value) {
            return name + " is " + there.setting(name) + " there and " + value + " here";
        }
    }
    return there.settings.size() == here.settings.size() ? "" : "one was made by another version of the program";
}

} // namespace hyalite::render
