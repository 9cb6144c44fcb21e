// Scenes with an answer that neither the kernels nor their twins are trusted for: a closed form, or another scene that
// must look the same. Every row is asked of the integrators that claim it, on the device and in the reference.
#pragma once

#include "image/known_answer.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hyalite::testing {

using Names = std::vector<std::string_view>;
inline const Names kAllIntegrators{"ppm", "photonmap", "whitted", "path"};
inline const Names kIndirectIntegrators{"ppm", "photonmap", "path"};
inline const Names kPhotonIntegrators{"ppm", "photonmap"};

// A scene whose picture has a known mean.
struct Row {
    std::string name;
    std::string scene;   // text of its file, without the version
    double expected = 0; // mean radiance of the red channel [W/(m^2 sr)], not 0
    Names claims;        // the integrators
    Sharpness sharpness; // with 64 pixels or 16 renders
    bool exact = false;  // whitted's picture has no noise
    Independent independent = Independent::Pixels;
    std::map<std::string, std::string> files = {}; // texts beside the scene's file
};

// Scenes whose pictures add up to `factor` times the picture of another scene.
struct Symmetry {
    std::string name;
    std::string whole;
    std::vector<std::string> parts;
    double factor = 1;
    Names claims;
    Sharpness sharpness;                           // relative to the mean of that picture
    Independent independent = Independent::Pixels; // Renders: only the pictures' means add up
    std::map<std::string, std::string> files = {};
};

// Compares the rows of a table with what all renderers that claim them make of them: one comparison each.
void checkRows(FalseAlarms& alarms, const std::vector<Row>& rows);
void checkSymmetries(FalseAlarms& alarms, const std::vector<Symmetry>& symmetries);

// How many comparisons these make.
[[nodiscard]] std::size_t comparisons(const std::vector<Row>& rows);
[[nodiscard]] std::size_t comparisons(const std::vector<Symmetry>& symmetries);

// The tables.
[[nodiscard]] std::vector<Row> directLightRows();
[[nodiscard]] std::vector<Row> fluxRows();
[[nodiscard]] std::vector<Row> faceRows();
[[nodiscard]] std::vector<Row> slabRows();
[[nodiscard]] std::vector<Row> furnaceRows();
[[nodiscard]] std::vector<Row> mediaRows();
[[nodiscard]] std::vector<Row> proportionRows();
[[nodiscard]] std::vector<Symmetry> farSymmetries();
[[nodiscard]] std::vector<Symmetry> outsideSymmetries();
[[nodiscard]] std::vector<Symmetry> placementSymmetries();
[[nodiscard]] std::vector<Symmetry> lightSymmetries();
[[nodiscard]] std::vector<Symmetry> shapeSymmetries();

} // namespace hyalite::testing
