// Updates the generated parts of scenes/hyalite.schema.json and docs/scene-format.md in the given source folder. The
// target scene_format runs it.
#include "base/error.h"
#include "base/input_file.h"
#include "base/output_file.h"
#include "describe/scene_format.h"

#include <filesystem>
#include <iostream>

namespace {

constexpr std::size_t kLargestFile = std::size_t{16} << 20U;

void update(const std::filesystem::path& file, std::string (*described)(std::string)) {
    const std::string before = hyalite::readInputFile(file, kLargestFile, "description", {});
    const std::string after = described(before);
    if (after != before) {
        hyalite::writeFileAtomically(file, std::as_bytes(std::span(after)));
        std::cout << "updated " << file.string() << '\n';
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: describe_scene_format SOURCE_FOLDER\n";
        return static_cast<int>(hyalite::ExitCode::WrongUsage);
    }
    try {
        const std::filesystem::path source = argv[1];
        update(source / hyalite::describe::kSchemaFile, hyalite::describe::describedSchema);
        update(source / hyalite::describe::kDocsFile, hyalite::describe::describedDocs);
    } catch (const hyalite::Error& error) {
        std::cerr << "describe_scene_format: " << error.what() << '\n';
        return static_cast<int>(error.code());
    }
    return 0;
}
