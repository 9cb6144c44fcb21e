// No save is lost, whenever it happens: while the scene loads, or between two polls when the list of files changes.
#include "live/supervisor/file_watch.h"
#include "live/worker/scene_files.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>
#include <chrono>
#include <cstdlib>

using namespace hyalite;
using namespace hyalite::live;
using testing::writeFile;

namespace {

namespace fs = std::filesystem;

class Folder {
public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "hyalite-watch-XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    // Writes a file, and gives it a time of its own: saves may follow one another faster than the file system's clock.
    std::string save(const std::string& name, const std::string& text = "x") {
        const fs::path file = path_ / name;
        writeFile(file, text);
        fs::last_write_time(file, fs::file_time_type() + std::chrono::seconds(++saves_));
        return file.string();
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
    int saves_ = 0;
};

std::map<std::string, FileStamp> stamps(const std::vector<std::string>& files) {
    std::map<std::string, FileStamp> result;
    for (const std::string& file : files) {
        result[file] = stampOf(file).value();
    }
    return result;
}

} // namespace

TEST_CASE("a folder's watch reports saved, new and removed files once each", "[live]") {
    Folder folder;
    const std::string file = folder.save("kernels/a.comp");
    FileWatch watch(folder.path());
    CHECK_FALSE(watch.hasChanged());
    folder.save("kernels/a.comp");
    CHECK(watch.hasChanged());
    CHECK_FALSE(watch.hasChanged());
    folder.save("lib/b.glsl");
    CHECK(watch.hasChanged());
    fs::remove(file);
    CHECK(watch.hasChanged());
    CHECK_FALSE(watch.hasChanged());
}

TEST_CASE("a save between the last poll and a new list of files is reported", "[live]") {
    Folder folder;
    const std::string scene = folder.save("scene.yaml");
    const std::string mesh = folder.save("mesh.obj");
    FileWatch watch(stamps({scene}));
    CHECK_FALSE(watch.hasChanged());
    const auto loaded = stamps({scene, mesh}); // by the worker, before it loads them
    folder.save("scene.yaml");                 // after the poll, before the list arrives
    watch.watch(loaded);
    CHECK(watch.hasChanged());
    CHECK_FALSE(watch.hasChanged());
}

TEST_CASE("a save of a new file while the scene loads is reported", "[live]") {
    Folder folder;
    const std::string scene = folder.save("scene.yaml");
    const std::string mesh = folder.save("mesh.obj");
    FileWatch watch(stamps({scene}));
    const auto loaded = stamps({scene, mesh});
    folder.save("mesh.obj"); // the worker may or may not have read it already
    CHECK_FALSE(watch.hasChanged());
    watch.watch(loaded);
    CHECK(watch.hasChanged());
}

TEST_CASE("a change that was reported while the scene loaded is not reported again", "[live]") {
    Folder folder;
    const std::string scene = folder.save("scene.yaml");
    FileWatch watch(stamps({scene}));
    const auto loaded = stamps({scene});
    folder.save("scene.yaml");
    CHECK(watch.hasChanged());
    watch.watch(loaded);
    CHECK_FALSE(watch.hasChanged());
}

TEST_CASE("a watched file may appear and vanish", "[live]") {
    Folder folder;
    const std::string scene = folder.save("scene.yaml");
    FileWatch watch(stamps({scene}));
    fs::remove(scene);
    CHECK(watch.hasChanged());
    CHECK_FALSE(watch.hasChanged());
    folder.save("scene.yaml");
    CHECK(watch.hasChanged());
}

TEST_CASE("a scene's files are those that it names, and those that its glTF files name", "[live]") {
    Folder folder;
    const std::string scene = folder.save("scene.yaml", "shapes:\n  - {mesh: models/room.gltf}\n  - {mesh: gone.obj}\n"
                                                        "note: [wood.png, 'no file']\n");
    const std::string gltf = folder.save("models/room.gltf", R"({"buffers": [{"uri": "room.bin"}]})");
    const std::string buffer = folder.save("models/room.bin");
    const std::string texture = folder.save("wood.png");
    folder.save("unnamed.png");
    CHECK(stampsOfScene(scene) == stamps({scene, gltf, buffer, texture}));
    // A file that does not parse is watched still
    folder.save("scene.yaml", "shapes: [");
    CHECK(stampsOfScene(scene) == stamps({scene}));
    CHECK(stampsOfNamedFiles({{"render.filter_file", "wood.png"}, {"render.photons", "5"}}, folder.path()) ==
          stamps({texture}));
}
