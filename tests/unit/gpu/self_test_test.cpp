// The known-answer dispatch passes on this driver, and rejects a driver that computes something else.
#include "base/error.h"
#include "gpu/self_test.h"
#include "support/gpu_fixture.h"
#include "unit/gpu/temporary_shaders.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace hyalite;
using Catch::Matchers::ContainsSubstring;
using testing::Gpu;

namespace {

const std::string kKernel = "kernels/self_test.comp";

// The self-test's message if its kernel has `wrong` in place of `right`, as a faulty driver would run it.
std::string verdictWith(const std::string& right, const std::string& wrong) {
    const testing::TemporaryShaders folder;
    folder.replace(kKernel, right, wrong);
    try {
        gpu::selfTest(Gpu::shared().context(), gpu::ShaderCompiler(folder.shaders()));
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::Device);
        CHECK_THAT(error.hint(), ContainsSubstring("Mesa 25") && ContainsSubstring("scripts/install-deps.sh"));
        return error.what();
    }
    return "passed";
}

} // namespace

TEST_CASE("the driver passes the self-test", "[self-test]") {
    CHECK_NOTHROW(gpu::selfTest(Gpu::shared().context(), Gpu::shared().compiler()));
}

TEST_CASE("a driver that cuts loops at 65 535 rounds is refused", "[self-test]") {
    CHECK_THAT(verdictWith("round < args.rounds", "round < min(args.rounds, 65535u)"),
               ContainsSubstring("loop") && ContainsSubstring("wrong results"));
}

TEST_CASE("a driver that fetches the wrong texel is refused", "[self-test]") {
    CHECK_THAT(verdictWith("texelFetch(texels, int(i))", "texelFetch(texels, int(i) ^ 1)"),
               ContainsSubstring("texel fetch"));
}

TEST_CASE("a driver that reads structs by other offsets is refused", "[self-test]") {
    CHECK_THAT(verdictWith("args.records.at[i];", "args.records.at[i ^ 1u];"), ContainsSubstring("scalar layout"));
}
