#include "parity/capture.h"

#include "parity/twins.h"
#include "reference/bsdf/custom_twins.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace hyalite::parity {

namespace {

// The scene's own code that a kernel runs and that has no twin; nullptr: none.
const CustomCode* codeWithoutTwin(const Scene& scene, std::string_view kernel) {
    constexpr std::array<std::string_view, 4> kTextured{"shade_surface", "trace_whitted", "scatter_photon",
                                                        "cast_shadow_photons"};
    constexpr std::array<std::string_view, 4> kReflecting{"shade_surface", "trace_whitted", "scatter_photon",
                                                          "sample_rough_lights"};
    if (kernel == "estimate_radiance") {
        return scene.render.photonMap.customFilter.get();
    }
    const CustomCode* code = nullptr;
    if (std::ranges::find(kTextured, kernel) != kTextured.end()) {
        code = reference::textureWithoutTwin(scene);
    }
    if (code == nullptr && std::ranges::find(kReflecting, kernel) != kReflecting.end()) {
        code = reference::reflectanceWithoutTwin(scene);
    }
    return code;
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
    recorder_.see(*seen_);
    const std::string& kernel = dispatch.kernel.name();
    if (!wanted_.empty() && !wanted_.contains(kernel)) {
        return;
    }
    Comparison& comparison = stages_.try_emplace(kernel, kernel, sides_.scale()).first->second;
    StageResult& result = comparison.result();
    if (result.dispatches++ == 0) {
        result.order = dispatches_;
    }
    const std::uint64_t failedBefore = result.failed;
    if (const CustomCode* code = codeWithoutTwin(sides_.scene(), kernel)) {
        result.withoutTwin = code->file;
    } else if (const TwinFunction twin = twinOf(kernel)) {
        twin({sides_, *seen_, comparison, "dispatch " + std::to_string(dispatches_)});
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
