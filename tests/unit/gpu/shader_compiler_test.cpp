// GLSL to SPIR-V: places of errors, allowed includes, and validity of the cache.
#include "base/error.h"
#include "gpu/kernel.h"
#include "gpu/shader_compiler.h"
#include "gpu/shader_sources.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <spirv-tools/libspirv.h>

using namespace hyalite;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::EndsWith;
using gpu::ShaderCompiler;
using testing::TemporaryShaders;
namespace fs = std::filesystem;

namespace {

Error compileError(const TemporaryShaders& folder, const std::string& kernel) {
    try {
        static_cast<void>(ShaderCompiler(folder.shaders()).compile(kernel));
    } catch (const Error& error) {
        return error;
    }
    return {ExitCode::Done, "no error"};
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) {
        files.push_back(entry.path());
    }
    return files;
}

// Two kernels that differ, compiled into a cache of their own.
struct CachedKernels {
    TemporaryShaders folder;
    fs::path cache = folder.root() / "cache" / "spirv";
    ShaderCompiler compiler{folder.shaders(), cache};
    gpu::SpirV one;
    fs::path file; // the cache's entry of `one`

    CachedKernels() {
        folder.writeKernel("one", "", "");
        one = compiler.compile("one");
        file = filesIn(cache).at(0);
    }
};

} // namespace

// A partial copy would compile without the missing part.
static_assert(std::is_final_v<ShaderCompiler> && !std::is_copy_constructible_v<gpu::KernelCompiler>);

TEST_CASE("a compile error names the kernel, the file and the line", "[shader]") {
    const TemporaryShaders folder;
    folder.write("kernels/broken.comp",
                 "#version 460\n#include \"lib/thread.glsl\"\n\nvoid main() {\n    nonsense;\n}\n");
    const Error error = compileError(folder, "broken");
    CHECK(error.code() == ExitCode::BadInput);
    CHECK_THAT(error.where().file, EndsWith("kernels/broken.comp"));
    CHECK(error.where().line == 5); // counted in the text above
    CHECK_THAT(error.what(), ContainsSubstring("kernel 'broken'") && ContainsSubstring("nonsense"));
}

TEST_CASE("an error in an included file is reported in that file", "[shader]") {
    const TemporaryShaders folder;
    folder.write("lib/wrong.glsl", "\n\nfloat f() { return missingName; }\n");
    folder.write("kernels/including.comp", "#version 460\n#include \"lib/thread.glsl\"\n#include \"lib/wrong.glsl\"\n"
                                           "void main() {}\n");
    const Error error = compileError(folder, "including");
    CHECK_THAT(error.where().file, EndsWith("lib/wrong.glsl"));
    CHECK(error.where().line == 3);
    CHECK_THAT(error.what(), ContainsSubstring("kernel 'including'") && ContainsSubstring("missingName"));
}

TEST_CASE("an include is first searched beside the including file", "[shader]") {
    const TemporaryShaders folder;
    folder.write("lib/inner/value.glsl", "const uint kValue = 1u;\n");
    folder.write("value.glsl", "#error the one at the top was taken\n");
    folder.write("lib/inner/user.glsl", "#include \"value.glsl\"\n");
    folder.write("kernels/nested.comp", "#version 460\n#include \"lib/thread.glsl\"\n#include \"lib/inner/user.glsl\"\n"
                                        "void main() { uint x = kValue; }\n");
    CHECK_NOTHROW(ShaderCompiler(folder.shaders()).compile("nested"));
}

TEST_CASE("a kernel reaches a file that needs a name only if one of its files defines that name", "[shader]") {
    const TemporaryShaders folder;
    folder.write("lib/list.h",
                 "#ifdef HYALITE_MODELS\n#include \"lib/model.glsl\"\n#endif\n#include \"lib/thread.glsl\"\n");
    folder.write("lib/model.glsl", "const uint kModel = 1u;\n");
    folder.write("lib/all.glsl", "#define HYALITE_MODELS\n#include \"lib/list.h\"\n#undef HYALITE_MODELS\n");
    folder.write("kernels/one.comp", "#version 460\n#include \"lib/list.h\"\nvoid main() {}\n");
    // The name is defined after the list has been read, too
    folder.write("kernels/many.comp",
                 "#version 460\n#include \"lib/list.h\"\n#include \"lib/all.glsl\"\nvoid main() {}\n");
    const gpu::ShaderSources sources(folder.shaders());
    const auto reaches = [&](const char* kernel) {
        const auto texts = sources.reach(folder.shaders() / "kernels" / kernel);
        return texts.contains((folder.shaders() / "lib/model.glsl").lexically_normal().string());
    };
    CHECK_FALSE(reaches("one.comp"));
    CHECK(reaches("many.comp"));
}

TEST_CASE("a file outside the shaders folder is never included", "[shader]") {
    const TemporaryShaders folder;
    testing::writeFile(folder.root() / "secret.glsl", "const uint kValue = 1u;\n");
    fs::create_symlink(folder.root() / "secret.glsl", folder.shaders() / "lib" / "link.glsl");
    const std::vector<std::string> names{"../../secret.glsl", (folder.root() / "secret.glsl").string(), "lib/link.glsl",
                                         "lib/absent.glsl"};
    for (const std::string& name : names) {
        INFO(name);
        folder.write("kernels/escape.comp", "#version 460\n#include \"" + name + "\"\nvoid main() {}\n");
        const Error error = compileError(folder, "escape");
        CHECK(error.code() == ExitCode::BadInput);
        CHECK_THAT(error.where().file, EndsWith("kernels/escape.comp"));
        CHECK(error.where().line == 2);
        CHECK_THAT(error.what(), ContainsSubstring(name));
    }
}

