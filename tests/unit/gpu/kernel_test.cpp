// Kernel reflection, rejected kernels, and specialization.
#include "base/error.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace hyalite;
using Catch::Matchers::ContainsSubstring;
using gpu::Kernel;
using gpu::ShaderCompiler;
using testing::Gpu;
using testing::TemporaryShaders;

namespace {

struct WriteConstantsArguments {
    std::uint64_t values; // out
    std::uint32_t count;
};

// A kernel that writes its two constants; 5 and false unless specialised.
void writeConstantsKernel(const TemporaryShaders& folder) {
    folder.writeKernel("write_constants", "UintArray values;",
                       "args.values.at[0] = kNumber;\nargs.values.at[1] = kSwitch ? 1u : 0u;",
                       "layout(constant_id = 3) const uint kNumber = 5u;\n"
                       "layout(constant_id = 8) const bool kSwitch = false;");
}

std::vector<std::uint32_t> constantsWith(const gpu::Specialization& specialization) {
    const TemporaryShaders folder;
    writeConstantsKernel(folder);
    Gpu& device = Gpu::shared();
    const Kernel kernel(device.context(), device.tables(), ShaderCompiler(folder.shaders()), "write_constants",
                        specialization);
    const gpu::Array<std::uint32_t> values(device.context(), 2, "values");
    gpu::Commands commands(device.context(), device.tables());
    commands.run(kernel, WriteConstantsArguments{values.buffer().address(), 1}, 1);
    commands.finish();
    return values.read();
}

Kernel makeKernel(const TemporaryShaders& folder, const std::string& name) {
    return {Gpu::shared().context(), Gpu::shared().tables(), ShaderCompiler(folder.shaders()), name};
}

} // namespace

TEST_CASE("reflection reads sizes, members, strides and specialization constants", "[kernel]") {
    const TemporaryShaders folder;
    folder.writeKernel("reflected", "RayArray rays;\n    CameraPath path;\n    vec3 colors[2];",
                       "args.rays.at[i].tMax = kScale ? 1.0 : 2.0;",
                       "layout(constant_id = 2) const bool kScale = true;");
    const gpu::KernelInterface interface = gpu::reflect(ShaderCompiler(folder.shaders()).compile("reflected"));
    CHECK(interface.localSize == 64);
    // kWorkers is lib/thread.glsl's
    CHECK(interface.specializationConstants == std::map<std::string, std::uint32_t>{{"kScale", 2}, {"kWorkers", 15}});
    // Scalar layout: address 8, beta 12, pixel 4, samplerSeed 4, media 4, pdfW 4, two colors 24, count 4: 64 bytes, a
    // multiple of 8.
    CHECK(interface.pushConstantBytes == 64);
    const auto& members = interface.structs.at("Arguments");
    REQUIRE(members.size() == 8);
    CHECK(members[1].name == "path.beta");
    CHECK(members[1].offset == 8);
    CHECK(members[1].size == 12);
    CHECK(members[3].name == "path.samplerSeed");
    CHECK(members[3].offset == 24);
    CHECK(members[6].name == "colors");
    CHECK(members[6].offset == 36);
    CHECK(members[6].size == 24);
    // Ray: two vec3, a float and an integer.
    CHECK(interface.arrayStrides == std::map<std::string, std::uint32_t>{{"Ray", 32}});
    CHECK(interface.structs.at("Ray").size() == 4);
}

TEST_CASE("specialization constants keep their defaults unless named", "[kernel]") {
    using Values = std::vector<std::uint32_t>;
    CHECK(constantsWith({}) == Values{5, 0});
    CHECK(constantsWith({{"kNumber", 77}}) == Values{77, 0});
    CHECK(constantsWith({{"kSwitch", 1}, {"kNumber", 9}}) == Values{9, 1});
}

TEST_CASE("a specialization that the kernel does not have is ignored", "[kernel]") {
    CHECK(constantsWith({{"kHasSomethingElse", 1}}) == std::vector<std::uint32_t>{5, 0});
}

