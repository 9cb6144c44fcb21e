#include "parity/report.h"

#include <nlohmann/json.hpp>

namespace hyalite::parity {

namespace {

using Json = nlohmann::ordered_json;

std::string count(std::uint64_t n, const std::string& one, const std::string& many) {
    return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

Json jsonOf(const Offender& offender) {
    Json object{{"where", offender.where},  {"field", offender.field},  {"cause", offender.cause},
                {"inputs", Json::object()}, {"device", Json::object()}, {"twin", Json::object()}};
    for (const auto& [name, value] : offender.inputs) {
        object["inputs"][name] = value;
    }
    for (const Offender::Value& value : offender.answers) {
        object["device"][std::string(value.field)] = value.device;
        object["twin"][std::string(value.field)] = value.twin;
    }
    return object;
}

Json jsonOf(const FieldResult& field) {
    Json object{{"name", field.field->name},
                {"compared", field.compared},
                {"matched", field.matched},
                {"apart", field.apart},
                {"failed", field.failed}};
    if (field.field->measure != Measure::Exact) {
        object["tolerance"] = field.field->tolerance->relative;
        object["largest_relative"] = field.largestRelative;
        object["largest_ulp"] = field.largestUlp;
        object["ulp_99_9"] = field.ulpPercentile(0.999);
        object["histogram"] = {{"least_exponent", kLeastExponent}, {"counts", field.histogram}};
    }
    for (const Offender& offender : field.offenders) {
        object["offenders"].push_back(jsonOf(offender));
    }
    return object;
}

Json jsonOf(const PhotonSum& photons) {
    return {{"count", photons.count}, {"flux", {photons.flux.x, photons.flux.y, photons.flux.z}}};
}

Json jsonOf(const PathResult& paths) {
    Json object{{"compared", paths.compared},
                {"vertices", paths.vertices},
                {"agree", paths.agree},
                {"photons_stored", {{"device", jsonOf(paths.storedOnDevice)}, {"twin", jsonOf(paths.storedByTwin)}}},
                {"share", paths.share()},
                {"agree_stepwise", paths.agreeStepwise()},
                {"share_stepwise", paths.shareStepwise()},
                {"tolerance", kPathTolerance},
                {"unexplained", paths.unexplained()},
                {"causes", Json::object()}};
    for (const auto& [cause, number] : paths.causes) {
        object["causes"][cause.empty() ? "unexplained" : cause] = number;
    }
    return object;
}

} // namespace

std::string verdict(const Result& result) {
    if (const StageResult* first = result.firstFailure()) {
        if (!first->hasTwin()) {
            return "parity FAILED: " + first->name + " has no twin to compare with" +
                   (first->withoutTwin.empty() ? "" : ": it runs the scene's own " + first->withoutTwin);
        }
        if (first->failed == 0) {
            return "parity FAILED: " + first->name +
                   ": too many differences due to rounding: " + std::to_string(first->apart) + " of " +
                   std::to_string(first->elements);
        }
        return "parity FAILED: the sides first differ in " + first->name + " (dispatch " +
               std::to_string(first->firstFailure) + "): " + std::to_string(first->failed) + " of " +
               std::to_string(first->elements) + " differ";
    }
    if (result.paths && (!result.paths->camera.passed() || !result.paths->photons.passed())) {
        const std::uint64_t unexplained = result.paths->camera.unexplained() + result.paths->photons.unexplained();
        return "parity FAILED: all stages agree, but " +
               (unexplained > 0 ? count(unexplained, "path differs", "paths differ") + " for an unknown reason"
                                : "too many paths differ in a single step by rounding");
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

std::string toJson(const Result& result, const Circumstances& circumstances) {
    Json object{{"scene", circumstances.scene}, {"command", circumstances.command},  {"machine", Json::object()},
                {"passed", result.passed()},    {"verdict", verdict(result)},        {"first_failure", nullptr},
                {"stages", Json::array()},      {"warnings", circumstances.warnings}};
    for (const auto& [name, value] : circumstances.machine) {
        object["machine"][name] = value;
    }
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
    if (result.paths) {
        object["paths"] = {{"camera", jsonOf(result.paths->camera)}, {"photons", jsonOf(result.paths->photons)}};
    }
    if (result.picture) {
        const PictureResult& picture = *result.picture;
        object["picture"] = {{"rmse", picture.rmse},
                             {"relmse", picture.relMse},
                             {"flip", picture.flip},
                             {"within", {{"tolerance", kPictureTolerance}, {"share", picture.shareWithin}}},
                             {"passed", picture.passed()}};
    }
    return object.dump(2);
}

} // namespace hyalite::parity
