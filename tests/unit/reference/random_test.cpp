// The random numbers themselves: both kinds are uniform, and padded dimensions and derived sequences are uncorrelated.
#include "reference/lib/sampling.h"

#include "unit/reference/support.h"

#include "shaders/shared/random.h"

#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <map>
#include <set>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

constexpr std::uint32_t kPoints = 4096;

std::vector<dvec2> points(std::uint32_t seed, std::uint32_t dimension) {
    std::vector<dvec2> result;
    for (std::uint32_t index = 0; index < kPoints; ++index) {
        result.push_back(sampleUnitSquare({.seed = seed, .index = index}, dimension));
    }
    return result;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (a[i] - 0.5) * (b[i] - 0.5);
    }
    return 12 * sum / static_cast<double>(a.size()); // the variance of a uniform number is 1/12
}

std::vector<double> coordinate(const std::vector<dvec2>& points, int axis) {
    std::vector<double> values;
    for (const dvec2& p : points) {
        values.push_back(p[axis]);
    }
    return values;
}

// Chi-square of the counts in an 8 x 8 grid of cells: about 63 for numbers that are independent, 0 for Sobol points.
double chiSquare(const std::vector<dvec2>& points) {
    std::array<int, 64> counts{};
    for (const dvec2& p : points) {
        ++counts.at(static_cast<std::size_t>(8 * p.x) + 8 * static_cast<std::size_t>(8 * p.y));
    }
    const double expected = static_cast<double>(points.size()) / 64;
    double sum = 0;
    for (const int count : counts) {
        sum += (count - expected) * (count - expected) / expected;
    }
    return sum;
}

} // namespace

TEST_CASE("independent numbers fill the square with random deviations, Sobol points exactly evenly") {
    // 64 cells: mean 63, variance 126. Five standard deviations are 56.
    for (const std::uint32_t dimension : {0U, 1U, 17U}) {
        for (const std::uint32_t name : {1U, 2U, 3U}) {
            const auto seed = [&](std::uint32_t numbers) { return shared::renderSeed(name, numbers).sequence; };
            CHECK_THAT(chiSquare(points(seed(shared::kIndependentNumbers), dimension)), WithinAbs(63, 56));
            CHECK(chiSquare(points(seed(shared::kSobolNumbers), dimension)) == 0);
        }
    }
}

TEST_CASE("dimensions and sequences do not correlate, with either kind of numbers") {
    const std::uint32_t numbers = GENERATE(shared::kSobolNumbers, shared::kIndependentNumbers);
    // Of n independent pairs the correlation has a standard deviation of 1/sqrt(n) = 1/64; that of padded Sobol points
    // is smaller. Below, some twenty pairs: five standard deviations.
    constexpr double kFiveSigma = 5.0 / 64;
    const std::uint32_t root = shared::renderSeed(7, numbers).sequence;
    std::vector<std::vector<double>> coordinates;
    for (const std::uint32_t dimension : {0U, 1U, 2U}) {
        const std::vector<dvec2> both = points(root, dimension);
        coordinates.push_back(coordinate(both, 0));
        coordinates.push_back(coordinate(both, 1));
    }
    for (const std::uint32_t child : {0U, 1U}) {
        coordinates.push_back(coordinate(points(shared::deriveSequence(root, child), 0), 0));
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            CHECK(std::abs(correlation(coordinates[i], coordinates[j])) < kFiveSigma);
        }
    }
    // Successive numbers of one sequence: shuffled Sobol points keep some order within their strata, so only the others
    if (numbers == shared::kIndependentNumbers) {
        const std::vector<double> x = coordinates[0];
        CHECK(std::abs(correlation({x.begin(), x.end() - 1}, {x.begin() + 1, x.end()})) < kFiveSigma);
    }
}

