// Copies, edits and removes shader folders below the system's temporary one.
#include "unit/gpu/temporary_shaders.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace hyalite::testing {

namespace fs = std::filesystem;

std::string readFile(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw std::runtime_error("cannot read " + file.string());
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

void writeFile(const fs::path& file, const std::string& bytes) {
    fs::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream << bytes;
    stream.close();
    if (!stream) {
        throw std::runtime_error("cannot write " + file.string());
    }
}

TemporaryShaders::TemporaryShaders() {
    std::string name = (fs::temp_directory_path() / "hyalite-shaders-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw std::runtime_error("cannot make a temporary folder");
    }
    root_ = name;
    fs::copy(HYALITE_SOURCE_DIR "/shaders", shaders(), fs::copy_options::recursive);
}

TemporaryShaders::~TemporaryShaders() {
    std::error_code error; // what cannot be removed stays in the temporary folder
    fs::remove_all(root_, error);
}

void TemporaryShaders::write(const std::string& file, const std::string& text) const {
    writeFile(shaders() / file, text);
}

void TemporaryShaders::writeKernel(const std::string& name, const std::string& members, const std::string& body,
                                   const std::string& declarations) const {
    write("kernels/" + name + ".comp", R"(#version 460
#include "lib/thread.glsl"
#include "shared/path_records.h"
struct Arguments {
)" + members + R"(
    uint count;
};
layout(push_constant, scalar) uniform Push { Arguments args; };
)" + declarations + R"(
void main() {
    uint i = threadIndex();
    if (i >= args.count) {
        return;
    }
)" + body + "\n}\n");
}

void TemporaryShaders::replace(const std::string& file, const std::string& old, const std::string& text) const {
    std::string content = readFile(shaders() / file);
    const std::size_t place = content.find(old);
    if (place == std::string::npos || content.find(old, place + 1) != std::string::npos) {
        throw std::runtime_error(file + " does not have '" + old + "' exactly once");
    }
    write(file, content.replace(place, old.size(), text));
}

} // namespace hyalite::testing
