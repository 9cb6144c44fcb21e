#include "transport/table.h"

#include "scene/model/integrators.h"
#include "transport/rendering.h"
#include "transport/scene_text.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kRenders = 16;
constexpr std::uint32_t kFewRenders = 4;
constexpr std::uint32_t kPassesOfPixels = 16; // where no photons are shared, times as many, to be about as precise
constexpr std::uint32_t kPassesOfRenders = 4;
constexpr double kExactly = 1e-3; // what a picture without noise must tell apart

// Radiances of the picture that do not depend on each other: its pixels, or the means of renders with the seeds first,
// first + 1, ….
std::vector<double> samplesOf(const Renderer& renderer, const Scene& scene, Independent independent,
                              std::uint32_t first = 1, std::uint32_t renders = kRenders) {
    if (independent == Independent::Pixels) {
        return pixelRatios(renderSeeds(renderer, scene, 1, 1).front(), everywhere(1));
    }
    std::vector<double> means;
    for (const Image& image : renderSeeds(renderer, scene, first, renders)) {
        means.push_back(meanOf(image));
    }
    return means;
}

// The scenes of a symmetry, for one renderer.
struct Question {
    Scene whole;
    std::vector<Scene> parts;
    double factor;
    Independent independent;

    // 1 + (factor whole - sum of the parts) / (factor mean of the whole), sample by sample. All have the same seeds:
    // whatever the pictures share cancels, and the differences' mean is still 0.
    [[nodiscard]] std::vector<double> differences(const Renderer& renderer, std::uint32_t first,
                                                  std::uint32_t renders) const {
        std::vector<double> d = samplesOf(renderer, whole, independent, first, renders);
        const double mean = estimate(d).mean;
        REQUIRE(mean > 0);
        for (double& sample : d) {
            sample = 1 + sample / mean;
        }
        for (const Scene& part : parts) {
            const std::vector<double> samples = samplesOf(renderer, part, independent, first, renders);
            for (std::size_t i = 0; i < d.size(); ++i) {
                d[i] -= samples[i] / (factor * mean);
            }
        }
        return d;
    }
};

Question questionOf(const Symmetry& symmetry, const Renderer& renderer) {
    const bool sharesPhotons = integratorNamed(renderer.integrator).reads("photons");
    const auto scene = [&](const std::string& body) {
        Scene made = sceneFrom(body, symmetry.files);
        if (!sharesPhotons) {
            made.render.passes *= symmetry.independent == Independent::Pixels ? kPassesOfPixels : kPassesOfRenders;
        }
        return made;
    };
    Question question{.whole = scene(symmetry.whole),
                      .parts = {},
                      .factor = symmetry.factor,
                      .independent = sharesPhotons ? Independent::Renders : symmetry.independent};
    for (const std::string& part : symmetry.parts) {
        question.parts.push_back(scene(part));
    }
    return question;
}

template <class Table>
std::size_t count(const Table& rows) {
    std::size_t sum = 0;
    for (const auto& row : rows) {
        sum += renderersOf(row.claims).size();
    }
    return sum;
}

} // namespace

void checkRows(FalseAlarms& alarms, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        Scene scene = sceneFrom(row.scene, row.files);
        for (const Renderer& renderer : renderersOf(row.claims)) {
            INFO(row.name << ", " << renderer.name);
            Sharpness sharpness = row.sharpness;
            if (row.exact && renderer.integrator == "whitted") {
                sharpness.sees = kExactly;
            }
            std::vector<double> ratios = samplesOf(renderer, scene, row.independent);
            for (double& ratio : ratios) {
                ratio /= row.expected;
            }
            CHECK(alarms.mean(ratios, 1, sharpness));
        }
    }
}

void checkSymmetries(FalseAlarms& alarms, const std::vector<Symmetry>& symmetries) {
    for (const Symmetry& symmetry : symmetries) {
        for (const Renderer& renderer : renderersOf(symmetry.claims)) {
            INFO(symmetry.name << ", " << renderer.name);
            const Question question = questionOf(symmetry, renderer);
            std::vector<double> differences = question.differences(renderer, 1, kFewRenders);
            // A few renders that agree to rounding say as much as many
            const bool agree =
                std::ranges::all_of(differences, [&](double d) { return std::abs(d - 1) <= symmetry.sharpness.bias; });
            if (question.independent == Independent::Renders && !agree) {
                const auto more = question.differences(renderer, 1 + kFewRenders, kRenders - kFewRenders);
                differences.insert(differences.end(), more.begin(), more.end());
            }
            CHECK(alarms.mean(differences, 1, symmetry.sharpness));
        }
    }
}

std::size_t comparisons(const std::vector<Row>& rows) {
    return count(rows);
}

std::size_t comparisons(const std::vector<Symmetry>& symmetries) {
    return count(symmetries);
}

} // namespace hyalite::testing
