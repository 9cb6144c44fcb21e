// The comparison itself: which results it counts as equal, apart and failed.
#include "parity/checks/checks.h"
#include "parity/comparison.h"

#include <catch2/catch_test_macros.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

namespace hyalite::parity {

namespace {

OffenderInputs noInputs() {
    return {};
}

struct HitFields : FieldSet<2> {
    const Field& object = exact("object", kEdge);
    const Field& t = number("t", kPosition, Scale::Scene);
};
constexpr HitFields kHit;

struct ColorFields : FieldSet<1> {
    const Field& color = vector("color", kRounding);
};
constexpr ColorFields kColors;

Answer hitOf(std::uint64_t object, double t) {
    Answer answer;
    answer.exact(kHit.object, object);
    answer.number(kHit.t, t);
    return answer;
}

// Of hits in a scene whose largest coordinate is 1.
Comparison hitComparison() {
    const std::array<const Field*, 2> fields{&kHit.object, &kHit.t};
    return {"hits", fields, 1};
}

// As the documentation writes it, e.g. 2<sup>-18</sup> or 1.07 · 2<sup>-9</sup>.
std::string powerOfTwo(double x) {
    if (x == 0) {
        return "0";
    }
    int exponent = 0;
    const double mantissa = 2 * std::frexp(x, &exponent);
    std::ostringstream text;
    text << std::setprecision(4);
    if (mantissa != 1) {
        text << mantissa << " · ";
    }
    text << "2<sup>" << exponent - 1 << "</sup>";
    return text.str();
}

} // namespace

TEST_CASE("errors are measured in units in the last place of a float, and relative to their scale") {
    const auto value = [](const glm::dvec3& v, double scale = 0) {
        return Answer::Value{.field = nullptr, .exact = 0, .real = v, .scale = scale};
    };
    // A float in [4, 8) ends in 2^-21; the error of 3 of them is 3 * 2^-21 / 4 of the value
    const Field& color = kColors.color;
    const FieldError error = errorOf(color, value({4 + 3 * 0x1p-21, 1, 1}), value({4, 1, 1}), 100);
    CHECK(error.ulp == 3);
    CHECK(error.relative == 3 * 0x1p-23);
    // Positions are relative to the scene: 2^-14 of 64, where floats end in 2^-17
    const Field& t = kHit.t;
    const FieldError small = errorOf(t, value({1 + 0x1p-14, 0, 0}), value({1, 0, 0}), 64);
    CHECK(small.relative == 0x1p-20);
    CHECK(small.ulp == 8);
    // A value may bring a scale of its own: 2^-22 of 1, not of 2^-10
    CHECK(
        errorOf(color, value(glm::dvec3(0x1p-10 + 0x1p-22, 0, 0)), value(glm::dvec3(0x1p-10, 0, 0), 1), 100).relative ==
        0x1p-22);
    // NaN matches nothing else
    CHECK(std::isinf(errorOf(color, value(glm::dvec3(NAN)), value(glm::dvec3(1)), 1).relative));
    CHECK(std::isinf(errorOf(color, value(glm::dvec3(INFINITY)), value(glm::dvec3(1)), 1).relative));
    CHECK(errorOf(color, value(glm::dvec3(INFINITY)), value(glm::dvec3(INFINITY)), 1).relative == 0);
}

TEST_CASE(
    "a difference is apart where a move of the input by roundings brings the twin to it, and has failed elsewhere") {
    // An edge at x = 1: object 1 before it, object 2 behind
    const auto edge = [](double x) {
        return [x](Nudge nudge) {
            const double moved = nudge.point(glm::dvec3(x, 0, 0), 1).x;
            return hitOf(moved < 1 ? 1 : 2, 5);
        };
    };
    Comparison comparison = hitComparison();
    CHECK(comparison.compare("", 0, hitOf(1, 5), edge(0.9), noInputs) == Outcome::Matched);
    CHECK(comparison.compare("", 1, hitOf(2, 5), edge(1 - 0x1p-24), noInputs) == Outcome::Apart);
    // 2^-16 away, sixteen times as far as any move
    CHECK(comparison.compare("", 2, hitOf(2, 5), edge(1 - 0x1p-16), noInputs) == Outcome::Failed);
    const StageResult& result = comparison.result();
    CHECK(result.elements == 3);
    CHECK(result.apart == 1);
    CHECK(result.failed == 1);
    CHECK_FALSE(result.passed());
    const FieldResult& object = result.fields.front();
    REQUIRE(object.offenders.size() == 2);
    CHECK(object.offenders[0].cause.empty()); // unexplained offenders come first
    CHECK(object.offenders[1].cause == "edge, silhouette, or surfaces in one place");
}

TEST_CASE("a number is apart within the effect of input roundings, and has failed beyond it") {
    // t = 1000 x: moves of x by up to kNudge 2^-24 move t by 1000 times that
    const Comparison::Twin steep = [](Nudge nudge) {
        return hitOf(1, 1000 * nudge.point(glm::dvec3(1e-3, 0, 0), 1).x);
    };
    const double reach = 1000 * kNudge * 0x1p-24;
    REQUIRE(reach > kHit.t.tolerance->relative);
    Comparison comparison = hitComparison();
    CHECK(comparison.compare("", 0, hitOf(1, 1 + 0x1p-20), steep, noInputs) == Outcome::Matched);
    CHECK(comparison.compare("", 1, hitOf(1, 1 + reach / 2), steep, noInputs) == Outcome::Apart);
    // The range found is at most two reaches wide, and is widened by as much on either side: 3 reaches, and 4 beyond it
    CHECK(comparison.compare("", 2, hitOf(1, 1 + 4 * reach), steep, noInputs) == Outcome::Failed);
}

TEST_CASE("a number that one side alone has, after another that differs, has failed") {
    const std::array<const Field*, 2> fields{&kColors.color, &kHit.t};
    Comparison comparison("lights", fields, 1);
    Answer device;
    device.vector(kColors.color, glm::dvec3(1));
    device.number(kHit.t, 5);
    Answer twin;
    twin.vector(kColors.color, glm::dvec3(2));
    CHECK(comparison.compareExact("", 0, device, twin) == Outcome::Failed);
    CHECK(comparison.compareExact("", 1, twin, device) == Outcome::Failed);
    CHECK(comparison.result().fields[1].compared == 2);
    CHECK(comparison.result().fields[1].failed == 2);
}

TEST_CASE("a stage with too many differences due to rounding fails") {
    const Comparison::Twin undecided = [](Nudge nudge) { return hitOf(nudge.movesNothing() ? 1 : 2, 5); };
    const Comparison::Twin sure = [](Nudge) { return hitOf(1, 5); };
    Comparison comparison = hitComparison();
    for (std::size_t i = 0; i < 100; ++i) { // one in fifty is allowed: two of a hundred, not three
        const bool isApart = i < 2;
        static_cast<void>(comparison.compare("", i, hitOf(isApart ? 2 : 1, 5), isApart ? undecided : sure, noInputs));
    }
    CHECK(comparison.result().passed());
    static_cast<void>(comparison.compare("", 100, hitOf(2, 5), undecided, noInputs));
    CHECK(comparison.result().apart == 3);
    CHECK_FALSE(comparison.result().passed());
}

TEST_CASE("the table of docs/parity.md matches the tolerances") {
    std::ifstream file(HYALITE_SOURCE_DIR "/docs/parity.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::string table = "| what | relative | to | why |\n|---|---|---|---|\n";
    for (const Tolerance* tolerance : kTolerances) {
        table += "| " + std::string(tolerance->of) + " | " + powerOfTwo(tolerance->relative) + " | " +
                 std::string(tolerance->scale) + " | " +
                 std::regex_replace(std::string(tolerance->reason), std::regex("2\\^(-?[0-9]+)"), "2<sup>$1</sup>") +
                 " |\n";
    }
    INFO("expected:\n" << table);
    CHECK(text.find("\n" + table + "\n") != std::string::npos); // an empty line ends it
}

TEST_CASE("an answer with a field that its check does not list is a programming error") {
    Comparison comparison = hitComparison();
    Answer answer = hitOf(1, 5);
    answer.vector(kColors.color, glm::dvec3(1));
    CHECK_THROWS_AS(comparison.compareExact("", 0, answer, answer), std::logic_error);
}

TEST_CASE("every kernel has a check, and every check has a twin and fields with reasons") {
    std::set<std::string> kernels;
    for (const auto& file : std::filesystem::directory_iterator(HYALITE_SOURCE_DIR "/shaders/kernels")) {
        if (file.path().extension() == ".comp") {
            kernels.insert(file.path().stem().string());
        }
    }
    REQUIRE(kernels.erase("self_test") == 1);       // its answers are known
    REQUIRE(kernels.erase("nearest_photons") == 1); // used only by tests
    std::set<std::string> checked;
    for (const Check* check : allChecks()) {
        INFO(check->kernel);
        CHECK(checked.emplace(check->kernel).second); // once
        CHECK(checkOf(check->kernel) == check);
        CHECK(check->compare != nullptr);
        std::set<std::string_view> names;
        check->forEachField([&](const Field& field) {
            INFO(field.name);
            CHECK(names.insert(field.name).second);
            CHECK(std::ranges::find(kTolerances, field.tolerance) != kTolerances.end());
        });
        CHECK_FALSE(names.empty());
    }
    CHECK(checked == kernels);
    for (const Tolerance* tolerance : kTolerances) {
        INFO(tolerance->of);
        CHECK_FALSE(tolerance->reason.empty());
    }
}

} // namespace hyalite::parity
