// Random damage to good files: whatever the bytes, the loader returns a scene or throws hyalite::Error. The seed is
// fixed, so that a failure repeats.
#include "unit/scene/scene_test_support.h"

#include "scene/import/mesh_import.h"

#include <array>
#include <random>

using namespace hyalite;
using namespace hyalite::test;

namespace {

class Mutator {
public:
    explicit Mutator(std::uint32_t seed) : random_(seed) {}

    // One to four edits: bytes changed, removed, doubled, moved, or replaced by something that parsers trip over.
    std::string mutate(std::string text) {
        const std::size_t edits = 1 + below(4);
        for (std::size_t i = 0; i < edits && !text.empty(); ++i) {
            const std::size_t at = below(text.size());
            const std::size_t length = std::min(1 + below(12), text.size() - at);
            switch (below(6)) {
            case 0:
                text[at] = static_cast<char>(below(256));
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, text.substr(at, length));
                break;
            case 3:
                text.insert(below(text.size()), text.substr(at, length));
                break;
            case 4:
                text.replace(at, length, kTrouble[below(kTrouble.size())]);
                break;
            default:
                text.resize(at);
                break;
            }
        }
        return text;
    }

private:
    std::size_t below(std::size_t end) { return random_() % end; }

    static constexpr std::array<std::string_view, 28> kTrouble{
        "{",       "}",  "[",   "]",   ":",      "-",     "- ",  "&a", "*a",
        "!",       "!!", "|",   ">",   "'",      "\"",    "#",   "%",  "?",
        "\t",      "\n", "---", "...", "<<: *a", "1e999", "nan", "-1", "99999999999999999999",
        "\xff\xfe"};
    std::mt19937 random_; // its numbers, unlike the distributions', are the same with every library
};

// Loads a number of damaged copies; returns how many were refused. Anything but Error propagates and fails the test.
template <class Load>
int countRefused(const std::string& good, std::uint32_t seed, int copies, const Load& load) {
    Mutator mutator(seed);
    int refused = 0;
    for (int i = 0; i < copies; ++i) {
        const std::string bad = mutator.mutate(good);
        INFO("copy " << i << " of seed " << seed << ":\n" << bad);
        refused += errorOf([&] { load(bad); }) ? 1 : 0;
    }
    return refused;
}

// Every shape, and csg in csg.
constexpr std::string_view kSolids = R"(hyalite: 1
lights: [{type: point, position: [0, 9, 0]}]
materials: {a: {type: diffuse}, b: {type: mirror}}
objects:
  - {material: a, shape: {type: plane, point: [0, -1, 0], normal: [0, 1, 0]}}
  - {material: a, shape: {type: disk, center: [0, 2, 0], normal: [0, -1, 1], radius: 0.5}, transform: [{scale: [2, 1, 1]}]}
  - {material: a, shape: {type: cone, base: [0, 0, 0], top: [0, 1, 1], radius: 0.5, top_radius: 0.25, open: true}}
  - {material: b, shape: {type: torus, axis: [1, 1, 0], major: 2, minor: 0.5}}
  - {material: b, shape: {type: paraboloid, radii: [1, 2, 3], clip: {max: [null, 4, null]}, caps: false}}
  - {material: b, shape: {type: quadric, coefficients: [1, 0.5, 0, 0, 2, 0, 0, 1, 0, -1], clip: {min: [0, null, -1]}}}
  - material: a
    shape:
      type: csg
      op: difference
      cut_material: b
      shapes:
        - type: csg
          op: intersection
          left: {type: box, min: [-1, -1, -1], max: [1, 1, 1], transform: [{rotate: {axis: [0, 1, 0], degrees: 45}}]}
          right: {type: sphere, radius: 1.25, material: b}
        - {type: cylinder, base: [0, -2, 0], top: [0, 2, 0], radius: 0.5}
        - {type: mesh, file: models/icosahedron.obj, transform: [{scale: 0.5}]}
)";

} // namespace

TEST_CASE("damaged scene files load or are refused, whatever the damage") {
    TemporaryFolder folder;
    folder.write("models/icosahedron.obj", readFile(kSourceFolder / "scenes/models/icosahedron.obj"));
    folder.write("models/uv-sphere.ply", readFile(kSourceFolder / "scenes/models/uv-sphere.ply"));
    constexpr int kCopies = 1000;
    std::uint32_t seed = 1;
    std::vector<std::string> scenes{std::string(kSolids)};
    for (const auto* name : {"cornell-caustics.yaml", "tests/mesh-room.yaml", "tests/point-light-floor.yaml"}) {
        scenes.push_back(readFile(kSourceFolder / "scenes" / name));
    }
    folder.write("tests/models/icosahedron.obj", readFile(kSourceFolder / "scenes/models/icosahedron.obj"));
    for (const std::string& good : scenes) {
        static_cast<void>(loadScene(folder.write("tests/scene.yaml", good)));
        const int refused = countRefused(good, seed++, kCopies, [&](const std::string& bad) {
            static_cast<void>(loadScene(folder.write("tests/scene.yaml", bad)));
        });
        // Damage to a comment or a digit passes; most damage does not.
        CHECK(refused > kCopies / 4);
        CHECK(refused < kCopies);
    }
}

TEST_CASE("damaged mesh files load or are refused, whatever the damage") {
    constexpr int kCopies = 2000;
    const std::string obj = readFile(kSourceFolder / "scenes/models/icosahedron.obj");
    const int refusedObj =
        countRefused(obj, 11, kCopies, [](const std::string& bad) { static_cast<void>(parseObj(bad, "bad.obj")); });
    CHECK(refusedObj > kCopies / 10);

    const std::string binary = readFile(kSourceFolder / "scenes/models/uv-sphere.ply");
    const int refusedBinary =
        countRefused(binary, 12, kCopies, [](const std::string& bad) { static_cast<void>(parsePly(bad, "bad.ply")); });
    CHECK(refusedBinary > kCopies / 10);

    const std::string ascii = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
                              "float z\nelement face 2\nproperty list uchar int vertex_indices\nproperty int id\n"
                              "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 7\n4 0 1 2 3 8\n";
    const int refusedAscii =
        countRefused(ascii, 13, kCopies, [](const std::string& bad) { static_cast<void>(parsePly(bad, "bad.ply")); });
    CHECK(refusedAscii > kCopies / 10);
}
