// Asks the device what the host can work out itself; all values are exact floats, none a zero with a sign or a NaN.
#include "gpu/self_test.h"

#include "base/error.h"
#include "gpu/commands.h"
#include "gpu/driver_hint.h"
#include "shaders/shared/self_test.h"

namespace hyalite::gpu {
namespace {

using shared::SelfTestAnswer;
using shared::SelfTestRecord;

// Values without meaning, each a different exact float, so that no member can stand in for another.
float exact(std::uint32_t i, std::uint32_t member) {
    return float(i * 16 + member);
}

SelfTestRecord recordOf(std::uint32_t i) {
    return {
        .first = i, .second = {exact(i, 1), exact(i, 2), exact(i, 3)}, .third = {~i, i << 16U}, .fourth = exact(i, 4)};
}

shared::vec4 texelOf(std::uint32_t i) {
    return {exact(i, 5), exact(i, 6), exact(i, 7), exact(i, 8)};
}

std::uint32_t roundsOf(std::uint32_t i) {
    std::uint32_t x = i;
    for (std::uint32_t round = 0; round < shared::kSelfTestRounds; ++round) {
        x = shared::selfTestRound(x);
    }
    return x;
}

bool same(const SelfTestRecord& a, const SelfTestRecord& b) {
    return a.first == b.first && a.second == b.second && a.third == b.third && a.fourth == b.fourth;
}

void check(bool right, const DeviceInfo& device, const std::string& what) {
    if (!right) {
        throw Error(ExitCode::Device, device.name + " (" + device.driver + ") computes wrong results: " + what,
                    kInstallDriverHint);
    }
}

} // namespace

void selfTest(const Context& context, const KernelCompiler& compiler) {
    constexpr std::uint32_t count = shared::kSelfTestCount;
    const Array<SelfTestRecord> records(context, count, "self-test records", Memory::Host);
    const Array<shared::vec4> texels(context, count, "self-test texels", Memory::Host);
    const Array<SelfTestAnswer> answers(context, count, "self-test answers", Memory::Host);
    for (std::uint32_t i = 0; i < count; ++i) {
        records.host()[i] = recordOf(i);
        texels.host()[i] = texelOf(i);
    }
    TexelTables tables(context, 1);
    tables.set(0, texels.buffer(), TexelFormat::Float4);
    const Kernel kernel(context, tables, compiler, "self_test");
    Commands commands(context, tables);
    commands.clear(answers.buffer());
    commands.run(kernel,
                 shared::SelfTestArguments{
                     .records = records, .answers = answers, .rounds = shared::kSelfTestRounds, .count = count},
                 count);
    commands.finish();
    for (std::uint32_t i = 0; i < count; ++i) {
        const SelfTestAnswer& answer = answers.host()[i];
        check(answer.rounds == roundsOf(i), context.info(), "a loop of more than 65 535 rounds ends early");
        check(answer.texel == texelOf(i), context.info(), "a texel fetch gives a wrong value");
        check(same(answer.record, recordOf(i)), context.info(), "a struct in scalar layout is read wrongly");
    }
}

} // namespace hyalite::gpu
