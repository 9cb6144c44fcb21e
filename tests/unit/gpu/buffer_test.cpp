// Device memory: what goes in comes out, clears, tables, and refusals.
#include "base/error.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <array>
#include <limits>
#include <numeric>

using namespace hyalite;
using Catch::Matchers::ContainsSubstring;
using testing::Gpu;
using Words = std::vector<std::uint32_t>;

namespace {

// `count` words that are all ones.
gpu::Array<std::uint32_t> onesArray(std::size_t count) {
    const Words ones(count, 0xffffffffU);
    return {Gpu::shared().context(), std::span(ones), "ones"};
}

struct ReadTableArguments {
    std::uint64_t words; // out, four per texel
    std::uint32_t count; // texels
};

// Reads back, through a kernel, texels of binding 0 of `tables` as words.
Words readTable(gpu::TexelTables& tables, const std::string& sampler, const std::string& toBits, std::uint32_t texels) {
    const testing::TemporaryShaders folder;
    folder.writeKernel("read_table", "UintArray words;",
                       "uvec4 texel = " + toBits + "(texelFetch(table, int(i)));\n" +
                           "for (uint k = 0u; k < 4u; ++k) { args.words.at[4u * i + k] = texel[k]; }",
                       "layout(set = 0, binding = 0) uniform " + sampler + " table;");
    const Gpu& device = Gpu::shared();
    const gpu::Kernel kernel(device.context(), tables, gpu::ShaderCompiler(folder.shaders()), "read_table");
    const gpu::Array<std::uint32_t> words(device.context(), 4 * std::size_t(texels), "words");
    gpu::Commands commands(device.context(), tables);
    commands.run(kernel, ReadTableArguments{words.buffer().address(), texels}, texels);
    commands.finish();
    return words.read();
}

} // namespace

TEST_CASE("an array gives back what was written to it", "[buffer]") {
    Words values(1000);
    std::iota(values.begin(), values.end(), 7U);
    const gpu::Array<std::uint32_t> array(Gpu::shared().context(), std::span<const std::uint32_t>(values), "values");
    CHECK(array.count() == 1000);
    CHECK(array.buffer().bytes() == 4000);
    CHECK(array.buffer().address() != 0);
    CHECK(array.read() == values);
}

TEST_CASE("parts of an array are read and written, and nothing beyond its end", "[buffer]") {
    const gpu::Array<std::uint32_t> array = onesArray(8);
    array.write(Words{1, 2}, 3);
    CHECK(array.read() == Words{~0U, ~0U, ~0U, 1, 2, ~0U, ~0U, ~0U});
    CHECK(array.read(4, 2) == Words{2, ~0U});
    CHECK(array.read(3) == 1);
    CHECK_THROWS_AS(array.read(7, 2), Error);
    CHECK_THROWS_AS(array.write(Words{1, 2}, 7), Error);
}

TEST_CASE("memory that the host does not see is copied: read, written, looked up by its address", "[buffer]") {
    gpu::ContextOptions options;
    options.staged = true;
    const gpu::Context context(options);
    // More than one part of a copy: 5 000 000 words are 20 MB
    Words values(5'000'000);
    std::iota(values.begin(), values.end(), 7U);
    const gpu::Array<std::uint32_t> array(context, std::span<const std::uint32_t>(values), "values");
    CHECK(array.buffer().mapped().empty());
    CHECK_THROWS_WITH(array.host(), ContainsSubstring("'values'"));
    CHECK(array.read() == values);
    array.write(Words{1, 2, 3}, 4'999'997);
    CHECK(array.read(4'999'996, 4) == Words{5'000'003, 1, 2, 3});

    const auto memory = context.memoryAt(array.buffer().address() + 4 * 4'999'998ULL);
    Words seen(2);
    REQUIRE(memory.size() == 8);
    std::memcpy(seen.data(), memory.data(), 8);
    CHECK(seen == Words{2, 3});

    const gpu::Array<std::uint32_t> onHost(context, 4, "four", gpu::Memory::Host);
    onHost.host()[3] = 5;
    CHECK(onHost.read(3) == 5);

    // … and in step with commands
    const gpu::TexelTables tables(context, 1);
    gpu::Commands commands(context, tables);
    commands.clear(array.buffer(), 8);
    commands.finish();
    CHECK(array.read(0, 3) == Words{0, 0, 9});
}

TEST_CASE("an empty array has an address and no elements", "[buffer]") {
    const gpu::Array<std::uint32_t> array(Gpu::shared().context(), 0, "nothing");
    CHECK(array.buffer().address() != 0);
    CHECK(array.read().empty());
}

TEST_CASE("a buffer without bytes, or with more than the device has, is refused by name and size", "[buffer]") {
    const gpu::Context& context = Gpu::shared().context();
    CHECK_THROWS_AS(gpu::Buffer(context, 0, "void"), Error);
    // 2^50 bytes are 2^30 = 1073741824 MiB.
    const std::size_t huge = std::size_t(1) << 50U;
    CHECK_THROWS_WITH(gpu::Buffer(context, huge, "photons"),
                      ContainsSubstring("'photons'") && ContainsSubstring("1073741824.0 MiB"));
    CHECK_THROWS_AS(gpu::Buffer(context, std::numeric_limits<std::size_t>::max(), "photons"), Error);
}

TEST_CASE("clear writes zeros to the whole buffer", "[buffer]") {
    const gpu::Array<std::uint32_t> array = onesArray(999);
    gpu::Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    commands.clear(array.buffer());
    commands.finish();
    CHECK(array.read() == Words(999, 0));
}

TEST_CASE("clear of the first bytes leaves the others", "[buffer]") {
    const gpu::Array<std::uint32_t> array = onesArray(8);
    gpu::Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    commands.clear(array.buffer(), 12); // three words
    commands.finish();
    CHECK(array.read() == Words{0, 0, 0, ~0U, ~0U, ~0U, ~0U, ~0U});
    CHECK_THROWS_AS(commands.clear(array.buffer(), 3), Error);
    CHECK_THROWS_AS(commands.clear(array.buffer(), 36), Error);
}

TEST_CASE("a table shows floats and words bit by bit, and what was set last", "[buffer]") {
    const gpu::Context& context = Gpu::shared().context();
    const std::array<float, 8> floats{0.1F, -2.5F, 1e-40F, 3e38F, 5, 6, 7, 8};
    const Words words{1, 0xffffffff, 0x80000000, 0x7fc00001, 5, 6, 7, 8}; // as floats two of them would be NaN
    const gpu::Array<float> floatArray(context, std::span(floats), "floats");
    const gpu::Array<std::uint32_t> wordArray(context, std::span(words), "words");
    gpu::TexelTables tables(context, 2);
    tables.set(0, floatArray.buffer(), gpu::TexelFormat::Float4);
    Words bits(8);
    std::memcpy(bits.data(), floats.data(), sizeof(floats));
    CHECK(readTable(tables, "samplerBuffer", "floatBitsToUint", 2) == bits);
    tables.set(0, wordArray.buffer(), gpu::TexelFormat::Uint4);
    CHECK(readTable(tables, "usamplerBuffer", "uvec4", 2) == words);
}

TEST_CASE("a binding that was never set, or set to an empty buffer, holds one texel of zeros", "[buffer]") {
    gpu::TexelTables tables(Gpu::shared().context(), 1);
    CHECK(readTable(tables, "samplerBuffer", "floatBitsToUint", 1) == Words(4, 0));
    tables.set(0, gpu::Buffer(), gpu::TexelFormat::Uint4);
    CHECK(readTable(tables, "usamplerBuffer", "uvec4", 1) == Words(4, 0));
}
