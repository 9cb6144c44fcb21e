// See custom_code.h. Lines keep their original file and number, so that errors are reported there.
#include "render/upload/custom_code.h"

#include <set>

namespace hyalite::render {

namespace {

std::string inPlaceOf(const std::string& file, const std::string& code) {
    return "#include \"lib/math.glsl\"\n#include \"shared/random.h\"\n" + code + "#line 1 \"" + file + "\"\n";
}

std::string quoted(const CustomCode& code) {
    return "#line 1 \"" + code.file + "\"\n" + code.text + '\n';
}

// A function that calls one of the scene's functions by number. Several may come from one file, each with its own
// parameters.
struct Dispatcher {
    std::string code;
    std::string choice;
    std::size_t number = 0;
    std::set<std::string> files;

    void add(const CustomCode& custom, const std::string& arguments) {
        code += files.insert(custom.file).second ? quoted(custom) : "";
        choice += "    case " + std::to_string(number++) + "u: return " + custom.function + arguments + ";\n";
    }
    // Adds nothing if there is no function to call.
    void putInto(std::map<std::string, std::string>& texts, const std::string& file,
                 const std::string& declaration) const {
        if (!choice.empty()) {
            texts[file] = inPlaceOf(file, code) + declaration + " {\n    switch (number) {\n" + choice +
                          "    }\n    return vec3(0.0);\n}\n";
        }
    }
};

} // namespace

std::map<std::string, std::string> customCode(const Scene& scene) {
    std::map<std::string, std::string> texts;
    Dispatcher textures;
    for (const Texture& texture : scene.textures) {
        if (const auto* custom = std::get_if<CustomTexture>(&texture.model)) {
            textures.add(*custom->code, "(position, uv, parameters)");
        }
    }
    textures.putInto(texts, "textures/custom_texture.glsl",
                     "vec3 customTexture(uint number, vec3 position, vec2 uv, vec4 parameters)");
    Dispatcher reflectances;
    for (const Material& material : scene.materials) {
        if (material.model.code != nullptr) {
            reflectances.add(*material.model.code, "(cosine, parameters)");
        }
    }
    reflectances.putInto(texts, "bsdf/custom_reflectance.glsl",
                         "vec3 customReflectance(uint number, float cosine, vec4 parameters)");
    if (const auto& filter = scene.render.photonMap.customFilter) {
        texts["photons/custom_filter.glsl"] = inPlaceOf("photons/custom_filter.glsl", quoted(*filter)) +
                                              "float customFilter(float u) {\n    return " + filter->function +
                                              "(u);\n}\n";
    }
    return texts;
}

} // namespace hyalite::render