TEST_CASE("a missing kernel is bad input", "[shader]") {
    const TemporaryShaders folder;
    const Error error = compileError(folder, "no_such_kernel");
    CHECK(error.code() == ExitCode::BadInput);
    CHECK_THAT(error.what(), ContainsSubstring("no_such_kernel"));
}

TEST_CASE("the cache gives the same SPIR-V as the compiler and is used if nothing changed", "[shader]") {
    const CachedKernels kernels;
    CHECK(kernels.one == ShaderCompiler(kernels.folder.shaders()).compile("one"));
    // The other kernel's entry, stored under the first one's name, is returned: so the cache was used.
    kernels.folder.writeKernel("two", "uint extra;", "");
    const gpu::SpirV two = kernels.compiler.compile("two");
    REQUIRE(two != kernels.one);
    for (const fs::path& file : filesIn(kernels.cache)) {
        if (file != kernels.file) {
            fs::copy_file(file, kernels.file, fs::copy_options::overwrite_existing);
        }
    }
    CHECK(kernels.compiler.compile("one") == two);
}

TEST_CASE("a change in an included file is compiled despite the cache", "[shader]") {
    const CachedKernels kernels;
    const std::string limits = testing::readFile(kernels.folder.shaders() / "shared/limits.h");
    kernels.folder.replace("shared/limits.h", "kGroupSize = 64u", "kGroupSize = 32u");
    CHECK(gpu::reflect(kernels.compiler.compile("one")).localSize == 32);
    kernels.folder.write("shared/limits.h", limits);
    CHECK(gpu::reflect(kernels.compiler.compile("one")).localSize == 64);
}

TEST_CASE("kernels from other compiler versions are recompiled", "[shader]") {
    const std::string versions = gpu::compilerVersions();
    CHECK_THAT(versions, ContainsSubstring("glslang ") && ContainsSubstring(spvSoftwareVersionString()));
    const CachedKernels kernels;
    const ShaderCompiler newer{kernels.folder.shaders(), kernels.cache, {}, versions + "1"};
    CHECK(newer.nameInCache("one") != kernels.compiler.nameInCache("one"));
    CHECK(ShaderCompiler(kernels.folder.shaders(), kernels.cache).nameInCache("one") ==
          kernels.compiler.nameInCache("one"));
    // A kernel with values in place of its constants goes through the optimizer, too
    static_cast<void>(kernels.compiler.specialized("one", kernels.one, {}));
    const std::size_t kept = filesIn(kernels.cache).size();
    static_cast<void>(newer.specialized("one", kernels.one, {}));
    CHECK(filesIn(kernels.cache).size() == kept + 1);
}

TEST_CASE("a damaged cache entry is recompiled and replaced", "[shader]") {
    const CachedKernels kernels;
    const std::string sound = testing::readFile(kernels.file);
    std::string flipped = sound;
    flipped[flipped.size() / 2] = char(flipped[flipped.size() / 2] ^ 1);
    std::string wrongMagic = sound;
    wrongMagic[0] = 'x';
    for (const std::string& damaged :
         {flipped, wrongMagic, sound + "tail", sound.substr(0, sound.size() - 4), sound.substr(0, 5), std::string()}) {
        testing::writeFile(kernels.file, damaged);
        CHECK(kernels.compiler.compile("one") == kernels.one);
        CHECK(testing::readFile(kernels.file) == sound);
    }
}

TEST_CASE("a cache that cannot be written does not stop the compiler", "[shader]") {
    const CachedKernels kernels;
    // A file stands where the folder should be.
    const fs::path blocked = kernels.folder.root() / "blocked";
    testing::writeFile(blocked, "not a folder");
    CHECK(ShaderCompiler(kernels.folder.shaders(), blocked / "cache").compile("one") == kernels.one);
}

TEST_CASE("the cache leaves no temporary files behind", "[shader]") {
    const CachedKernels kernels;
    CHECK(filesIn(kernels.cache).size() == 1);
}

TEST_CASE("constant values remove the code that they make unreachable", "[shader]") {
    const CachedKernels kernels;
    kernels.folder.writeKernel(
        "chosen", "UintArray values;",
        "if (kWays == 3u && kWide) { for (uint n = i; n > 1u; n /= 3u) { args.values.at[n] = n; } }"
        " else { args.values.at[i] = 1u; }",
        "layout(constant_id = 2) const uint kWays = 3u;\n"
        "layout(constant_id = 4) const bool kWide = true;");
    const gpu::SpirV general = kernels.compiler.compile("chosen");
    const auto with = [&](std::uint32_t ways, std::uint32_t wide) {
        return kernels.compiler.specialized("chosen", general, {{2, ways}, {4, wide}});
    };
    const gpu::SpirV both = with(3, 1);
    CHECK(gpu::reflect(both).specializationConstants.empty());
    CHECK(with(3, 0).size() < both.size());
    CHECK(with(2, 1).size() < both.size());
    const std::size_t kept = filesIn(kernels.cache).size();
    CHECK(with(3, 1) == both);
    CHECK(filesIn(kernels.cache).size() == kept); // it was there
}
