#include "parity/comparison.h"

#include "parity/hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace hyalite::parity {

namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

double scaleOf(const Field& field, const glm::dvec3& twin, double atLeast, double sceneScale) {
    double scale = std::max(largestComponent(twin), atLeast);
    if (field.scale == Scale::One) {
        scale = std::max(scale, 1.0);
    } else if (field.scale == Scale::Scene) {
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

std::string textOf(const Field& field, const Answer::Value* value) {
    if (value == nullptr) {
        return "none";
    }
    if (field.measure == Measure::Exact) {
        return std::to_string(value->exact);
    }
    return field.measure == Measure::Number ? describe(value->real.x) : describe(value->real);
}

} // namespace

const Answer::Value* Answer::find(const Field& field) const {
    const auto found = std::ranges::find(values_, &field, &Value::field);
    return found == values_.end() ? nullptr : &*found;
}

FieldError errorOf(const Field& field, const Answer::Value& device, const Answer::Value& twin, double sceneScale) {
    if (!isFinite(device.real) || !isFinite(twin.real)) {
        return device.real == twin.real ? FieldError{} : FieldError{kNoLimit, kNoLimit};
    }
    const double scale = scaleOf(field, twin.real, twin.scale, sceneScale);
    const double ulp = std::exp2(std::floor(std::log2(scale)) - 23);
    return {largestComponent(device.real - twin.real) / ulp, glm::length(device.real - twin.real) / scale};
}

void FieldResult::addError(const FieldError& error) {
    largestUlp = std::max(largestUlp, error.ulp);
    largestRelative = std::max(largestRelative, error.relative);
    ++histogram.at(binOf(error.relative));
    // Reservoir sampling: the n-th replaces an earlier one with probability kUlpsKept / n, so all are equally likely to
    // be kept
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

Comparison::Comparison(std::string stage, std::span<const Field* const> fields, double sceneScale)
    : sceneScale_(sceneScale) {
    for (const Field* field : fields) {
        result_.fields.emplace_back().field = field;
    }
    result_.name = std::move(stage);
}

void Comparison::requireFields(const Answer& answer) const {
    for (const Answer::Value& value : answer.values()) {
        if (std::ranges::find(result_.fields, value.field, &FieldResult::field) == result_.fields.end()) {
            throw std::logic_error("the check of " + result_.name + " does not list its field '" +
                                   std::string(value.field->name) + '\'');
        }
    }
}

FieldResult* Comparison::firstDifference(const Answer& device, const Answer& twin) {
    for (FieldResult& result : result_.fields) {
        const Field& field = *result.field;
        const Answer::Value* a = device.find(field);
        const Answer::Value* b = twin.find(field);
        if ((a == nullptr) != (b == nullptr)) {
            return &result;
        }
        if (a == nullptr) {
            continue;
        }
        const bool agree = field.measure == Measure::Exact
                               ? a->exact == b->exact
                               : errorOf(field, *a, *b, sceneScale_).relative <= field.tolerance->relative;
        if (!agree) {
            return &result;
        }
    }
    return nullptr;
}

bool Comparison::exactFieldsAgree(const Answer& device, const Answer& twin) const {
    return std::ranges::all_of(result_.fields, [&](const FieldResult& result) {
        const Answer::Value* a = device.find(*result.field);
        const Answer::Value* b = twin.find(*result.field);
        if (a == nullptr || b == nullptr) {
            return a == b;
        }
        return result.field->measure != Measure::Exact || a->exact == b->exact;
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
            if (const Answer::Value* value = answer.find(*result_.fields[i].field)) {
                hulls[i].add(value->real);
                scales[i] = value->scale;
            }
        }
    }
    for (std::size_t i = 0; anyAgrees && i < hulls.size(); ++i) {
        const Field& field = *result_.fields[i].field;
        const Answer::Value* value = device.find(field);
        if (value == nullptr || field.measure == Measure::Exact) {
            continue;
        }
        const double allowed = field.tolerance->relative * scaleOf(field, hulls[i].high(), scales[i], sceneScale_);
        if (!isFinite(value->real) || !hulls[i].holds(value->real, allowed)) {
            return false;
        }
    }
    return anyAgrees;
}

// Fields after an exact one that differs say nothing: the two sides took different branches.
void Comparison::count(const Answer& device, const Answer& twin, const FieldResult* different, bool explained) {
    for (FieldResult& result : result_.fields) {
        const Field& field = *result.field;
        const Answer::Value* a = device.find(field);
        const Answer::Value* b = twin.find(field);
        if (a == nullptr && b == nullptr) {
            continue;
        }
        ++result.compared;
        const bool oneSided = a == nullptr || b == nullptr;
        if (&result == different && (explained || oneSided || field.measure == Measure::Exact)) {
            ++(explained ? result.apart : result.failed);
            return;
        }
        if (oneSided) { // such as a distance that only one side's light has, after directions that differ
            ++result.failed;
            continue;
        }
        if (field.measure == Measure::Exact) {
            ++(a->exact == b->exact ? result.matched : result.failed);
            continue;
        }
        const FieldError error = errorOf(field, *a, *b, sceneScale_);
        const bool within = error.relative <= field.tolerance->relative;
        if (!within && explained) {
            ++result.apart;
            continue;
        }
        ++(within ? result.matched : result.failed);
        result.addError(error);
    }
}

// `tell` fills in the remaining members of the offender.
void Comparison::keep(FieldResult& field, Offender offender, const std::function<void(Offender&)>& tell) {
    // Unexplained offenders come before explained ones
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
    requireFields(device);
    requireFields(exact);
    FieldResult* different = firstDifference(device, exact);
    if (different == nullptr) {
        count(device, exact, nullptr, false);
        return Outcome::Matched;
    }
    // A stage that has already failed stays failed: no need for an extensive search
    const bool isLost = result_.failed >= kFailuresExplained;
    const bool explained = isExplained(device, twin, kNudges) || (!isLost && isExplained(device, twin, kMoreNudges));
    return conclude(dispatch, i, device, exact, *different, explained, inputs);
}

Outcome Comparison::compareExact(const std::string& dispatch, std::size_t i, const Answer& device,
                                 const Answer& expected) {
    ++result_.elements;
    requireFields(device);
    requireFields(expected);
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
    const Field& field = *different.field;
    const Answer::Value* a = device.find(field);
    const Answer::Value* b = expected.find(field);
    double error = kNoLimit;
    if (a != nullptr && b != nullptr && field.measure != Measure::Exact && field.tolerance->relative > 0) {
        error = errorOf(field, *a, *b, sceneScale_).relative / field.tolerance->relative;
    }
    Offender offender;
    offender.where = dispatch + ", thread " + std::to_string(i);
    offender.field = field.name;
    offender.error = error;
    offender.cause = explained ? (field.nearby.empty() ? "rounding" : field.nearby) : "";
    keep(different, std::move(offender), [&](Offender& kept) {
        kept.inputs = inputs();
        for (const FieldResult& result : result_.fields) {
            const Answer::Value* onDevice = device.find(*result.field);
            const Answer::Value* onTwin = expected.find(*result.field);
            if (onDevice != nullptr || onTwin != nullptr) {
                kept.answers.push_back(
                    {result.field->name, textOf(*result.field, onDevice), textOf(*result.field, onTwin)});
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
