#include "live/scene_json.h"

#include "live/setting_rows.h"
#include "scene/yaml/yaml_tree.h"

#include <fstream>
#include <set>

namespace hyalite::live {

namespace {

namespace fs = std::filesystem;

Json listOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

// Every text in the file that names a file beside it: meshes, textures, environments, code.
void addNamedFiles(const YamlNode& node, const fs::path& folder, std::set<std::string>& files) {
    std::error_code ignored;
    if (node.kind == YamlNode::Kind::Scalar && node.text.find('.') != std::string::npos && node.text.size() < 4096) {
        const fs::path path = folder / node.text;
        if (fs::is_regular_file(path, ignored)) {
            files.insert(path.string());
        }
    }
    for (const YamlPointer& item : node.items) {
        addNamedFiles(*item, folder, files);
    }
    for (const YamlEntry& entry : node.entries) {
        addNamedFiles(*entry.value, folder, files);
    }
}

std::set<std::string> filesOf(const fs::path& scene) {
    std::set<std::string> files;
    const auto add = [&](const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        try {
            addNamedFiles(*parseYaml(text, file.string()), file.parent_path(), files);
        } catch (const Error&) {
            return; // loading the scene says what is wrong
        }
    };
    add(scene);
    for (const std::string& file : std::set(files)) {
        if (fs::path(file).extension() == ".gltf") { // JSON, hence YAML: it names its buffers and images
            add(file);
        }
    }
    return files;
}

} // namespace

Json describe(const Scene& scene, const View& view, const fs::path& file) {
    const Camera& camera = scene.camera;
    Json code = Json::array();
    for (const Texture& texture : scene.textures) {
        if (const auto* custom = std::get_if<CustomTexture>(&texture.model)) {
            code.push_back(custom->code->file);
        }
    }
    for (const Material& material : scene.materials) {
        if (material.model.code != nullptr) {
            code.push_back(material.model.code->file);
        }
    }
    if (scene.render.photonMap.customFilter) {
        code.push_back(scene.render.photonMap.customFilter->file);
    }
    return {{"kind", "scene"},
            {"camera",
             {{"position", listOf(camera.position)},
              {"look_at", listOf(camera.lookAt)},
              {"up", listOf(camera.up)},
              {"fov", camera.fov},
              {"resolution", {camera.resolution.x, camera.resolution.y}}}},
            {"settings", settingValues(scene)},
            {"shown", view.shown},
            {"files", filesOf(file)},
            {"code", std::move(code)}};
}

Json describe(const LiveRenderer::Frame& frame) {
    Json stages = Json::array();
    for (const auto& [name, time] : frame.stages) {
        stages.push_back({{"name", name}, {"seconds", time.seconds}, {"dispatches", time.dispatches}});
    }
    Json json{{"width", frame.image.picture.width},
              {"height", frame.image.picture.height},
              {"preview", frame.isPreview},
              {"passes", frame.passes},
              {"of_passes", frame.ofPasses},
              {"error", nullptr},
              {"stages", std::move(stages)},
              {"photons_stored", frame.counts[render::Counter::PhotonsStored]},
              {"caustic_photons_stored", frame.counts[render::Counter::CausticPhotonsStored]},
              {"radius", frame.notes.searchRadius},
              {"warnings", frame.notes.warnings}};
    if (frame.error) {
        json["error"] = *frame.error;
    }
    return json;
}

} // namespace hyalite::live
