// Checked build only: an index out of range is found, and reported with the information needed to fix it.
#include "base/error.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite;
using testing::Gpu;

TEST_CASE("an index out of range is reported with its kernel, place and thread", "[checked]") {
    struct Arguments {
        std::uint64_t values;
        std::uint32_t count;
    };
    Gpu& device = Gpu::shared();
    const std::vector<std::uint32_t> values(10, 7);
    const gpu::Array<std::uint32_t> array(device.context(), std::span(values), "values");
    const auto run = [&](const std::string& name, const std::string& body) -> std::string {
        const testing::TemporaryShaders folder;
        folder.writeKernel(name, "UintArray values;", body);
        const gpu::Kernel kernel(device.context(), device.tables(), gpu::ShaderCompiler(folder.shaders()), name);
        gpu::Commands commands(device.context(), device.tables());
        try {
            commands.run(kernel, Arguments{array.buffer().address(), 10}, 10);
            commands.finish();
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    CHECK(run("inside", "args.values.at[i] = args.values.at[9u - i] + 1u;").empty());
    const std::string write = run("write_outside", "args.values.at[i < 9u ? i : 10u] = 1u;");
    CHECK(write.find("kernel 'write_outside': kernels/write_outside.comp:") == 0);
    CHECK(write.find("index 10 of an array of 10, in thread 9") != std::string::npos);
    const std::string read = run("read_outside", "uint own[4];\nown[i & 3u] = i;\nargs.values.at[i] = own[i];");
    CHECK(read.find("index 4 of an array of 4, in thread 4") != std::string::npos);
}
