// Accumulation of radiance into the picture.
#include "parity/checks/checks.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <cmath>

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct PathSumFields : FieldSet<1> {
    const Field& color = vector("color", kSum);
};
constexpr PathSumFields kPathSums;

struct ColorFields : FieldSet<1> {
    const Field& color = vector("color", kRounding);
};
constexpr ColorFields kColors;

struct ErrorFields : FieldSet<3> {
    const Field& error = vector("error", kMean);
    const Field& sum = number("sum", kSum);
    const Field& black = exact("black pixels");
};
constexpr ErrorFields kErrors;

void compareColor(const Stage& stage, std::size_t i, const Field& field, const glm::vec3& device,
                  const dvec3& expected) {
    Answer a;
    a.vector(field, dvec3(device));
    Answer b;
    b.vector(field, expected);
    stage.compareExact(i, a, b);
}

double toNumber(const shared::FilmSum& sum) {
    return std::ldexp(sum.low + std::ldexp(sum.middle, 32) + std::ldexp(sum.high, 64),
                      -static_cast<int>(shared::kFilmFraction));
}

dvec3 filmColor(const shared::FilmColor& color) {
    return {toNumber(color.red), toNumber(color.green), toNumber(color.blue)};
}

void compareSumPaths(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SumPathsArguments>();
    const auto pixels = stage.seen.before<shared::uint>(args.pixels, args.count);
    const auto light = stage.seen.before<glm::vec3>(args.light, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.radiance, Observed::kWhole);
    const auto after = stage.seen.after<glm::vec3>(args.radiance, Observed::kWhole);
    std::vector<dvec3> expected(before.begin(), before.end());
    for (std::size_t i = 0; i < args.count; ++i) {
        expected[pixels[i]] += dvec3(light[i]);
    }
    for (std::size_t pixel = 0; pixel < expected.size(); ++pixel) {
        compareColor(stage, pixel, kPathSums.color, after[pixel], expected[pixel]);
    }
}

void compareAddGatheredLight(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::AddGatheredLightArguments>();
    const auto colors = stage.seen.before<glm::vec3>(args.colors, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.gathered, args.count);
    const auto after = stage.seen.after<glm::vec3>(args.gathered, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareColor(stage, i, kColors.color, after[i], dvec3(before[i]) + double{args.scale} * dvec3(colors[i]));
    }
}

// A colour as the film adds it: in whole steps of 2^-44, rounded half up.
dvec3 inSteps(const dvec3& color) {
    return glm::floor(color * 0x1p44 + 0.5) * 0x1p-44;
}

void compareAccumulateFilm(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::AccumulateFilmArguments>();
    const auto colors = stage.seen.before<glm::vec3>(args.colors, args.count);
    const auto before = stage.seen.before<shared::FilmColor>(args.film, args.count);
    const auto after = stage.seen.after<shared::FilmColor>(args.film, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareColor(stage, i, kColors.color, glm::vec3(filmColor(after[i])),
                     filmColor(before[i]) + inSteps(dvec3(colors[i])));
    }
}

void compareResolveFilm(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ResolveFilmArguments>();
    const auto first = stage.seen.before<shared::FilmColor>(args.first, args.count);
    const auto second = stage.seen.before<shared::FilmColor>(args.second, args.count);
    const auto image = stage.seen.after<glm::vec3>(args.image, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareColor(stage, i, kColors.color, image[i],
                     double{args.scale} * (filmColor(first[i]) + filmColor(second[i])));
    }
}

// Compares the error of each pixel, then the sums over pixels.
void compareEstimateError(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::EstimateErrorArguments>();
    const std::size_t layers = std::size_t{args.layers} * args.count;
    const std::size_t chunks = (args.count + shared::kErrorChunk - 1) / shared::kErrorChunk;
    const auto first = stage.seen.before<shared::FilmColor>(args.first, layers);
    const auto second = stage.seen.before<shared::FilmColor>(args.second, layers);
    const auto sought = stage.seen.before<std::uint32_t>(args.sought, args.count);
    const auto errors = stage.seen.after<glm::vec3>(args.errors, args.count);
    const auto dark = stage.seen.after<glm::uvec2>(args.dark, chunks);
    const auto sums = stage.seen.after<float>(args.sums, chunks);
    const auto n = double{args.firstPasses};
    const auto m = double{args.secondPasses};
    std::vector<double> expected(chunks, 0);
    // Rounding of a mean changes its error e by the same amount, and e^2 by 2 e times that amount
    std::vector<double> scales(chunks, 0);
    std::vector<std::uint64_t> black(chunks, 0); // pixels, those where light was sought in the upper half
    for (std::size_t i = 0; i < args.count; ++i) {
        dvec3 a(0);
        dvec3 b(0);
        for (std::size_t layer = 0; layer < args.layers; ++layer) {
            if ((args.light >> layer & 1U) != 0) {
                a += filmColor(first[layer * args.count + i]);
                b += filmColor(second[layer * args.count + i]);
            }
        }
        const dvec3 mean = (a + b) / (n + m);
        // Scatter of both sequences' means about the overall mean, each weighted by its share of the passes
        dvec3 variance = n / (n + m) * (a / n - mean) * (a / n - mean) + m / (n + m) * (b / m - mean) * (b / m - mean);
        if (mean == dvec3(0)) {
            black[i % chunks] += sought[i] != 0 ? (std::uint64_t{1} << 32U) + 1 : 1;
            variance = dvec3(sought[i] != 0 ? 0.01 : 0); // unknown
        }
        const dvec3 relative = variance / (mean * mean + 0.01);
        expected[i % chunks] += relative.x + relative.y + relative.z;
        scales[i % chunks] += 2 * (std::sqrt(relative.x) + std::sqrt(relative.y) + std::sqrt(relative.z));
        Answer device;
        device.vector(kErrors.error, dvec3(errors[i]), largestComponent(mean));
        Answer answer;
        answer.vector(kErrors.error, glm::sqrt(variance), largestComponent(mean));
        stage.compareExact(i, device, answer);
    }
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        Answer device;
        device.number(kErrors.sum, double{sums[chunk]}, scales[chunk]);
        Answer answer;
        answer.number(kErrors.sum, expected[chunk], scales[chunk]);
        device.exact(kErrors.black, std::uint64_t{dark[chunk].y} << 32U | dark[chunk].x);
        answer.exact(kErrors.black, black[chunk]);
        stage.compareExact(args.count + chunk, device, answer);
    }
}

} // namespace

const Check kSumPaths{.kernel = "sum_paths", .compare = compareSumPaths, .fields = {kPathSums.all()}};
const Check kAddGatheredLight{
    .kernel = "add_gathered_light", .compare = compareAddGatheredLight, .fields = {kColors.all()}};
const Check kAccumulateFilm{.kernel = "accumulate_film", .compare = compareAccumulateFilm, .fields = {kColors.all()}};
const Check kResolveFilm{.kernel = "resolve_film", .compare = compareResolveFilm, .fields = {kColors.all()}};
const Check kEstimateError{.kernel = "estimate_error", .compare = compareEstimateError, .fields = {kErrors.all()}};

} // namespace hyalite::parity