TEST_CASE("every derived sequence keeps the kind of its numbers, and has a seed of its own") {
    const std::uint32_t numbers = GENERATE(shared::kSobolNumbers, shared::kIndependentNumbers);
    const shared::RenderSeed seed = shared::renderSeed(1, numbers);
    std::set<std::uint32_t> seeds;
    std::size_t made = 0;
    const auto note = [&](std::uint32_t sequence) {
        CHECK((sequence & 1U) == numbers);
        seeds.insert(sequence);
        ++made;
    };
    for (std::uint32_t i = 0; i < 20; ++i) {
        for (std::uint32_t pass = 0; pass < shared::kCameraSequences; ++pass) {
            const std::uint32_t path = shared::cameraSampler(seed, pass, i).seed;
            note(path);
            note(shared::gatherSequence(path));
        }
        note(shared::photonSequence(seed, shared::kGlobalPhotons, i));
        note(shared::photonSequence(seed, shared::kCausticPhotons, i));
    }
    CHECK(seeds.size() == made);
    CHECK(shared::renderSeed(1, numbers).sequence != shared::renderSeed(2, numbers).sequence);
}

TEST_CASE("the passes of a pixel, and their gathering rays, run through each of its sequences without a gap") {
    const shared::RenderSeed seed = shared::renderSeed(1, shared::kSobolNumbers);
    std::map<std::uint32_t, std::set<std::uint32_t>> indices;
    std::map<std::uint32_t, std::set<std::uint32_t>> gathering;
    constexpr std::uint32_t kRays = 3;
    for (std::uint32_t pass = 0; pass < 8 * shared::kCameraSequences; ++pass) {
        const shared::Sampler camera = shared::cameraSampler(seed, pass, 5);
        indices[camera.seed].insert(camera.index);
        CHECK(shared::pathSampler(camera.seed, pass).index == camera.index);
        for (std::uint32_t ray = 0; ray < kRays; ++ray) {
            gathering[camera.seed].insert(shared::pathSampler(camera.seed, shared::gatherPass(pass, kRays, ray)).index);
        }
    }
    CHECK(indices.size() == shared::kCameraSequences);
    for (const auto& [sequence, found] : indices) {
        CHECK(found == std::set<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7});
    }
    for (const auto& [sequence, found] : gathering) {
        CHECK(found.size() == std::size_t{8} * kRays);
        CHECK(*found.rbegin() == 8 * kRays - 1);
    }
}

namespace {

// A pair of numbers: sequence and dimension.
using Place = std::pair<std::uint32_t, std::uint32_t>;

// The numbers that a tree of rays takes [Whitted80], from one path on: those of each vertex's scattering and bounce,
// and of a point on each light. Smooth glass sends two paths on with sequences of their own, all else one with the
// same.
class NumbersOfTree {
public:
    NumbersOfTree(std::uint32_t lights, std::uint32_t depth) : lights_(lights), depth_(depth) {}

    void follow(std::uint32_t sequence, std::uint32_t vertex) {
        if (vertex == depth_) {
            return;
        }
        take(sequence, shared::cameraScatter(vertex));
        take(sequence, shared::cameraBounce(vertex));
        for (std::uint32_t light = 0; light < lights_; ++light) {
            take(shared::deriveSequence(sequence, light), shared::cameraLightPoint(vertex));
        }
        if (random_.unit() < 0.3) {
            follow(sequence, vertex + 1);
        } else {
            follow(shared::deriveSequence(sequence, 1), vertex + 1);
            follow(shared::deriveSequence(sequence, 2), vertex + 1);
        }
    }

    [[nodiscard]] std::size_t taken() const { return taken_; }
    [[nodiscard]] std::size_t different() const { return places_.size(); }

private:
    void take(std::uint32_t sequence, std::uint32_t dimension) {
        places_.insert({sequence, dimension});
        ++taken_;
    }

    std::uint32_t lights_;
    std::uint32_t depth_;
    Random random_;
    std::set<Place> places_;
    std::size_t taken_ = 0;
};

} // namespace

// The light `i` of a path and the i-th child of the path have the same sequence. They never take the same numbers of
// it: a path takes the dimensions 2 and 5 (mod 4 vertices), a light 3; two lights' sequences are alike only where their
// paths' are, and two paths of a tree differ in the number of the child at which they part.
TEST_CASE("no two choices in a ray tree use the same numbers, although lights and children share sequences") {
    const std::uint32_t root = shared::cameraSampler(shared::renderSeed(1, shared::kSobolNumbers), 0, 7).seed;
    NumbersOfTree numbers(/*lights*/ 70, /*depth*/ 7);
    numbers.follow(root, 0);
    // Some 2000 places a dimension at most, of 2^31 sequences: by chance alone two are alike once in a thousand trees
    CHECK(numbers.taken() > 2000);
    CHECK(numbers.different() == numbers.taken());
}