TEST_CASE("an error in a kernel created in the background is thrown at its first use", "[kernel]") {
    const TemporaryShaders folder;
    writeConstantsKernel(folder);
    folder.writeKernel("wrong", "", "int x = ;");
    Gpu& device = Gpu::shared();
    const ShaderCompiler compiler(folder.shaders());
    const auto make = [&](const std::string& name) {
        return Kernel::inBackground(device.context(), device.tables(), compiler, name);
    };
    const Kernel wrong = make("wrong");
    const Kernel right = make("write_constants");
    const Kernel same = right; // NOLINT(performance-unnecessary-copy-initialization): the copy is what is tested
    CHECK(&same.impl() == &right.impl());
    CHECK(right.interface().pushConstantBytes == 16); // an address and a count, rounded up
    for (int use = 0; use < 2; ++use) {
        CHECK_THROWS_WITH(wrong.interface(), ContainsSubstring("'wrong'") && ContainsSubstring("syntax error"));
    }
}

TEST_CASE("a kernel with another workgroup size is refused", "[kernel]") {
    const TemporaryShaders folder;
    folder.writeKernel("narrow", "", "");
    folder.replace("shared/limits.h", "kGroupSize = 64u", "kGroupSize = 16u");
    CHECK_THROWS_WITH(makeKernel(folder, "narrow"), ContainsSubstring("'narrow'") && ContainsSubstring("16 threads"));
}

TEST_CASE("a kernel without arguments is refused", "[kernel]") {
    const TemporaryShaders folder;
    folder.write("kernels/silent.comp", "#version 460\n#include \"lib/thread.glsl\"\nvoid main() {}\n");
    CHECK_THROWS_WITH(makeKernel(folder, "silent"), ContainsSubstring("'silent'") && ContainsSubstring("no arguments"));
}

TEST_CASE("arguments of another size than the kernel's are refused", "[kernel]") {
    const TemporaryShaders folder;
    writeConstantsKernel(folder);
    const Kernel kernel = makeKernel(folder, "write_constants");
    gpu::Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    CHECK_THROWS_WITH(commands.run(kernel, std::uint32_t(0), 1), ContainsSubstring("16 bytes of arguments, not 4"));
}

TEST_CASE("a kernel that reads a missing table is refused", "[kernel]") {
    const TemporaryShaders folder;
    folder.writeKernel("astray", "UintArray values;", "args.values.at[i] = texelFetch(table, 0).x;",
                       "layout(set = 0, binding = 7) uniform usamplerBuffer table;");
    CHECK(gpu::reflect(ShaderCompiler(folder.shaders()).compile("astray")).tables ==
          std::map<std::uint32_t, gpu::TexelFormat>{{7, gpu::TexelFormat::Uint4}});
    CHECK_THROWS_WITH(makeKernel(folder, "astray"), ContainsSubstring("'astray'") && ContainsSubstring("table 7"));
}

TEST_CASE("a kernel that binds anything but texel tables is refused", "[kernel]") {
    const TemporaryShaders folder;
    folder.writeKernel("bound", "", "data[i] = 0u;", "layout(set = 0, binding = 0) buffer Data { uint data[]; };");
    CHECK_THROWS_WITH(makeKernel(folder, "bound"), ContainsSubstring("texel tables only"));
}

TEST_CASE("a table set in another format than the kernel reads is refused", "[kernel]") {
    const TemporaryShaders folder;
    folder.writeKernel("read_words", "UintArray values;", "args.values.at[i] = texelFetch(table, 0).x;",
                       "layout(set = 0, binding = 0) uniform usamplerBuffer table;");
    const gpu::Context& context = Gpu::shared().context();
    gpu::TexelTables tables(context, 1); // Float4 unless set
    const Kernel kernel(context, tables, ShaderCompiler(folder.shaders()), "read_words");
    const gpu::Array<std::uint32_t> values(context, 1, "values");
    const WriteConstantsArguments arguments{values.buffer().address(), 1};
    gpu::Commands commands(context, tables);
    CHECK_THROWS_WITH(commands.run(kernel, arguments, 1), ContainsSubstring("table 0 in another format"));
    tables.set(0, {}, gpu::TexelFormat::Uint4);
    CHECK_NOTHROW(commands.run(kernel, arguments, 1));
}
