// The energy audit of a few random scenes; scripts/audit.sh does thousands.
#include "transport/audit/audit.h"

#include <catch2/catch_test_macros.hpp>

namespace hyalite::testing {

namespace {

// Scenes that fail are printed as small as they can be made.
void checkBalance(const FalseAlarms& alarms, const Draft& draft, const Renderer& renderer) {
    INFO("scene " << draft.number << ", " << renderer.name);
    const Judgement judgement = judgeBalance(draft, renderer, alarms.level());
    INFO("ratio " << judgement.ratio.mean << " +- " << judgement.ratio.standardError);
    if (judgement.exceeds) {
        FAIL_CHECK(minimised(draft, [&](const Draft& candidate) {
                       return judgeBalance(candidate, renderer, alarms.level()).exceeds;
                   }).scene(0));
    } else {
        SUCCEED();
    }
}

} // namespace

TEST_CASE("no integrator returns more than the lights send into a closed room") {
    constexpr std::uint64_t kScenes = 40;
    constexpr std::uint64_t kOnDevice = 4; // each asks for kernels of its own number of lights
    FalseAlarms alarms(kScenes * everyRenderer().size());
    for (std::uint64_t number = 0; number < kScenes; ++number) {
        const Draft draft = draftScene(number, auditOf(number));
        for (const Renderer& renderer : everyRenderer()) {
            if (renderer.backend == Backend::Reference || number < kOnDevice) {
                checkBalance(alarms, draft, renderer);
            }
        }
    }
}

TEST_CASE("an audit sees a fifth of light too much, and blames the light alone") {
    // The lights of scene 0 say that they send a fifth less than they do
    Draft draft = draftScene(0, Audit::Lit);
    for (std::vector<Part> Draft::* parts : {&Draft::objects, &Draft::lights}) {
        for (Part& part : draft.*parts) {
            part.power /= 1.25;
        }
    }
    const Renderer renderer{"", "ppm", Backend::Reference};
    FalseAlarms alarms(1);
    const auto fails = [&](const Draft& d) { return judgeBalance(d, renderer, alarms.level()).exceeds; };
    const Judgement judgement = judgeBalance(draft, renderer, alarms.level());
    INFO("ratio " << judgement.ratio.mean << " +- " << judgement.ratio.standardError);
    REQUIRE(judgement.exceeds);
    const Draft small = minimised(draft, fails);
    CHECK(small.objects.size() + small.lights.size() == 1);
    CHECK(small.power() > 0);
}

TEST_CASE("ppm and path show the same of a random scene") {
    constexpr std::uint64_t kScenes = 4;
    FalseAlarms alarms(kScenes);
    for (std::uint64_t number = 0; number < kScenes; ++number) {
        const Judgement judgement =
            judgeAgreement(draftScene(number, Audit::Compare), Backend::Reference, alarms.level());
        INFO("scene " << number << ": ratio " << judgement.ratio.mean << " +- " << judgement.ratio.standardError);
        CHECK(!judgement.exceeds);
        CHECK(judgement.ratio.standardError < 0.1);
    }
}

} // namespace hyalite::testing
