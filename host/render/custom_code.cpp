// See custom_code.h. Lines keep the file and number that they have at home, so that a mistake is reported there.
#include "render/custom_code.h"

#include <set>

namespace hyalite::render {

namespace {

std::string inPlaceOf(const std::string& file, const std::string& code) {
    return "#include \"lib/math.glsl\"\n#include \"shared/random.h\"\n" + code + "#line 1 \"" + file + "\"\n";
}

std::string quoted(const CustomCode& code) {
    return "#line 1 \"" + code.file + "\"\n" + code.text + '\n';
}

std::string textures(const Scene& scene) {
    std::string code;
    std::string choice;
    std::size_t number = 0;
    std::set<std::string> files; // several textures may come of one, with parameters of their own
    for (const Texture& texture : scene.textures) {
        if (const auto* custom = std::get_if<CustomTexture>(&texture.model)) {
            code += files.insert(custom->code->file).second ? quoted(*custom->code) : "";
            choice += "    case " + std::to_string(number++) + "u: return " + custom->code->function +
                      "(position, uv, parameters);\n";
        }
    }
    if (choice.empty()) {
        return {};
    }
    return inPlaceOf("lib/custom_texture.glsl", code) +
           "vec3 customTexture(uint number, vec3 position, vec2 uv, vec4 parameters) {\n    switch (number) {\n" +
           choice + "    }\n    return vec3(0.0);\n}\n";
}

} // namespace

std::map<std::string, std::string> customCode(const Scene& scene) {
    std::map<std::string, std::string> texts;
    if (const std::string text = textures(scene); !text.empty()) {
        texts["lib/custom_texture.glsl"] = text;
    }
    if (const auto& filter = scene.render.photonMap.customFilter) {
        texts["lib/custom_filter.glsl"] = inPlaceOf("lib/custom_filter.glsl", quoted(*filter)) +
                                          "float customFilter(float u) {\n    return " + filter->function + "(u);\n}\n";
    }
    return texts;
}

} // namespace hyalite::render
