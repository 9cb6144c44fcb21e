#include "transport/table.h"

#include "scene/model/integrators.h"
#include "transport/rendering.h"
#include "transport/scene_text.h"

#include <catch2/catch_test_macros.hpp>

namespace hyalite::testing {

namespace {

constexpr std::uint32_t kRenders = 16;
constexpr double kExactly = 1e-3; // what a picture without noise must tell apart

std::vector<double> ratios(const Row& row, const Renderer& renderer, const Scene& scene) {
    const bool sharesPhotons = integratorNamed(renderer.integrator).reads("photons");
    if (row.independent == Independent::Pixels || !sharesPhotons) {
        return pixelRatios(renderSeeds(renderer, scene, 1, 1).front(), everywhere(row.expected));
    }
    std::vector<double> means;
    for (const Image& image : renderSeeds(renderer, scene, 1, kRenders)) {
        means.push_back(meanOf(image) / row.expected);
    }
    return means;
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
            CHECK(alarms.mean(ratios(row, renderer, scene), 1, sharpness));
        }
    }
}

void checkSymmetries(FalseAlarms& alarms, const std::vector<Symmetry>& symmetries) {
    for (const Symmetry& symmetry : symmetries) {
        const Scene whole = sceneFrom(symmetry.whole, symmetry.files);
        std::vector<Scene> parts;
        for (const std::string& part : symmetry.parts) {
            parts.push_back(sceneFrom(part, symmetry.files));
        }
        for (const Renderer& renderer : renderersOf(symmetry.claims)) {
            INFO(symmetry.name << ", " << renderer.name);
            std::vector<double> differences;
            double mean = 0;
            for (const Image& image : renderSeeds(renderer, whole, 1, kRenders)) {
                differences.push_back(symmetry.factor * meanOf(image));
                mean += differences.back() / kRenders;
            }
            std::uint32_t seed = 1;
            for (const Scene& part : parts) {
                seed += kRenders; // fresh numbers, so that all renders are independent
                const std::vector<Image> images = renderSeeds(renderer, part, seed, kRenders);
                for (std::size_t i = 0; i < images.size(); ++i) {
                    differences[i] -= meanOf(images[i]);
                }
            }
            REQUIRE(mean > 0);
            for (double& difference : differences) {
                difference = 1 + difference / mean;
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
