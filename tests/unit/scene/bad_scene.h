// Scenes with one mistake, and the check that it is reported: with its place, what is wrong and the exit code for bad
// input. The place is the dollar sign in the text.
#pragma once

#include "unit/scene/scene_test_support.h"

#include <catch2/matchers/catch_matchers_string.hpp>
#include <initializer_list>

namespace hyalite::test {

// A mistake in a scene, what the message must contain and what its hint.
struct BadScene {
    std::string marked;
    std::string what;
    std::string hint = {};
    std::string mesh = {}; // bytes of mesh.obj beside it
};

inline void checkReported(const BadScene& bad) {
    INFO(bad.marked);
    TemporaryFolder folder;
    if (!bad.mesh.empty()) {
        folder.write("mesh.obj", bad.mesh);
    }
    const MarkedText scene(bad.marked);
    const auto file = folder.write("scene.yaml", scene.text);
    const auto error = errorOf([&] { return loadScene(file); });
    REQUIRE(error.has_value());
    INFO(error->what());
    CHECK(error->code() == ExitCode::BadInput);
    CHECK(error->where().file == file.string());
    CHECK(error->where().line == scene.line);
    CHECK(error->where().column == scene.column);
    CHECK_THAT(error->what(), Catch::Matchers::ContainsSubstring(bad.what));
    CHECK_THAT(error->hint(), Catch::Matchers::ContainsSubstring(bad.hint));
    CHECK(std::string(error->what()).find('\n') == std::string::npos);
}

inline void checkAll(std::initializer_list<BadScene> scenes) {
    for (const BadScene& bad : scenes) {
        checkReported(bad);
    }
}

// A scene of this one object.
inline std::string withObject(const std::string& object) {
    return "hyalite: 1\nlights: [{type: point, position: [0, 1, 0]}]\nmaterials: {gray: {type: diffuse}}\n"
           "objects:\n  - " +
           object + "\n";
}

} // namespace hyalite::test
