// Scenes from text, for tests: files in their own folder, removed when the test ends, and errors whose place is marked
// in the text itself.
#pragma once

#include "base/error.h"
#include "scene/load/load_scene.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <unistd.h>

namespace hyalite::test {

class TemporaryFolder {
public:
    TemporaryFolder() {
        static std::atomic<int> count{0};
        path_ = std::filesystem::temp_directory_path() /
                ("hyalite-test-" + std::to_string(getpid()) + '-' + std::to_string(count++));
        std::filesystem::create_directories(path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored; // a destructor cannot report it, and the system cleans up the folder
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    TemporaryFolder(TemporaryFolder&&) = delete;
    TemporaryFolder& operator=(TemporaryFolder&&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(const std::string& name, std::string_view bytes) {
        std::filesystem::path file = path_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::filesystem::remove(file); // overwriting in place would wait for the disk on some file systems
        std::ofstream stream(file, std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        REQUIRE(stream.flush());
        return file;
    }

private:
    std::filesystem::path path_;
};

// Text in which a dollar sign stands before the place of an error: the text without it, and the place.
struct MarkedText {
    std::string text;
    int line = 0; // 0: no mark
    int column = 0;

    explicit MarkedText(std::string_view marked) : text(marked) {
        const std::size_t mark = text.find('$');
        if (mark == std::string::npos) {
            return;
        }
        text.erase(mark, 1);
        line = 1;
        column = 1;
        for (std::size_t i = 0; i < mark; ++i) {
            column = text[i] == '\n' ? 1 : column + 1;
            line += text[i] == '\n' ? 1 : 0;
        }
    }
};

// The Error that a call throws; none if it returns. Any other exception fails the test.
template <class Call>
std::optional<Error> errorOf(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

inline std::string readFile(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    REQUIRE(stream);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// A scene of one gray object with this shape and transform.
inline Scene loadWithShape(const std::string& shape, const std::string& transform = "[]") {
    TemporaryFolder folder;
    return loadScene(folder.write("scene.yaml", "hyalite: 1\nlights: [{type: point, position: [0, 1, 0]}]\n"
                                                "materials: {gray: {type: diffuse}, red: {type: diffuse}, "
                                                "green: {type: diffuse}, blue: {type: diffuse}}\n"
                                                "objects:\n  - {material: gray, shape: " +
                                                    shape + ", transform: " + transform + "}\n"));
}

inline const std::filesystem::path kSourceFolder = HYALITE_SOURCE_DIR;

} // namespace hyalite::test
