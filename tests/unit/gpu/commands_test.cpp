// Runs of kernels: every thread once, in order, the same bits again, and timed by name.
#include "base/error.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers.hpp>

#include <algorithm>
#include <chrono>

using namespace hyalite;
using gpu::Array;
using gpu::Commands;
using gpu::Kernel;
using testing::Gpu;
using testing::TemporaryShaders;

namespace {

struct ValuesArguments {
    std::uint64_t values;
    std::uint32_t count;
};

// A kernel over one array of uint or float.
Kernel valuesKernel(const std::string& name, const std::string& body, const std::string& declarations = {}) {
    const TemporaryShaders folder;
    folder.writeKernel(name, "UintArray values;", body, declarations);
    return {Gpu::shared().context(), Gpu::shared().tables(), gpu::ShaderCompiler(folder.shaders()), name};
}

Array<std::uint32_t> zeros(std::uint32_t count) {
    const std::vector<std::uint32_t> values(count, 0);
    return {Gpu::shared().context(), std::span(values), "values", gpu::Memory::Host};
}

// Counts in each value how often its thread ran.
const std::string kCount = "atomicAdd(args.values.at[i], 1u);";

// As many rounds of a loop as the value says.
const std::string kSpin = "uint x = i;\n"
                          "uint rounds = args.values.at[i];\n"
                          "for (uint k = 0u; k < rounds; ++k) { x = x * 1664525u + 1013904223u; }\n"
                          "args.values.at[i] = x;";

} // namespace

