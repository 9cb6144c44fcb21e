// `hyalite compare`: the error of a picture against its reference, as a table, for scripts (--json) and CI (--max-…).
#include "cli/command.h"
#include "cli/number_check.h"
#include "image/error_map.h"
#include "image/flip.h"
#include "image/image_io.h"
#include "image/metrics.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace hyalite::cli {
namespace {

struct CompareOptions {
    std::string image;
    std::string reference;
    std::optional<std::array<int, 4>> crop;
    double within = 0.01;
    std::string difference; // file for the false-colour picture of FLIP; empty: none
    std::optional<double> maxRmse;
    std::optional<double> maxRelMse;
    std::optional<double> maxFlip;
    bool json = false;
};

struct Measure {
    std::string name;
    std::string key;
    double value;
    std::optional<double> bar;

    [[nodiscard]] bool passed() const { return !bar.has_value() || value <= *bar; }
};

struct Comparison {
    Crop crop;
    std::array<Measure, 3> measures;
    LargestDifference largest;
    double shareWithin;
    ErrorMap flip;

    [[nodiscard]] bool passed() const {
        return std::ranges::all_of(measures, [](const Measure& measure) { return measure.passed(); });
    }
};

// Reads a picture and checks that every pixel is finite.
Image readComparable(const std::string& path) {
    Image image = readImage(path);
    if (const std::size_t count = countNotFinite(image); count > 0) {
        throw Error(ExitCode::BadInput, SourceLocation{path},
                    std::to_string(count) + " pixels are NaN or infinite, so the picture cannot be compared");
    }
    return image;
}

Comparison compare(const Image& image, const Image& reference, const CompareOptions& options) {
    Crop crop = wholeOf(reference);
    if (options.crop) {
        const auto& [x, y, width, height] = *options.crop;
        crop = {x, y, width, height};
    }
    requireComparable(image, reference, crop);
    ErrorMap flip = flipMap(image, reference);
    return {crop,
            {Measure{"RMSE", "rmse", rmse(image, reference, crop), options.maxRmse},
             Measure{"relMSE", "relmse", relMse(image, reference, crop), options.maxRelMse},
             Measure{"FLIP", "flip", mean(flip, crop), options.maxFlip}},
            largestDifference(image, reference, crop),
            shareWithin(image, reference, options.within, crop),
            std::move(flip)};
}

void printJson(const CompareOptions& options, const Comparison& result) {
    nlohmann::ordered_json object;
    object["image"] = options.image;
    object["reference"] = options.reference;
    object["crop"] = {result.crop.x0, result.crop.y0, result.crop.width, result.crop.height};
    for (const Measure& measure : result.measures) {
        object[measure.key] = measure.value;
    }
    object["largest_difference"] = {{"value", result.largest.value}, {"x", result.largest.x}, {"y", result.largest.y}};
    object["within"] = {{"tolerance", options.within}, {"share", result.shareWithin}};
    for (const Measure& measure : result.measures) {
        if (measure.bar) {
            object["bars"][measure.key] = *measure.bar;
        }
    }
    object["passed"] = result.passed();
    std::cout << object.dump(2) << '\n';
}

void printTable(const CompareOptions& options, const Comparison& result) {
    std::ostringstream table; // leaves the format of std::cout alone
    table << std::left << std::setprecision(6);
    const auto label = [&table](const std::string& text) -> std::ostream& { return table << std::setw(20) << text; };
    for (const Measure& measure : result.measures) {
        label(measure.name) << std::setw(14) << measure.value;
        if (measure.bar) {
            table << (measure.passed() ? "at most " : "exceeds ") << *measure.bar;
        }
        table << '\n';
    }
    label("largest difference") << result.largest.value << " at (" << result.largest.x << ", " << result.largest.y
                                << ")\n";
    std::ostringstream within;
    within << "within " << 100.0 * options.within << " %";
    label(within.str()) << 100.0 * result.shareWithin << " % of pixels\n";
    std::cout << table.str();
}

void runCompare(const CompareOptions& options, ExitCode& exit) {
    if (!options.difference.empty()) {
        checkImageWritable(options.difference);
    }
    const Image image = readComparable(options.image);
    const Image reference = readComparable(options.reference);
    const Comparison result = compare(image, reference, options);
    if (!options.difference.empty()) {
        writeImage(
            options.difference, falseColour(result.flip, result.crop),
            {{"content", "FLIP, black (0) to white (1)"}, {"image", options.image}, {"reference", options.reference}});
    }
    if (options.json) {
        printJson(options, result);
    } else {
        printTable(options, result);
    }
    if (!result.passed()) {
        exit = ExitCode::ComparisonFailed;
    }
}

} // namespace

void addCompare(CLI::App& app, ExitCode& exit) {
    // Shared with the callback, which outlives this function.
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand("compare", "RMSE, relMSE and FLIP of a picture against a reference");
    command->add_option("A", options->image, "picture (.png or .exr)")->required();
    command->add_option("B", options->reference, "reference (.png or .exr)")->required();
    command->add_flag("--json", options->json, "print one JSON object");
    command->add_option("--crop", options->crop, "compare only these pixels")->delimiter(',')->type_name("X,Y,W,H");
    command->add_option("--within", options->within, "relative tolerance; prints the share of pixels within it")
        ->capture_default_str()
        ->check(finiteNumber(/*zeroAllowed*/ true))
        ->type_name("REL");
    command->add_option("-o,--output", options->difference, "write FLIP per pixel as a false-colour picture")
        ->type_name("FILE");
    command->add_option("--max-rmse", options->maxRmse, "exit with code 1 above this RMSE")
        ->check(finiteNumber(/*zeroAllowed*/ true));
    command->add_option("--max-relmse", options->maxRelMse, "exit with code 1 above this relMSE")
        ->check(finiteNumber(/*zeroAllowed*/ true));
    command->add_option("--max-flip", options->maxFlip, "exit with code 1 above this mean FLIP")
        ->check(finiteNumber(/*zeroAllowed*/ true));
    command->callback([options, &exit] { runCompare(*options, exit); });
}

} // namespace hyalite::cli
