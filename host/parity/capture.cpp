#include "parity/capture.h"

#include "parity/checks/checks.h"
#include "reference/bsdf/custom_twins.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

// The scene's GLSL code that the kernel runs and that has no twin; nullptr: none.
const CustomCode* codeWithoutTwin(const Scene& scene, const Check& check) {
    const CustomCode* filter = scene.render.photonMap.customFilter.get();
    if ((check.runs & kRunsFilter) != 0 && filter != nullptr) {
        return filter;
    }
    const CustomCode* code = (check.runs & kRunsTextures) != 0 ? reference::textureWithoutTwin(scene) : nullptr;
    if (code == nullptr && (check.runs & kRunsReflectances) != 0) {
        code = reference::reflectanceWithoutTwin(scene);
    }
    return code;
}

Comparison comparisonOf(const std::string& kernel, const Check* check, double sceneScale) {
    std::vector<const Field*> fields;
    if (check != nullptr) {
        check->forEachField([&](const Field& field) { fields.push_back(&field); });
    }
    return {kernel, fields, sceneScale};
}

} // namespace

Capture::Capture(const gpu::Context& context, const gpu::TexelTables& tables, const Sides& sides,
                 std::set<std::string> wanted)
    : context_(context), tables_(tables), sides_(sides), wanted_(std::move(wanted)), recorder_(sides) {}

void Capture::before(const gpu::Dispatch& dispatch) {
    seen_.emplace(context_, tables_, dispatch);
}

void Capture::after(const gpu::Dispatch& dispatch) {
    ++dispatches_;
    const std::string& kernel = dispatch.kernel.name();
    const Check* check = checkOf(kernel);
    const CustomCode* withoutTwin = check != nullptr ? codeWithoutTwin(sides_.scene(), *check) : nullptr;
    if (check != nullptr && check->paths.take != nullptr && withoutTwin == nullptr) {
        check->paths.take(recorder_, *seen_);
    }
    if (!wanted_.empty() && !wanted_.contains(kernel)) {
        return;
    }
    auto stage = stages_.find(kernel);
    if (stage == stages_.end()) {
        stage = stages_.emplace(kernel, comparisonOf(kernel, check, sides_.scale())).first;
    }
    Comparison& comparison = stage->second;
    StageResult& result = comparison.result();
    if (result.dispatches++ == 0) {
        result.order = dispatches_;
    }
    const std::uint64_t failedBefore = result.failed;
    if (withoutTwin != nullptr) {
        result.withoutTwin = withoutTwin->file;
    } else if (check != nullptr) {
        check->compare({sides_, *seen_, comparison, "dispatch " + std::to_string(dispatches_)});
    }
    if (failedBefore == 0 && result.failed > 0) {
        result.firstFailure = dispatches_;
    }
}

std::vector<StageResult> Capture::finish() {
    std::vector<StageResult> results;
    for (auto& [name, comparison] : stages_) {
        for (FieldResult& field : comparison.result().fields) {
            std::ranges::sort(field.ulps);
        }
        results.push_back(std::move(comparison.result()));
    }
    stages_.clear();
    std::ranges::sort(results, {}, &StageResult::order);
    return results;
}

} // namespace hyalite::parity
