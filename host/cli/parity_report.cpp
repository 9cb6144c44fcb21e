#include "cli/parity_report.h"

#include <algorithm>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

namespace hyalite::cli {

namespace {

using Json = nlohmann::ordered_json;
using parity::FieldResult;
using parity::Measure;
using parity::Offender;
using parity::StageResult;

std::string count(std::uint64_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

std::string shortNumber(double x) {
    std::ostringstream text;
    text << std::setprecision(2) << x;
    return text.str();
}

std::string verdictOf(const StageResult& stage) {
    if (!stage.hasTwin()) {
        return "no twin";
    }
    if (stage.failed > 0) {
        return "FAILED";
    }
    return stage.passed() ? "passed" : "too many apart";
}

// The field whose errors are largest, measured by what is allowed; nullptr where all are exact.
const FieldResult* worstField(const StageResult& stage) {
    const FieldResult* worst = nullptr;
    double largest = 0;
    for (const FieldResult& field : stage.fields) {
        if (field.ulps.empty()) {
            continue;
        }
        const double share = field.largestRelative / std::max(field.tolerance->relative, 1e-30);
        if (worst == nullptr || share > largest) {
            worst = &field;
            largest = share;
        }
    }
    return worst;
}

void addOffenders(std::ostream& text, const StageResult& stage) {
    for (const FieldResult& field : stage.fields) {
        for (std::size_t i = 0; i < std::min<std::size_t>(2, field.offenders.size()); ++i) {
            const Offender& offender = field.offenders[i];
            if (!offender.cause.empty()) {
                continue;
            }
            text << "  " << stage.name << ", " << offender.field << ", " << offender.where << ": device "
                 << offender.device << ", twin " << offender.twin << '\n';
            for (const auto& [name, value] : offender.inputs) {
                text << "      " << name << ": " << value << '\n';
            }
        }
    }
}

Json jsonOf(const Offender& offender) {
    Json object{{"where", offender.where}, {"field", offender.field}, {"device", offender.device},
                {"twin", offender.twin},   {"cause", offender.cause}, {"inputs", Json::object()}};
    for (const auto& [name, value] : offender.inputs) {
        object["inputs"][name] = value;
    }
    return object;
}

Json jsonOf(const FieldResult& field) {
    Json object{{"name", field.tolerance->field},
                {"compared", field.compared},
                {"matched", field.matched},
                {"apart", field.apart},
                {"failed", field.failed}};
    if (field.tolerance->measure != Measure::Exact) {
        object["tolerance"] = field.tolerance->relative;
        object["largest_relative"] = field.largestRelative;
        object["largest_ulp"] = field.largestUlp;
        object["ulp_99_9"] = field.ulpPercentile(0.999);
        object["histogram"] = {{"least_exponent", parity::kLeastExponent}, {"counts", field.histogram}};
    }
    for (const Offender& offender : field.offenders) {
        object["offenders"].push_back(jsonOf(offender));
    }
    return object;
}

} // namespace

std::string parityTable(const parity::Result& result) {
    std::ostringstream text;
    text << std::left << std::setw(24) << "stage" << std::right << std::setw(10) << "dispatches" << std::setw(11)
         << "elements" << std::setw(9) << "apart" << std::setw(9) << "failed" << std::setw(10) << "99.9 %"
         << std::setw(10) << "largest" << "  worst field\n"
         << std::string(54, ' ') << std::setw(29) << "[ulp]" << '\n';
    for (const StageResult& stage : result.stages) {
        text << std::left << std::setw(24) << stage.name << std::right << std::setw(10) << stage.dispatches
             << std::setw(11) << stage.elements << std::setw(9) << stage.apart << std::setw(9) << stage.failed;
        if (const FieldResult* worst = worstField(stage)) {
            text << std::setw(10) << shortNumber(worst->ulpPercentile(0.999)) << std::setw(10)
                 << shortNumber(worst->largestUlp) << "  " << std::left << std::setw(20) << worst->tolerance->field;
        } else {
            text << std::setw(10) << "exact" << std::setw(10) << "" << std::setw(22) << "";
        }
        text << ' ' << verdictOf(stage) << '\n';
    }
    for (const StageResult& stage : result.stages) {
        addOffenders(text, stage);
    }
    if (result.picture) {
        const parity::PictureResult& picture = *result.picture;
        text << "picture: RMSE " << shortNumber(picture.rmse) << ", relMSE " << shortNumber(picture.relMse) << ", FLIP "
             << shortNumber(picture.flip) << ", " << std::setprecision(4) << 100 * picture.shareWithin
             << " % of the pixels within " << 100 * parity::kPictureTolerance << " %\n";
    }
    return text.str();
}

std::string parityVerdict(const parity::Result& result) {
    if (const StageResult* first = result.firstFailure()) {
        if (!first->hasTwin()) {
            return "parity FAILED: " + first->name + " has no twin to compare with";
        }
        if (first->failed == 0) {
            return "parity FAILED: " + first->name + ": rounding decides too often, in " +
                   std::to_string(first->apart) + " of " + std::to_string(first->elements);
        }
        return "parity FAILED: the sides part first in " + first->name + " (dispatch " +
               std::to_string(first->firstFailure) + "): " + std::to_string(first->failed) + " of " +
               std::to_string(first->elements) + " differ";
    }
    if (!result.passed()) {
        return "parity FAILED: all stages agree, but the pictures do not";
    }
    std::uint64_t elements = 0;
    std::uint64_t apart = 0;
    for (const StageResult& stage : result.stages) {
        elements += stage.elements;
        apart += stage.apart;
    }
    return "parity passed: " + count(result.stages.size(), "stage", "stages") + ", " +
           count(elements, "element", "elements") + ", of which " + std::to_string(apart) +
           " differ by what a few roundings of the input explain";
}

std::string parityJson(const parity::Result& result, const std::string& scene, const std::string& device) {
    Json object{{"scene", scene},
                {"device", device},
                {"passed", result.passed()},
                {"verdict", parityVerdict(result)},
                {"first_failure", nullptr},
                {"stages", Json::array()}};
    if (const StageResult* first = result.firstFailure()) {
        object["first_failure"] = first->name;
    }
    for (const StageResult& stage : result.stages) {
        Json fields = Json::array();
        for (const FieldResult& field : stage.fields) {
            fields.push_back(jsonOf(field));
        }
        object["stages"].push_back({{"name", stage.name},
                                    {"passed", stage.passed()},
                                    {"has_twin", stage.hasTwin()},
                                    {"dispatches", stage.dispatches},
                                    {"elements", stage.elements},
                                    {"apart", stage.apart},
                                    {"failed", stage.failed},
                                    {"fields", std::move(fields)}});
    }
    if (result.picture) {
        const parity::PictureResult& picture = *result.picture;
        object["picture"] = {{"rmse", picture.rmse},
                             {"relmse", picture.relMse},
                             {"flip", picture.flip},
                             {"within", {{"tolerance", parity::kPictureTolerance}, {"share", picture.shareWithin}}},
                             {"passed", picture.passed()}};
    }
    return object.dump(2);
}

} // namespace hyalite::cli
