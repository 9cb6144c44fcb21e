// A camera path at its hit: for shade_surface, which follows one next ray, and trace_whitted, which follows all.
#pragma once

#include "geometry/light_use.h"
#include "parity/check.h"
#include "reference/integrators/shading.h"

#include "shaders/shared/kernel_arguments.h"

#include <array>
#include <optional>
#include <span>

namespace hyalite::parity {

struct ShadingFields : FieldSet<37> {
    const Field& visible = exact("visible", kDecision);
    const Field& rough = exact("rough", kDecision);
    const Field& next1 = exact("next 1", kDecision);
    const Field& next2 = exact("next 2", kDecision);
    const Field& next1Through = exact("next 1 through", kDecision);
    const Field& next1MovedOff = exact("next 1 moved off", kGrazing);
    const Field& next1Seed = exact("next 1 seed");
    const Field& next1Medium = exact("next 1 medium");
    const Field& next2Through = exact("next 2 through", kDecision);
    const Field& next2MovedOff = exact("next 2 moved off", kGrazing);
    const Field& next2Seed = exact("next 2 seed");
    const Field& next2Medium = exact("next 2 medium");
    const Field& visibleMovedOff = exact("visible moved off", kGrazing);
    const Field& visibleDepth = exact("visible depth");
    const Field& visibleSeed = exact("visible seed");
    const Field& roughSeed = exact("rough seed");
    const Field& emitted = vector("emitted", kWeight);
    const Field& visiblePosition = place("visible position");
    const Field& visibleNormal = angle("visible normal", kNormal);
    const Field& visibleSide = angle("visible side", kSide);
    const Field& visibleOnSurface = place("visible on surface");
    const Field& visibleWo = angle("visible wo");
    const Field& visibleF = vector("visible f", kWeight);
    const Field& roughPosition = place("rough position");
    const Field& roughNormal = angle("rough normal", kNormal);
    const Field& roughWo = angle("rough wo");
    const Field& roughBeta = vector("rough beta", kWeight);
    const Field& roughEta = number("rough eta", kRounding, Scale::One);
    const Field& roughAlpha = number("rough alpha", kRounding, Scale::One);
    const Field& next1Origin = place("next 1 origin");
    const Field& next1Direction = angle("next 1 direction", kBounce);
    const Field& next1Beta = vector("next 1 beta", kWeight);
    const Field& next1PdfW = number("next 1 pdfW", kDensity, Scale::One);
    const Field& next2Origin = place("next 2 origin");
    const Field& next2Direction = angle("next 2 direction", kBounce);
    const Field& next2Beta = vector("next 2 beta", kWeight);
    const Field& next2PdfW = number("next 2 pdfW", kDensity, Scale::One);
};
inline constexpr ShadingFields kShading;

// Camera paths at their hits, for dispatches of both kernels.
struct AtSurface {
    const Stage& stage;
    struct {
        std::uint32_t count, depth, pass;
    } args;
    bool isTree; // follows all next rays, and results are indexed by path; else indexed by pixel
    std::span<const shared::Ray> rays;
    std::span<const shared::Hit> hits;
    std::span<const shared::CameraPath> paths;
    std::span<const glm::vec3> emittedBefore, emitted;
    std::span<const shared::VisiblePoint> visible;
    std::span<const shared::RoughPoint> rough;
    std::span<const shared::Ray> nextRays;
    std::span<const shared::CameraPath> nextPaths;
    std::span<const shared::uint> alive;

    AtSurface(const Stage& s, const shared::ShadeSurfaceArguments& a)
        : stage(s), args{a.count, a.depth, a.pass}, isTree(false), rays(s.seen.before<shared::Ray>(a.rays, a.count)),
          hits(s.seen.before<shared::Hit>(a.hits, a.count)), paths(s.seen.before<shared::CameraPath>(a.paths, a.count)),
          emittedBefore(s.seen.before<glm::vec3>(a.emitted, Observed::kWhole)),
          emitted(s.seen.after<glm::vec3>(a.emitted, Observed::kWhole)),
          visible(s.seen.after<shared::VisiblePoint>(a.visiblePoints, Observed::kWhole)) {
        setNext(a);
    }

    AtSurface(const Stage& s, const shared::TraceWhittedArguments& a)
        : stage(s), args{a.count, a.depths % shared::kDepthsUnit, a.pass}, isTree(true),
          rays(s.seen.after<shared::Ray>(a.keptRays, a.count)), hits(s.seen.after<shared::Hit>(a.hits, a.count)),
          paths(s.seen.after<shared::CameraPath>(a.keptPaths, a.count)),
          emitted(s.seen.after<glm::vec3>(a.emitted, a.count)),
          visible(s.seen.after<shared::VisiblePoint>(a.visiblePoints, a.count)) {
        setNext(a);
    }

    template <class Arguments>
    void setNext(const Arguments& a) {
        if (stage.sides.hasRoughLobes()) {
            rough = stage.seen.after<shared::RoughPoint>(a.roughPoints, a.count);
        }
        nextRays = stage.seen.after<shared::Ray>(a.nextRays, children() * a.count);
        nextPaths = stage.seen.after<shared::CameraPath>(a.nextPaths, children() * a.count);
        alive = stage.seen.after<shared::uint>(a.alive, a.count);
    }

    [[nodiscard]] std::size_t children() const { return isTree ? 2 : 1; }
    [[nodiscard]] std::size_t resultOf(std::size_t i) const { return isTree ? i : paths[i].pixel; }
    // The learning pass bounces at diffuse surfaces in every integrator, but the kernels of one that does not weight
    // the emission found that way differently. Nobody reads it.
    [[nodiscard]] bool isEmissionUsed() const { return args.pass != kLearningPass; }
    [[nodiscard]] bool hasRough(std::size_t i) const { return i < rough.size() && rough.size() == args.count; }

    // The device's result for path i; `surface`: the twin's, nullptr if the ray hits nothing.
    [[nodiscard]] Answer deviceAnswer(std::size_t i, const reference::Surface* surface, bool isCsg) const;
    // The twin's result for path i at this hit.
    [[nodiscard]] Answer twinAnswer(std::size_t i, std::optional<reference::Hit> hit, Nudge nudge) const;

    void compare(std::size_t i) const;
};

} // namespace hyalite::parity
