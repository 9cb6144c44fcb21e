// Waiting for a device that does not finish ends, and says for what.
#include "gpu/watchdog.h"

#include "base/error.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>

using namespace hyalite;
using testing::Gpu;

TEST_CASE("a wait of any number of seconds is one that Vulkan can count", "[watchdog]") {
    CHECK(gpu::nanoseconds(1800) == 1'800'000'000'000U);
    CHECK(gpu::nanoseconds(0.5e-9) == 0);
    CHECK(gpu::nanoseconds(-1) == 0);
    constexpr auto kEndless = std::numeric_limits<std::uint64_t>::max();
    // 2^64 ns are 18446744073.709551616 s: what is converted stays below
    CHECK(gpu::nanoseconds(18446744073) < kEndless);
    CHECK(gpu::nanoseconds(0x1p33) == 8'589'934'592'000'000'000U); // 2^42 5^9: exact in a double
    CHECK(gpu::nanoseconds(18446744074) == kEndless);
    CHECK(gpu::nanoseconds(1e300) == kEndless);
    CHECK(gpu::nanoseconds(std::numeric_limits<double>::infinity()) == kEndless);
}

TEST_CASE("work that takes longer than the watchdog allows is an error that names its stages", "[watchdog]") {
    const testing::TemporaryShaders folder;
    folder.writeKernel("spin", "UintArray values;",
                       "uint x = i;\n"
                       "for (uint k = 0u; k < args.values.at[0]; ++k) { x = x * 1664525u + 1013904223u; }\n"
                       "args.values.at[1u + i] = x;");
    Gpu& device = Gpu::shared();
    const gpu::Kernel kernel(device.context(), device.tables(), gpu::ShaderCompiler(folder.shaders()), "spin");
    // A chain of 2^25 multiplications, of three cycles each or more, takes 0.02 s at 5 GHz
    const std::vector<std::uint32_t> values{1U << 25U, 0};
    const gpu::Array<std::uint32_t> array(device.context(), std::span(values), "values", gpu::Memory::Host);
    struct Arguments {
        std::uint64_t values;
        std::uint32_t count;
    };
    std::string told;
    gpu::setWatchdog(device.context(), {.limit = 0.01, .onStuck = [&](const std::string& what) { told = what; }});
    {
        gpu::Commands commands(device.context(), device.tables());
        try {
            commands.run(kernel, Arguments{array.buffer().address(), 1}, 1); // the checked build waits here already
            commands.finish();
            FAIL("nothing was thrown");
        } catch (const Error& error) {
            CHECK(error.code() == ExitCode::Device);
            CHECK(std::string(error.what()).find("has not finished within 0.01 s") != std::string::npos);
            CHECK(std::string(error.what()).find("spin") != std::string::npos);
            CHECK(told == error.what());
        }
    } // waits for the work
    gpu::setWatchdog(device.context(), {});
    gpu::Commands commands(device.context(), device.tables());
    array.host()[0] = 1;
    commands.run(kernel, Arguments{array.buffer().address(), 1}, 1);
    commands.finish();
    CHECK(array.host()[1] == 1013904223U); // one round, from 0
}
