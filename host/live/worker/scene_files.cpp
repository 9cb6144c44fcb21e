#include "live/worker/scene_files.h"

#include "base/error.h"
#include "scene/yaml/yaml_tree.h"

#include <fstream>
#include <iterator>
#include <system_error>

namespace hyalite::live {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPath = 4096;

void addFile(const fs::path& file, std::map<std::string, FileStamp>& files) {
    std::error_code ignored;
    if (const auto stamp = stampOf(file); stamp && fs::is_regular_file(file, ignored)) {
        files.emplace(file.string(), *stamp);
    }
}

// Takes a text for the name of a file when such a file exists.
void addNamedFile(const std::string& text, const fs::path& folder, std::map<std::string, FileStamp>& files) {
    if (text.find('.') != std::string::npos && text.size() < kLongestPath) {
        addFile(folder / text, files);
    }
}

void addNamedFiles(const YamlNode& node, const fs::path& folder, std::map<std::string, FileStamp>& files) {
    if (node.kind == YamlNode::Kind::Scalar) {
        addNamedFile(node.text, folder, files);
    }
    for (const YamlPointer& item : node.items) {
        addNamedFiles(*item, folder, files);
    }
    for (const YamlEntry& entry : node.entries) {
        addNamedFiles(*entry.value, folder, files);
    }
}

void addFilesNamedIn(const fs::path& file, std::map<std::string, FileStamp>& files) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    try {
        addNamedFiles(*parseYaml(text, file.string()), file.parent_path(), files);
    } catch (const Error&) {
        return; // loading the scene reports it
    }
}

} // namespace

std::map<std::string, FileStamp> stampsOfScene(const fs::path& scene) {
    std::map<std::string, FileStamp> files;
    addFile(scene, files); // before it is read here, too
    addFilesNamedIn(scene, files);
    for (const auto& [file, stamp] : std::map(files)) {
        if (fs::path(file).extension() == ".gltf") { // JSON, hence YAML
            addFilesNamedIn(file, files);
        }
    }
    return files;
}

std::map<std::string, FileStamp> stampsOfNamedFiles(const std::map<std::string, std::string>& settings,
                                                    const fs::path& folder) {
    std::map<std::string, FileStamp> files;
    for (const auto& [key, value] : settings) {
        addNamedFile(value, folder, files);
    }
    return files;
}

} // namespace hyalite::live
