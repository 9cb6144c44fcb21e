// `hyalite compare` as called: arguments in, text and exit code out.
#include "cli/command.h"
#include "image/image_io.h"
#include "unit/image/temporary_folder.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace hyalite;
using namespace hyalite::test;
using Catch::Approx;

namespace {

struct Outcome {
    ExitCode exit;
    std::string text;
};

// Runs the command and turns what it throws into the exit code, as main() does.
Outcome run(std::vector<std::string> arguments) {
    CLI::App app;
    ExitCode exit = ExitCode::Done;
    cli::addCompare(app, exit);
    arguments.insert(arguments.begin(), "compare");
    std::ranges::reverse(arguments); // as CLI11 wants them
    std::ostringstream text;
    std::streambuf* const before = std::cout.rdbuf(text.rdbuf());
    try {
        app.parse(arguments);
    } catch (const Error& error) {
        exit = error.code();
    } catch (const CLI::ParseError&) {
        exit = ExitCode::WrongUsage;
    }
    std::cout.rdbuf(before);
    return {exit, text.str()};
}

// A black reference of 4 x 2 pixels and a picture with one red pixel of radiance 0.5 at (2, 1).
struct Pictures {
    TemporaryFolder folder;
    std::string a = (folder / "a.exr").string();
    std::string b = (folder / "b.exr").string();

    Pictures() {
        Image image(4, 2);
        writeImage(b, image, {});
        image.at(2, 1) = {0.5F, 0, 0};
        writeImage(a, image, {});
    }
};

} // namespace

TEST_CASE("compare --json prints one object with every measure") {
    const Pictures pictures;
    const Outcome outcome = run({pictures.a, pictures.b, "--json"});
    CHECK(outcome.exit == ExitCode::Done);
    const nlohmann::json json = nlohmann::json::parse(outcome.text);
    // One of 8 * 3 values differs, by 0.5 from 0: RMSE sqrt(0.25 / 24), relMSE (0.25 / 0.01) / 24.
    CHECK(json.at("rmse").get<double>() == Approx(std::sqrt(0.25 / 24.0)));
    CHECK(json.at("relmse").get<double>() == Approx(25.0 / 24.0));
    CHECK(json.at("flip").get<double>() > 0.0);
    CHECK(json.at("largest_difference") == nlohmann::json{{"value", 0.5}, {"x", 2}, {"y", 1}});
    CHECK(json.at("within").at("tolerance") == 0.01);
    CHECK(json.at("within").at("share") == 7.0 / 8.0);
    CHECK(json.at("passed") == true);
    CHECK(json.at("crop") == nlohmann::json{0, 0, 4, 2});
}

TEST_CASE("compare prints a table") {
    const Pictures pictures;
    const Outcome outcome = run({pictures.a, pictures.b, "--max-rmse", "0.5"});
    CHECK(outcome.exit == ExitCode::Done);
    for (const char* part : {"RMSE", "relMSE", "FLIP", "at most 0.5", "0.5 at (2, 1)", "within 1 %", "87.5 %"}) {
        INFO(part << " in\n" << outcome.text);
        CHECK(outcome.text.find(part) != std::string::npos);
    }
}

TEST_CASE("compare exits with 1 when a bar is exceeded and still prints") {
    const Pictures pictures;
    // RMSE 0.102, relMSE 1.04; FLIP of these pictures lies above 0.001 and below 1.
    CHECK(run({pictures.a, pictures.b, "--max-rmse", "0.103"}).exit == ExitCode::Done);
    CHECK(run({pictures.a, pictures.b, "--max-rmse", "0.102"}).exit == ExitCode::ComparisonFailed);
    CHECK(run({pictures.a, pictures.b, "--max-relmse", "1.05"}).exit == ExitCode::Done);
    CHECK(run({pictures.a, pictures.b, "--max-relmse", "1.04"}).exit == ExitCode::ComparisonFailed);
    CHECK(run({pictures.a, pictures.b, "--max-flip", "1"}).exit == ExitCode::Done);
    CHECK(run({pictures.a, pictures.b, "--max-flip", "0.001"}).exit == ExitCode::ComparisonFailed);
    CHECK(run({pictures.a, pictures.a, "--max-rmse", "0", "--max-relmse", "0", "--max-flip", "0"}).exit ==
          ExitCode::Done);
    const Outcome failed = run({pictures.a, pictures.b, "--max-rmse", "0", "--json"});
    CHECK(nlohmann::json::parse(failed.text).at("passed") == false);
    CHECK(run({pictures.a, pictures.b, "--max-rmse", "0"}).text.find("exceeds 0") != std::string::npos);
}

TEST_CASE("compare uses the given crop and tolerance") {
    const Pictures pictures;
    const auto parse = [&](const std::vector<std::string>& arguments) {
        return nlohmann::json::parse(run(arguments).text);
    };
    CHECK(parse({pictures.a, pictures.b, "--json", "--crop", "0,0,2,2"}).at("rmse") == 0.0);
    CHECK(parse({pictures.a, pictures.b, "--json", "--crop", "2,1,1,1"}).at("rmse").get<double>() ==
          Approx(std::sqrt(0.25 / 3.0)));
    // With a as the reference, the red pixel's error is 100 %.
    CHECK(parse({pictures.b, pictures.a, "--json", "--within", "1"}).at("within").at("share") == 1.0);
    CHECK(parse({pictures.b, pictures.a, "--json", "--within", "0.99"}).at("within").at("share") == 7.0 / 8.0);
}

TEST_CASE("compare writes the difference as a picture of the crop") {
    const Pictures pictures;
    const std::string difference = (pictures.folder / "d.png").string();
    CHECK(run({pictures.a, pictures.b, "-o", difference}).exit == ExitCode::Done);
    const Image whole = readImage(difference);
    CHECK(whole.width == 4);
    CHECK(whole.at(2, 1).x > 0.0F); // some error, so at least dark red
    CHECK(run({pictures.a, pictures.a, "-o", difference, "--crop", "1,0,3,1"}).exit == ExitCode::Done);
    const Image cropped = readImage(difference);
    CHECK(cropped.width == 3);
    CHECK(cropped.height == 1);
    CHECK(cropped.at(1, 0) == glm::vec3(0.0F)); // no error: black
}

TEST_CASE("compare names bad input and wrong usage by its exit code") {
    const Pictures pictures;
    put(pictures.folder / "text.png", "no picture");
    writeImage(pictures.folder / "large.exr", Image(5, 2), {});
    const std::string missing = (pictures.folder / "missing.png").string();
    CHECK(run({pictures.a, missing}).exit == ExitCode::BadInput);
    CHECK(run({missing, pictures.b}).exit == ExitCode::BadInput);
    CHECK(run({(pictures.folder / "text.png").string(), pictures.b}).exit == ExitCode::BadInput);
    CHECK(run({pictures.a, (pictures.folder / "large.exr").string()}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "--crop", "0,0,9,9"}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "--crop", "0,0,1"}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "--crop=-1,0,1,1"}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "--within", "-1"}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "--max-rmse", "x"}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "-o", "d.jpg"}).exit == ExitCode::WrongUsage);
    CHECK(run({pictures.a, pictures.b, "-o", (pictures.folder / "no/d.png").string()}).exit ==
          ExitCode::OutputNotWritten);
}
