// Silent validation layers prove something only if their messages are received.
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite;

TEST_CASE("a mistake found by the validation layer is counted and forwarded", "[validation]") {
    REQUIRE(gpu::validationLayerInstalled());
    std::vector<std::string> heard;
    const gpu::Context context({.device = {},
                                .validation = true,
                                .onValidationMessage = [&heard](const std::string& text) { heard.push_back(text); }});
    const testing::TemporaryShaders folder;
    folder.writeKernel("read_texel", "UintArray values;", "args.values.at[i] = texelFetch(table, 0).x;",
                       "layout(set = 0, binding = 0) uniform usamplerBuffer table;");
    const gpu::Array<std::uint32_t> values(context, 4, "values");
    gpu::TexelTables tables(context, 1);
    tables.set(0, values.buffer(), gpu::TexelFormat::Uint4);
    const gpu::Kernel kernel(context, tables, gpu::ShaderCompiler(folder.shaders()), "read_texel");
    gpu::Commands commands(context, tables);
    struct Arguments {
        std::uint64_t values;
        std::uint32_t count;
    };
    commands.run(kernel, Arguments{values.buffer().address(), 1}, 1);
    CHECK(context.validationMessages() == 0);
    // The mistake: to change the set between run and finish. (The same view again, so that no driver minds.)
    tables.set(0, values.buffer(), gpu::TexelFormat::Uint4);
    commands.finish();
    CHECK(context.validationMessages() > 0);
    CHECK(heard.size() == context.validationMessages());
}
