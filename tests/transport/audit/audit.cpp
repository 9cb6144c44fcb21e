#include "transport/audit/audit.h"

#include <algorithm>
#include <numbers>

namespace hyalite::testing {

namespace {

// Sample counts and radii with which the integrators are about as precise; photonmap's estimates keep their radius,
// since fewer photons are within it than it asks for.
void adjust(RenderSettings& render, const Renderer& renderer) {
    render.photons = 600;
    render.photonMap.causticPhotons = 600;
    render.radius = 0.15;
    render.photonMap.causticRadius = 0.15;
    render.photonMap.nearest = 512;
    render.photonMap.causticNearest = 512;
    render.photonMap.causticFilter = PhotonFilter::None;
    render.passes = renderer.integrator == "path" ? 8 : 2;
}

std::vector<Scene> viewsOf(const Draft& draft, const Renderer& renderer) {
    std::vector<Scene> scenes;
    for (std::size_t view = 0; view < draft.views(); ++view) {
        scenes.push_back(sceneFrom(draft.scene(view), draftFiles()));
        adjust(scenes.back().render, renderer);
    }
    return scenes;
}

constexpr double kRounding = 1e-4; // of sums in floats

// Both tests are one-sided: half of Student's tail.
double tailAbove(const Estimate& e, std::size_t samples, double bound) {
    if (e.mean <= bound) {
        return 1;
    }
    return e.standardError > 0 ? studentTail((e.mean - bound) / e.standardError, samples - 1) / 2 : 0;
}

} // namespace

namespace {

double balance(const Draft& draft, const std::vector<Scene>& views, const Renderer& renderer, std::uint32_t seed) {
    double sum = 0;
    for (const Scene& view : views) {
        sum += meanOf(renderSeeds(renderer, view, seed, 1).front());
    }
    switch (draft.audit) {
    case Audit::Lit: {
        constexpr double kWallArea = 4; // [m^2]
        return sum * std::numbers::pi / draft.albedo * (1 - draft.albedo) * kWallArea / draft.power();
    }
    case Audit::Sealed:
        return sum / 1e-30;
    default:
        return sum;
    }
}

} // namespace

Judgement judgeBalance(const Draft& draft, const Renderer& renderer, double level) {
    const std::vector<Scene> views = viewsOf(draft, renderer);
    Judgement judgement;
    std::uint32_t seed = 1;
    const auto estimateBy = [&](std::uint32_t renders) {
        std::vector<double> samples;
        for (std::uint32_t i = 0; i < renders; ++i) {
            samples.push_back(balance(draft, views, renderer, seed++));
        }
        judgement.renders += renders;
        judgement.ratio = estimate(samples);
        return judgement.ratio;
    };
    constexpr double kBound = 1 + kRounding;
    if (estimateBy(2).mean <= kBound) {
        return judgement;
    }
    constexpr std::uint32_t kSome = 12;
    constexpr std::uint32_t kMany = 48;
    if (tailAbove(estimateBy(kSome), kSome, kBound) > 0.01) {
        return judgement;
    }
    judgement.exceeds = tailAbove(estimateBy(kMany), kMany, kBound) < level;
    return judgement;
}

namespace {

constexpr double kAgreementBias = 0.01;

// Welch's test with the smaller number of degrees of freedom, which errs on the mild side.
Judgement compare(const Draft& draft, Backend backend, std::uint32_t first, std::uint32_t renders, double level) {
    std::array<Estimate, 2> means;
    for (const std::size_t i : {0U, 1U}) {
        const Renderer renderer{"", i == 0 ? "ppm" : "path", backend};
        Scene scene = sceneFrom(draft.scene(0), draftFiles());
        adjust(scene.render, renderer);
        scene.render.passes = i == 0 ? 4 : 128;
        scene.render.radius = 0.05;
        scene.render.photonMap.causticRadius = 0.05;
        std::vector<double> samples;
        const auto seed = static_cast<std::uint32_t>(first + i * 100000);
        for (const Image& image : renderSeeds(renderer, scene, seed, renders)) {
            samples.push_back(meanOf(image));
        }
        means.at(i) = estimate(samples);
    }
    const double scale = means[1].mean > 0 ? means[1].mean : 1;
    Judgement judgement{
        .ratio = {means[0].mean / scale, std::hypot(means[0].standardError, means[1].standardError) / scale},
        .renders = renders};
    const double excess = std::abs(judgement.ratio.mean - 1) - kAgreementBias;
    judgement.exceeds = excess > 0 && (judgement.ratio.standardError == 0 ||
                                       studentTail(excess / judgement.ratio.standardError, renders - 1) < level);
    return judgement;
}

} // namespace

// A suspicion by few renders has to be confirmed by many fresh ones: the tails of path's samples are heavy.
Judgement judgeAgreement(const Draft& draft, Backend backend, double level) {
    const Judgement first = compare(draft, backend, 1, 16, 0.01);
    return first.exceeds ? compare(draft, backend, 101, 96, level) : first;
}

Draft minimised(Draft draft, const std::function<bool(const Draft&)>& fails) {
    bool smaller = true;
    const auto attempt = [&](const Draft& candidate) {
        if (candidate.power() > 0 || draft.audit != Audit::Lit) {
            if (fails(candidate)) {
                draft = candidate;
                smaller = true;
                return true;
            }
        }
        return false;
    };
    while (smaller) {
        smaller = false;
        for (std::vector<Part> Draft::* parts : {&Draft::objects, &Draft::lights}) {
            for (std::size_t i = 0; i < (draft.*parts).size();) {
                Draft candidate = draft;
                (candidate.*parts).erase((candidate.*parts).begin() + static_cast<std::ptrdiff_t>(i));
                i += attempt(candidate) ? 0 : 1;
            }
        }
        for (std::size_t i = 0; i < draft.objects.size(); ++i) {
            constexpr std::string_view kPlain = "{type: diffuse, albedo: 0.5}";
            if (!draft.objects[i].material.empty() && draft.objects[i].material != kPlain) {
                Draft candidate = draft;
                candidate.objects[i].material = kPlain;
                static_cast<void>(attempt(candidate));
            }
        }
    }
    return draft;
}

} // namespace hyalite::testing
