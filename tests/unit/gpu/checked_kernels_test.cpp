// The checked build's rewriting of shaders: every access gets its check, and the rest is unchanged.
#include "gpu/checked_kernels.h"

#include <catch2/catch_test_macros.hpp>

#include <string>

using namespace hyalite;

TEST_CASE("every access gets a check, with its line and file", "[checked]") {
    const auto rewritten = [](const std::string& text) { return gpu::withBoundChecks(text, 2); };
    CHECK(rewritten("a = args.x.at[i];\n") ==
          "a = (args.x + checkedIndex(uvec2(args.x), uvec2(args.x + 1), uint(i), 131073u)).at [0];\n");
    // An index that is read from an array itself
    CHECK(rewritten("\nx.at[y.at[2u * k] + 1u].depth += 3u;\n") ==
          "\n(x + checkedIndex(uvec2(x), uvec2(x + 1), uint((y + checkedIndex(uvec2(y), uvec2(y + 1), uint(2u * k), "
          "131074u)).at [0] + 1u), 131074u)).at [0].depth += 3u;\n");
    // Over several lines
    CHECK(rewritten("f(a[1], b.at[\n  c]);\n") ==
          "f(a[1], (b + checkedIndex(uvec2(b), uvec2(b + 1), uint(\n  c), 131073u)).at [0]);\n");
    CHECK(rewritten("vec4 t = texelFetch(nodeTable, base + 1).xy;\n") ==
          "vec4 t = texelFetch(nodeTable, checkedTexel(nodeTable, int( base + 1), 131073u)).xy;\n");
    CHECK(rewritten("uint rest[8];\nuint last = rest[top - 1u];\n") ==
          "uint rest[8];\nuint last = rest[checkedEntry(uint(top - 1u), uint(rest.length()), 131074u)];\n");
    CHECK(rewritten("float t[kMany];\nreturn t[i];\n") ==
          "float t[kMany];\nreturn t[checkedEntry(uint(i), uint(t.length()), 131074u)];\n");
    // Components of vectors, and text that is no code
    for (const std::string same : {"v[axis] = m[1][2];\n", "// x.at[i]\n", "#define X(a) a.at[0]\n", "uint at[];\n"}) {
        CHECK(rewritten(same) == same);
    }
}
