// Division by way of floats, on the device, against division.
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cstdint>
#include <random>

using namespace hyalite;
using testing::Gpu;

namespace {

struct QuotientArguments {
    std::uint64_t dividends; // in, and out the quotients
    std::uint64_t divisors;
    std::uint32_t count;
};

struct Divisions {
    std::vector<std::uint32_t> dividends;
    std::vector<std::uint32_t> divisors;
};

// Divisors of every size, and dividends on either side of a multiple, where the float's quotient may be the wrong one.
Divisions divisions() {
    std::mt19937 engine(3);
    Divisions all;
    for (int i = 0; i < 200000; ++i) {
        const auto b = 1 + static_cast<std::uint32_t>(engine() >> (2 + engine() % 30)); // to 2^30
        const std::uint64_t most = std::min<std::uint64_t>(UINT32_MAX, (std::uint64_t{b} << 20U) - 1);
        const auto a = static_cast<std::uint32_t>(engine() % (most + 1));
        const std::uint32_t multiple = a / b * b;
        for (const std::uint32_t dividend : {a, multiple, multiple - (multiple > 0 ? 1 : 0)}) {
            all.dividends.push_back(dividend);
            all.divisors.push_back(b);
        }
    }
    return all;
}

} // namespace

TEST_CASE("the quotient by way of floats is that of integers") {
    const testing::TemporaryShaders folder;
    folder.writeKernel("divide", "UintArray dividends;\nUintArray divisors;",
                       "args.dividends.at[i] = quotient(args.dividends.at[i], args.divisors.at[i]);",
                       "#include \"shapes/quotient.glsl\"\n");
    Gpu& gpu = Gpu::shared();
    const gpu::Kernel kernel(gpu.context(), gpu.tables(), gpu::ShaderCompiler(folder.shaders()), "divide");
    const Divisions asked = divisions();
    const auto count = static_cast<std::uint32_t>(asked.dividends.size());
    const gpu::Array<std::uint32_t> dividends(gpu.context(), std::span(asked.dividends), "dividends",
                                              gpu::Memory::Host);
    const gpu::Array<std::uint32_t> divisors(gpu.context(), std::span(asked.divisors), "divisors");
    gpu::Commands commands(gpu.context(), gpu.tables());
    commands.run(kernel, QuotientArguments{dividends.buffer().address(), divisors.buffer().address(), count}, count);
    commands.finish();
    for (std::uint32_t i = 0; i < count; ++i) {
        REQUIRE(dividends.host()[i] == asked.dividends[i] / asked.divisors[i]);
    }
}