TEST_CASE("every thread index comes exactly once, whatever the number of groups and rows", "[commands]") {
    const Kernel kernel = valuesKernel("count_threads", kCount);
    // One thread; a group and one; more than 65 535 groups of 64; and several rows of 32 768 * 64 = 2 097 152 threads,
    // more than one submission holds.
    for (const std::uint32_t threads : {1U, 65U, 65'536U * 64U + 1U, 9'000'001U}) {
        const Array<std::uint32_t> values = zeros(threads);
        Commands commands(Gpu::shared().context(), Gpu::shared().tables());
        commands.run(kernel, ValuesArguments{values.buffer().address(), threads}, threads);
        commands.finish();
        const auto isOne = [](std::uint32_t value) { return value == 1; };
        CHECK(std::all_of(values.host().begin(), values.host().end(), isOne));
    }
}

TEST_CASE("an observer finds the buffers of a kernel's arguments, before and after", "[commands]") {
    struct Observer : gpu::DispatchObserver {
        std::vector<std::uint32_t> seen; // the first value, before and after each dispatch
        [[nodiscard]] std::uint64_t addressOf(const gpu::Dispatch& dispatch) const {
            ValuesArguments arguments{};
            std::memcpy(&arguments, dispatch.arguments.data(), sizeof(arguments));
            return arguments.values;
        }
        void see(const gpu::Dispatch& dispatch) {
            const auto memory = Gpu::shared().context().memoryAt(addressOf(dispatch));
            REQUIRE(memory.size() == 100 * sizeof(std::uint32_t));
            seen.emplace_back();
            std::memcpy(&seen.back(), memory.data(), sizeof(std::uint32_t));
        }
        void before(const gpu::Dispatch& dispatch) override { see(dispatch); }
        void after(const gpu::Dispatch& dispatch) override { see(dispatch); }
    };
    const Kernel kernel = valuesKernel("count_observed", kCount);
    Observer observer;
    Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    std::uint64_t address = 0;
    {
        const Array<std::uint32_t> values = zeros(100);
        address = values.buffer().address();
        commands.run(kernel, ValuesArguments{address, 100}, 100); // without an observer
        {
            const gpu::Observation observation = commands.observe(observer);
            commands.run(kernel, ValuesArguments{address, 100}, 100);
            commands.run(kernel, ValuesArguments{address, 100}, 100);
        }
        commands.run(kernel, ValuesArguments{address, 100}, 100);
        commands.finish();
        CHECK(observer.seen == std::vector<std::uint32_t>{1, 2, 2, 3});
        CHECK(Gpu::shared().context().memoryAt(address + 4).size() == 99 * sizeof(std::uint32_t));
    }
    CHECK(Gpu::shared().context().memoryAt(address).empty()); // the buffer is gone
}

namespace {

struct LiveArguments {
    std::uint64_t values;
    std::uint64_t live;
    std::uint32_t count;
};

// Counts in each value how often its thread ran, of as many threads as `live` counts.
Kernel liveKernel() {
    const TemporaryShaders folder;
    folder.write("kernels/count_live.comp", R"(#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/queue.glsl"
struct CountLiveArguments {
    UintArray values;
    QueueSizeArray live;
    uint count;
};
layout(push_constant, scalar) uniform Push { CountLiveArguments args; };
void main() {
    uint i = threadIndex();
    if (i < liveCount(args.live, args.count)) {
        atomicAdd(args.values.at[i], 1u);
    }
}
)");
    return {Gpu::shared().context(), Gpu::shared().tables(), gpu::ShaderCompiler(folder.shaders()), "count_live"};
}

} // namespace

TEST_CASE("a dispatch runs the number of threads stored on the device when it begins", "[commands]") {
    const Kernel kernel = liveKernel();
    Gpu& device = Gpu::shared();
    // No thread, part of a group, the maximum; two rows of groups; more than one submission holds
    for (const auto& [count, most] :
         {std::pair{0U, 100U}, {65U, 100U}, {100U, 100U}, {2'100'000U, 3'000'000U}, {8'500'000U, 9'000'000U}}) {
        CAPTURE(count, most);
        const Array<std::uint32_t> values = zeros(most);
        const Array<shared::QueueSize> sizes(device.context(), 3, "sizes");
        sizes.fill({});
        Commands commands(device.context(), device.tables(), true);
        const std::vector<shared::QueueSize> set{{}, shared::queueSize(count, 0)};
        commands.set(sizes, std::span<const shared::QueueSize>(set)); // recorded, like what a kernel writes
        const gpu::ThreadCount threads(sizes, 1, most);
        commands.run(kernel, LiveArguments{values.buffer().address(), threads.live().address, most}, threads);
        commands.finish();
        const std::vector<std::uint32_t> ran = values.read();
        CHECK(std::count(ran.begin(), ran.end(), 1U) == count);
        CHECK((count == 0 || ran[count - 1] == 1));
        // Empty dispatches are not recorded
        CHECK(commands.times().contains("count_live") == (count > 0 || most <= 8'388'608));
        if (count > 0) {
            CHECK(commands.times().at("count_live").threads == count);
            CHECK(commands.times().at("count_live").dispatches == 1);
        }
    }
}

TEST_CASE("an observer sees the number of threads that the device has, and no empty dispatch", "[commands]") {
    struct Observer : gpu::DispatchObserver {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> seen; // threads, the argument `count`
        void before(const gpu::Dispatch& dispatch) override {
            LiveArguments arguments{};
            std::memcpy(&arguments, dispatch.arguments.data(), sizeof(arguments));
            seen.emplace_back(dispatch.threads, arguments.count);
        }
        void after(const gpu::Dispatch& /*dispatch*/) override {}
    };
    const Kernel kernel = liveKernel();
    Gpu& device = Gpu::shared();
    const Array<std::uint32_t> values = zeros(1000);
    const std::vector<shared::QueueSize> set{shared::queueSize(0, 0), shared::queueSize(300, 0)};
    const Array<shared::QueueSize> sizes(device.context(), std::span<const shared::QueueSize>(set), "sizes");
    Observer observer;
    Commands commands(device.context(), device.tables());
    const gpu::Observation observation = commands.observe(observer);
    for (const std::size_t index : {0U, 1U}) {
        const gpu::ThreadCount threads(sizes, index, 1000);
        commands.run(kernel, LiveArguments{values.buffer().address(), threads.live().address, 1000}, threads);
    }
    // Dispatched with a fixed thread count, despite the size on the device
    const gpu::ThreadCount threads(sizes, 1, 1000);
    commands.run(kernel, LiveArguments{values.buffer().address(), threads.live().address, 1000}, 64);
    CHECK(observer.seen == std::vector<std::pair<std::uint32_t, std::uint32_t>>{{300, 300}, {64, 300}});
    CHECK(std::ranges::count(values.read(), 0U) == 700);
}

TEST_CASE("values that are set, and copies, stand between the kernels before and after", "[commands]") {
    const Kernel kernel = valuesKernel("count_set", kCount);
    const Array<std::uint32_t> values = zeros(100);
    const Array<std::uint32_t> kept(Gpu::shared().context(), 100, "kept");
    const ValuesArguments arguments{values.buffer().address(), 100};
    Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    commands.run(kernel, arguments, 100);
    commands.copy(values.buffer(), kept.buffer());
    commands.set(values, std::span<const std::uint32_t>(std::vector<std::uint32_t>(40, 7)));
    commands.run(kernel, arguments, 100);
    commands.finish();
    CHECK(kept.read() == std::vector<std::uint32_t>(100, 1));
    const std::vector<std::uint32_t> after = values.read();
    CHECK(std::count(after.begin(), after.begin() + 40, 8U) == 40);
    CHECK(std::count(after.begin() + 40, after.end(), 2U) == 60);
    const std::vector<std::uint32_t> tooMany(101);
    CHECK_THROWS_AS(commands.set(values, std::span<const std::uint32_t>(tooMany)), Error);
}

TEST_CASE("an observer is removed with its scope, however that ends, and may outlive the commands", "[commands]") {
    struct Observer : gpu::DispatchObserver {
        std::vector<std::string>& calls;
        std::string name;
        bool fails = false;
        Observer(std::vector<std::string>& c, std::string n) : calls(c), name(std::move(n)) {}
        void before(const gpu::Dispatch& /*dispatch*/) override {
            calls.push_back(name + " before");
            if (fails) {
                throw 7; // no Error, and no std::exception
            }
        }
        void after(const gpu::Dispatch& /*dispatch*/) override { calls.push_back(name + " after"); }
    };
    const Kernel kernel = valuesKernel("count_left", kCount);
    const Array<std::uint32_t> values = zeros(100);
    const ValuesArguments arguments{values.buffer().address(), 100};
    std::vector<std::string> calls;
    Observer first(calls, "first");
    Observer second(calls, "second");
    gpu::Observation outlasting;
    {
        Commands commands(Gpu::shared().context(), Gpu::shared().tables());
        outlasting = commands.observe(first);
        {
            const gpu::Observation inner = commands.observe(second);
            commands.run(kernel, arguments, 100);
            CHECK(calls == std::vector<std::string>{"second before", "first before", "first after", "second after"});
        }
        calls.clear();
        second.fails = true;
        try {
            const gpu::Observation inner = commands.observe(second);
            commands.run(kernel, arguments, 100);
        } catch (int) {
            commands.run(kernel, arguments, 100); // only the first observer sees it
        }
        CHECK(calls == std::vector<std::string>{"second before", "first before", "first after"});
    }
    outlasting.end(); // the commands are gone
    CHECK(values.read() == std::vector<std::uint32_t>(100, 2));
}

TEST_CASE("a dispatch in pieces covers all of it, and can be interrupted between them", "[commands]") {
    struct Observer : gpu::DispatchObserver {
        int pieces = 1;
        int most = 0; // give up before the next; 0: never
        void before(const gpu::Dispatch& /*dispatch*/) override {}
        void after(const gpu::Dispatch& /*dispatch*/) override {}
        [[nodiscard]] std::uint32_t threadsOfPiece() const override { return 1000; }
        void between() override {
            if (pieces++ == most) {
                throw std::runtime_error("enough");
            }
        }
    };
    // A piece is the largest power of two of groups of 64 threads that is no more: 8 groups, 512 threads. 10 000
    // threads are 157 groups: 19 whole pieces and 5 groups.
    const Kernel kernel = valuesKernel("count_pieces", kCount);
    const Array<std::uint32_t> values = zeros(10'000);
    Observer observer;
    Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    const gpu::Observation observation = commands.observe(observer);
    commands.run(kernel, ValuesArguments{values.buffer().address(), 10'000}, 10'000);
    CHECK(observer.pieces == 20);
    CHECK(values.read() == std::vector<std::uint32_t>(10'000, 1));

    observer.pieces = 1;
    observer.most = 2;
    CHECK_THROWS_WITH(commands.run(kernel, ValuesArguments{values.buffer().address(), 10'000}, 10'000), "enough");
    const std::vector<std::uint32_t> twice = values.read();
    CHECK(std::count(twice.begin(), twice.end(), 2U) == 1024);
    CHECK(twice[1023] == 2);
    CHECK(twice[1024] == 1);
}

TEST_CASE("a kernel sees everything that earlier kernels wrote", "[commands]") {
    // Each run adds the left neighbour, on a ring, of what the run before wrote: after n runs of x <- x + left(x) that
    // start from ones, every value is 2^n. Two arrays take turns.
    const TemporaryShaders folder;
    folder.writeKernel("add_neighbour", "UintArray from;\n    UintArray to;",
                       "args.to.at[i] = args.from.at[i] + args.from.at[(i + args.count - 1u) % args.count];");
    Gpu& device = Gpu::shared();
    const Kernel kernel(device.context(), device.tables(), gpu::ShaderCompiler(folder.shaders()), "add_neighbour");
    struct Arguments {
        std::uint64_t from;
        std::uint64_t to;
        std::uint32_t count;
    };
    constexpr std::uint32_t count = 100'000;
    const std::vector<std::uint32_t> ones(count, 1);
    const Array<std::uint32_t> a(device.context(), std::span(ones), "a");
    const Array<std::uint32_t> b(device.context(), count, "b");
    Commands commands(device.context(), device.tables());
    for (int run = 0; run < 10; ++run) {
        commands.run(kernel, Arguments{a.buffer().address(), b.buffer().address(), count}, count);
        commands.run(kernel, Arguments{b.buffer().address(), a.buffer().address(), count}, count);
    }
    commands.finish();
    CHECK(a.read() == std::vector<std::uint32_t>(count, 1U << 20U));
}

TEST_CASE("a clear takes effect between the kernels before and after it", "[commands]") {
    const Kernel kernel = valuesKernel("count_twice", kCount);
    const Array<std::uint32_t> values = zeros(1000);
    const ValuesArguments arguments{values.buffer().address(), 1000};
    Commands commands(Gpu::shared().context(), Gpu::shared().tables());
    commands.run(kernel, arguments, 1000);
    commands.clear(values.buffer());
    commands.run(kernel, arguments, 1000);
    commands.finish();
    CHECK(values.read() == std::vector<std::uint32_t>(1000, 1));
}

TEST_CASE("commands are used again after finish, and finish without work does nothing", "[commands]") {
    const Kernel kernel = valuesKernel("count_again", kCount);
    const Array<std::uint32_t> values = zeros(100);
    Commands commands(Gpu::shared().context(), Gpu::shared().tables(), true);
    commands.finish();
    CHECK(commands.times().empty());
    for (int run = 0; run < 3; ++run) {
        commands.run(kernel, ValuesArguments{values.buffer().address(), 100}, 100);
        commands.run(kernel, ValuesArguments{values.buffer().address(), 100}, 0); // nothing
        commands.finish();
    }
    CHECK(values.read() == std::vector<std::uint32_t>(100, 3));
    CHECK(commands.times().at("count_again").dispatches == 3);
}

TEST_CASE("the same dispatch gives the same bits", "[commands]") {
    const Kernel kernel = valuesKernel("mix_floats", "float sum = 0.0;\n"
                                                     "float x = float(i) * 0.001;\n"
                                                     "for (int k = 0; k < 50; ++k) { sum += sin(x + k) * exp(-x); }\n"
                                                     "args.values.at[i] = floatBitsToUint(sum);");
    const auto once = [&kernel] {
        const Array<std::uint32_t> values = zeros(50'000);
        Commands commands(Gpu::shared().context(), Gpu::shared().tables());
        commands.run(kernel, ValuesArguments{values.buffer().address(), 50'000}, 50'000);
        commands.finish();
        return values.read();
    };
    const std::vector<std::uint32_t> first = once();
    CHECK(first[1] != first[2]); // it computed something
    CHECK(once() == first);
}

TEST_CASE("times are kept by kernel name, and long work takes longer than short work", "[commands]") {
    const Kernel brief = valuesKernel("spin_briefly", kSpin);
    const Kernel lengthy = valuesKernel("spin_long", kSpin);
    constexpr std::uint32_t rounds = 2'000'000;
    const Array<std::uint32_t> one = zeros(64);
    const Array<std::uint32_t> other = zeros(64);
    const ValuesArguments oneArguments{one.buffer().address(), 64};
    const ValuesArguments otherArguments{other.buffer().address(), 64};
    Commands warmUp(Gpu::shared().context(), Gpu::shared().tables());
    warmUp.run(brief, oneArguments, 64); // drivers compile at a kernel's first dispatch
    warmUp.run(lengthy, otherArguments, 64);
    warmUp.finish();
    CHECK(warmUp.times().empty());
    one.write(std::vector<std::uint32_t>(64, 1));
    other.write(std::vector<std::uint32_t>(64, rounds));
    Commands commands(Gpu::shared().context(), Gpu::shared().tables(), true);
    const auto start = std::chrono::steady_clock::now();
    commands.run(brief, oneArguments, 64);
    commands.run(lengthy, otherArguments, 64);
    commands.clear(one.buffer());
    commands.run(brief, oneArguments, 64);
    commands.finish();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    const auto& times = commands.times();
    REQUIRE(times.size() == 3);
    CHECK(times.at("spin_briefly").dispatches == 2);
    CHECK(times.at("spin_briefly").threads == 128);
    CHECK(times.at("spin_long").dispatches == 1);
    CHECK(times.at("clear").dispatches == 1);
    const double brieflySeconds = times.at("spin_briefly").seconds;
    const double longSeconds = times.at("spin_long").seconds;
    // 2e6 rounds against at most two: a factor of a million, less the cost of a dispatch.
    CHECK(longSeconds > 5 * brieflySeconds);
    // A round waits for the one before it, two instructions of a clock or more each: at 10 GHz 2e6 take 0.4 ms.
    CHECK(longSeconds > 4e-4);
    CHECK(longSeconds + brieflySeconds + times.at("clear").seconds <= wall.count());
}

TEST_CASE("more timestamps than one query pool holds are all counted", "[commands]") {
    const Kernel kernel = valuesKernel("count_often", kCount);
    const Array<std::uint32_t> values = zeros(64);
    Commands commands(Gpu::shared().context(), Gpu::shared().tables(), true);
    for (int round = 0; round < 2; ++round) {
        for (int run = 0; run < 300; ++run) { // 600 timestamps
            commands.run(kernel, ValuesArguments{values.buffer().address(), 64}, 64);
        }
        commands.finish();
    }
    CHECK(values.read() == std::vector<std::uint32_t>(64, 600));
    CHECK(commands.times().at("count_often").dispatches == 600);
    CHECK(commands.times().at("count_often").threads == 38'400); // 600 * 64
}
