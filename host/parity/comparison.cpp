#include "parity/comparison.h"

#include "parity/hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace hyalite::parity {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

double scaleOf(const Tolerance& tolerance, const glm::dvec3& twin, double atLeast, double sceneScale) {
    double scale = std::max(largestComponent(twin), atLeast);
    if (tolerance.scale == Scale::One) {
        scale = std::max(scale, 1.0);
    } else if (tolerance.scale == Scale::Scene) {
        scale = std::max(scale, sceneScale);
    }
    return std::max(scale, double{std::numeric_limits<float>::min()});
}

bool isFinite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

std::size_t binOf(double relative) {
    if (relative <= 0) {
        return 0;
    }
    const int exponent = static_cast<int>(std::floor(std::log2(std::min(relative, 1e9))));
    return static_cast<std::size_t>(std::clamp(exponent - kLeastExponent + 1, 0, static_cast<int>(kBins) - 1));
}

std::string textOf(const Tolerance& tolerance, const Answer::Value* value) {
    if (value == nullptr) {
        return "none";
    }
    if (tolerance.measure == Measure::Exact) {
        return std::to_string(value->exact);
    }
    return tolerance.measure == Measure::Number ? describe(value->real.x) : describe(value->real);
}

} // namespace

const Answer::Value* Answer::find(std::string_view field) const {
    const auto found = std::ranges::find(values_, field, &Value::field);
    return found == values_.end() ? nullptr : &*found;
}

FieldError errorOf(const Tolerance& tolerance, const Answer::Value& device, const Answer::Value& twin,
                   double sceneScale) {
    if (!isFinite(device.real) || !isFinite(twin.real)) {
        return device.real == twin.real ? FieldError{} : FieldError{kNoLimit, kNoLimit};
    }
    const double scale = scaleOf(tolerance, twin.real, twin.scale, sceneScale);
    const double ulp = std::exp2(std::floor(std::log2(scale)) - 23);
    return {largestComponent(device.real - twin.real) / ulp, glm::length(device.real - twin.real) / scale};
}

void FieldResult::addError(const FieldError& error) {
    largestUlp = std::max(largestUlp, error.ulp);
    largestRelative = std::max(largestRelative, error.relative);
    ++histogram.at(binOf(error.relative));
    // The n-th takes the place of an earlier one with probability kUlpsKept / n: each is kept as likely as any other
    const std::uint64_t n = matched + failed;
    const std::uint64_t place = shared::hash(static_cast<std::uint32_t>(n)) % std::max<std::uint64_t>(n, 1);
    if (ulps.size() < kUlpsKept) {
        ulps.push_back(static_cast<float>(error.ulp));
    } else if (place < kUlpsKept) {
        ulps[place] = static_cast<float>(error.ulp);
    }
}

double FieldResult::ulpPercentile(double share) const {
    if (ulps.empty()) {
        return 0;
    }
    const auto index = static_cast<std::size_t>(std::llround(share * static_cast<double>(ulps.size() - 1)));
    return double{ulps[index]};
}

Comparison::Comparison(std::string stage, double sceneScale) : sceneScale_(sceneScale) {
    for (const Tolerance& tolerance : tolerancesOf(stage)) {
        result_.fields.emplace_back().tolerance = &tolerance;
    }
    result_.name = std::move(stage);
}

FieldResult* Comparison::firstDifference(const Answer& device, const Answer& twin) {
    for (FieldResult& field : result_.fields) {
        const Tolerance& tolerance = *field.tolerance;
        const Answer::Value* a = device.find(tolerance.field);
        const Answer::Value* b = twin.find(tolerance.field);
        if ((a == nullptr) != (b == nullptr)) {
            return &field;
        }
        if (a == nullptr) {
            continue;
        }
        const bool agree = tolerance.measure == Measure::Exact
                               ? a->exact == b->exact
                               : errorOf(tolerance, *a, *b, sceneScale_).relative <= tolerance.relative;
        if (!agree) {
            return &field;
        }
    }
    return nullptr;
}

bool Comparison::exactFieldsAgree(const Answer& device, const Answer& twin) const {
    return std::ranges::all_of(result_.fields, [&](const FieldResult& field) {
        const Answer::Value* a = device.find(field.tolerance->field);
        const Answer::Value* b = twin.find(field.tolerance->field);
        if (a == nullptr || b == nullptr) {
            return a == b;
        }
        return field.tolerance->measure != Measure::Exact || a->exact == b->exact;
    });
}

bool Comparison::isExplained(const Answer& device, const Twin& twin, std::uint32_t nudges) const {
    std::vector<Hull> hulls(result_.fields.size());
    std::vector<double> scales(result_.fields.size(), 0); // see Answer::Value
    bool anyAgrees = false;
    for (std::uint32_t n = 0; n <= nudges; ++n) {
        const Answer answer = twin(Nudge(n));
        if (!exactFieldsAgree(device, answer)) {
            continue;
        }
        anyAgrees = true;
        for (std::size_t i = 0; i < hulls.size(); ++i) {
            if (const Answer::Value* value = answer.find(result_.fields[i].tolerance->field)) {
                hulls[i].add(value->real);
                scales[i] = value->scale;
            }
        }
    }
    for (std::size_t i = 0; anyAgrees && i < hulls.size(); ++i) {
        const Tolerance& tolerance = *result_.fields[i].tolerance;
        const Answer::Value* value = device.find(tolerance.field);
        if (value == nullptr || tolerance.measure == Measure::Exact) {
            continue;
        }
        const double allowed = tolerance.relative * scaleOf(tolerance, hulls[i].high(), scales[i], sceneScale_);
        if (!isFinite(value->real) || !hulls[i].holds(value->real, allowed)) {
            return false;
        }
    }
    return anyAgrees;
}

// Fields behind an exact one that differs say nothing: the two sides went different ways.
void Comparison::count(const Answer& device, const Answer& twin, const FieldResult* different, bool explained) {
    for (FieldResult& field : result_.fields) {
        const Tolerance& tolerance = *field.tolerance;
        const Answer::Value* a = device.find(tolerance.field);
        const Answer::Value* b = twin.find(tolerance.field);
        if (a == nullptr && b == nullptr) {
            continue;
        }
        ++field.compared;
        if (&field == different && (explained || a == nullptr || b == nullptr || tolerance.measure == Measure::Exact)) {
            ++(explained ? field.apart : field.failed);
            return;
        }
        if (tolerance.measure == Measure::Exact) {
            ++field.matched;
            continue;
        }
        const FieldError error = errorOf(tolerance, *a, *b, sceneScale_);
        const bool within = error.relative <= tolerance.relative;
        if (!within && explained) {
            ++field.apart;
            continue;
        }
        ++(within ? field.matched : field.failed);
        field.addError(error);
    }
}

// `tell` fills in the rest of what is kept.
void Comparison::keep(FieldResult& field, Offender offender, const std::function<void(Offender&)>& tell) {
    // What nothing explains comes before what something does
    const auto isWorse = [](const Offender& a, const Offender& b) {
        return std::pair(a.cause.empty(), a.error) > std::pair(b.cause.empty(), b.error);
    };
    const auto place = std::ranges::upper_bound(field.offenders, offender, isWorse);
    if (place == field.offenders.end() && field.offenders.size() == kOffendersKept) {
        return;
    }
    tell(*field.offenders.insert(place, std::move(offender)));
    if (field.offenders.size() > kOffendersKept) {
        field.offenders.pop_back();
    }
}

Outcome Comparison::compare(const std::string& dispatch, std::size_t i, const Answer& device, const Twin& twin,
                            const Inputs& inputs) {
    ++result_.elements;
    const Answer exact = twin(Nudge(0));
    FieldResult* different = firstDifference(device, exact);
    if (different == nullptr) {
        count(device, exact, nullptr, false);
        return Outcome::Matched;
    }
    // Where a stage has failed already, the verdict stands: there is no need to look far
    const bool isLost = result_.failed >= kFailuresExplained;
    const bool explained = isExplained(device, twin, kNudges) || (!isLost && isExplained(device, twin, kMoreNudges));
    return conclude(dispatch, i, device, exact, *different, explained, inputs);
}

Outcome Comparison::compareExact(const std::string& dispatch, std::size_t i, const Answer& device,
                                 const Answer& expected) {
    ++result_.elements;
    FieldResult* different = firstDifference(device, expected);
    if (different == nullptr) {
        count(device, expected, nullptr, false);
        return Outcome::Matched;
    }
    return conclude(dispatch, i, device, expected, *different, false, [] { return OffenderInputs(); });
}

Outcome Comparison::conclude(const std::string& dispatch, std::size_t i, const Answer& device, const Answer& expected,
                             FieldResult& different, bool explained, const Inputs& inputs) {
    count(device, expected, &different, explained);
    ++(explained ? result_.apart : result_.failed);
    const Tolerance& tolerance = *different.tolerance;
    const Answer::Value* a = device.find(tolerance.field);
    const Answer::Value* b = expected.find(tolerance.field);
    double error = kNoLimit;
    if (a != nullptr && b != nullptr && tolerance.measure != Measure::Exact && tolerance.relative > 0) {
        error = errorOf(tolerance, *a, *b, sceneScale_).relative / tolerance.relative;
    }
    Offender offender;
    offender.where = dispatch + ", thread " + std::to_string(i);
    offender.field = tolerance.field;
    offender.error = error;
    offender.cause = explained ? (tolerance.nearby.empty() ? "rounding" : tolerance.nearby) : "";
    keep(different, std::move(offender), [&](Offender& kept) {
        kept.inputs = inputs();
        for (const FieldResult& field : result_.fields) {
            const Answer::Value* onDevice = device.find(field.tolerance->field);
            const Answer::Value* onTwin = expected.find(field.tolerance->field);
            if (onDevice != nullptr || onTwin != nullptr) {
                kept.answers.push_back(
                    {field.tolerance->field, textOf(*field.tolerance, onDevice), textOf(*field.tolerance, onTwin)});
            }
        }
    });
    return explained ? Outcome::Apart : Outcome::Failed;
}

std::string describe(double x) {
    std::ostringstream text;
    text.precision(9);
    text << x;
    return text.str();
}

std::string describe(const glm::dvec3& v) {
    return describe(v.x) + ' ' + describe(v.y) + ' ' + describe(v.z);
}

} // namespace hyalite::parity
