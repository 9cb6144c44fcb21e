// The film: sums that are exact in any order, invalid radiance, and merged films.
#include "kernel/kernel_support.h"
#include "render/film/checkpoint.h"
#include "render/film/film.h"
#include "unit/image/temporary_folder.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace hyalite::testing {

namespace {

std::uint32_t bits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

shared::FilmSum sumOf(float value) {
    REQUIRE(shared::filmFault(bits(value)) == shared::kFilmFaults);
    return shared::filmSum(bits(value));
}

float valueOf(const shared::FilmSum& sum) {
    return std::bit_cast<float>(shared::filmValue(sum));
}

bool same(const shared::FilmSum& a, const shared::FilmSum& b) {
    return a.low == b.low && a.middle == b.middle && a.high == b.high;
}

// Radiances of 16 orders of magnitude.
float randomValue(reference::test::Random& random) {
    return static_cast<float>(random.between(1, 2) * std::exp2(std::floor(random.between(-20, 40))));
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A film of 4 x 2 pixels and two layers, and colours for it.
struct SmallFilm {
    static constexpr std::uint32_t kPixels = 8;
    render::Device device{Gpu::shared().context(), Gpu::shared().compiler(), false};
    render::Film film{device, {4, 2}, {{"first"}, {"second"}}};

    void addPass(std::uint32_t pass, const std::vector<vec3>& first, const std::vector<vec3>& second) {
        film.beginPass(pass);
        const gpu::Array<vec3> firstColors(device.context, std::span(first), "first");
        const gpu::Array<vec3> secondColors(device.context, std::span(second), "second");
        film.add(device, 0, firstColors);
        film.add(device, 1, secondColors);
        device.commands.finish();
        film.endPass();
    }
};

} // namespace

TEST_CASE("a float of 2^-21 to 2^52 comes back from the film unchanged") {
    // 2^-21 has its last digit at 2^-44, the film's step
    for (const float value : {0x1p-21F, 0x1.fffffep-21F, 0x1.234567p-5F, 1.0F, 0x1.fffffep0F, 3.0e9F, 0x1.fffffep51F}) {
        CHECK(valueOf(sumOf(value)) == value);
    }
    CHECK(valueOf(sumOf(0.0F)) == 0.0F);
    CHECK(valueOf(sumOf(-0.0F)) == 0.0F);
    reference::test::Random random;
    for (int i = 0; i < 10000; ++i) {
        const float value = randomValue(random);
        REQUIRE(valueOf(sumOf(value)) == value);
    }
}

TEST_CASE("smaller values are rounded to a step of 2^-44, halves up") {
    CHECK(valueOf(sumOf(0x1.8p-44F)) == 0x1p-43F);
    CHECK(valueOf(sumOf(0x1.4p-44F)) == 0x1p-44F);
    CHECK(valueOf(sumOf(0x1p-45F)) == 0x1p-44F);
    CHECK(valueOf(sumOf(0x1.fffffep-46F)) == 0.0F);
    CHECK(valueOf(sumOf(std::numeric_limits<float>::denorm_min())) == 0.0F);
}

TEST_CASE("sums are the same in any order, and match wider arithmetic") {
    // 200 values below 2^41, all of them multiples of 2^-43: whole numbers and fractions, summed apart in 64 bits each
    reference::test::Random random;
    std::vector<float> values(200);
    std::ranges::generate(values, [&] { return randomValue(random); });
    shared::FilmSum forward{};
    shared::FilmSum backward{};
    std::uint64_t whole = 0;
    std::uint64_t steps = 0; // below one, of 2^-44 each: 200 of them fit easily
    for (std::size_t i = 0; i < values.size(); ++i) {
        forward = shared::filmAdd(forward, sumOf(values[i]));
        backward = shared::filmAdd(backward, sumOf(values[values.size() - 1 - i]));
        const auto value = double{values[i]};
        whole += static_cast<std::uint64_t>(std::floor(value));
        steps += static_cast<std::uint64_t>(std::ldexp(value - std::floor(value), 44));
    }
    whole += steps >> 44U;
    steps &= (std::uint64_t{1} << 44U) - 1;
    CHECK(same(forward, backward));
    // The 96 bits are whole * 2^44 + steps
    CHECK(forward.low == static_cast<std::uint32_t>(steps));
    CHECK(forward.middle == static_cast<std::uint32_t>((steps >> 32U) + (whole << 12U)));
    CHECK(forward.high == static_cast<std::uint32_t>(whole >> 20U));
}

TEST_CASE("a sum is rounded to the nearest float, ties to even") {
    // 2^24 + 1 and 2^24 + 3 lie halfway between floats; a step more or less decides
    const auto sum = [](float a, float b, float c) {
        return valueOf(shared::filmAdd(shared::filmAdd(sumOf(a), sumOf(b)), sumOf(c)));
    };
    CHECK(sum(0x1p24F, 1, 0) == 0x1p24F);
    CHECK(sum(0x1p24F, 1, 0x1p-44F) == 0x1p24F + 2);
    CHECK(sum(0x1p24F, 3, 0) == 0x1p24F + 4);
    CHECK(sum(0x1p24F, 0x1.fffffep0F, 0x1p-44F) == 0x1p24F + 2);
    CHECK(sum(0x1.fffffep50F, 0x1.fffffep50F, 0) == 0x1.fffffep51F);
    // All digits: the next power of two
    CHECK(sum(0x1.fffffep23F, 0.5F, 0) == 0x1p24F);
}

TEST_CASE("the device adds to the film what the host adds, whatever the order of the passes") {
    reference::test::Random random;
    std::vector<std::vector<vec3>> colors(6, std::vector<vec3>(SmallFilm::kPixels));
    for (auto& pass : colors) {
        std::ranges::generate(pass,
                              [&] { return vec3(randomValue(random), randomValue(random), randomValue(random)); });
    }
    SmallFilm forward;
    SmallFilm backward;
    for (std::uint32_t pass = 0; pass < 6; ++pass) {
        forward.addPass(pass, colors[pass], colors[5 - pass]);
        backward.addPass(5 - pass, colors[5 - pass], colors[pass]);
    }
    const render::FilmState there = forward.film.state();
    const render::FilmState back = backward.film.state();
    CHECK(back.passes.ranges() == std::vector<render::PassRange>{{0, 6}});
    for (std::size_t sequence = 0; sequence < 2; ++sequence) {
        for (std::size_t pixel = 0; pixel < SmallFilm::kPixels; ++pixel) {
            shared::FilmSum expected{};
            for (std::size_t pass = sequence; pass < 6; pass += 2) {
                expected = shared::filmAdd(expected, sumOf(colors[pass][pixel].y));
            }
            CHECK(same(there.sums.at(sequence)[pixel].green, expected));
            CHECK(same(back.sums.at(sequence)[pixel].green, expected));
        }
    }
    const LayeredImage a = forward.film.resolve(forward.device);
    const LayeredImage b = backward.film.resolve(backward.device);
    CHECK(a.picture.pixels == b.picture.pixels);
    CHECK(a.error->pixels == b.error->pixels);
}

TEST_CASE("invalid radiance is counted by layer and kind, reported by pass and pixel, and left out") {
    SmallFilm small;
    std::vector<vec3> good(SmallFilm::kPixels, vec3(1));
    std::vector<vec3> bad = good;
    bad[5] = {kNan, -1, 1};
    bad[3] = {-kInfinity, 1, kNan};
    bad[7] = {kInfinity, 0x1p52F, -0x1p-140F};
    small.addPass(4, good, good);
    small.addPass(9, good, bad);
    small.addPass(11, good, bad);
    const auto fault = [&](std::size_t layer, std::uint32_t kind) {
        return small.film.faults().at(layer * shared::kFilmFaults + kind);
    };
    for (std::uint32_t kind = 0; kind < shared::kFilmFaults; ++kind) {
        CHECK(fault(0, kind).count == 0);
        CHECK(fault(1, kind).pass == 9);
    }
    CHECK(fault(1, shared::kFilmNotANumber).count == 4);
    CHECK(fault(1, shared::kFilmNotANumber).pixel == 3);
    CHECK(fault(1, shared::kFilmInfinite).count == 4);
    CHECK(fault(1, shared::kFilmInfinite).pixel == 3);
    CHECK(fault(1, shared::kFilmNegative).count == 4);
    CHECK(fault(1, shared::kFilmNegative).pixel == 5);
    CHECK(fault(1, shared::kFilmTooBright).count == 2);
    CHECK(fault(1, shared::kFilmTooBright).pixel == 7);
    // Of three passes two had nothing at these places: their mean is a third, and every value is a number
    const LayeredImage image = small.film.resolve(small.device);
    CHECK(image.layers.at(1).image.pixels[5] == vec3(1 / 3.0F, 1 / 3.0F, 1));
    CHECK(image.layers.at(1).image.pixels[3] == vec3(1 / 3.0F, 1, 1 / 3.0F));
    const auto warnings =
        render::faultWarnings(small.film.faults(), small.film.layers(), {4, 2}, "hyalite inspect s.yaml");
    REQUIRE(warnings.size() == 4);
    CHECK(warnings[2] ==
          "4 values of layer 'second' were negative and left out, the first at pixel 1,1 of pass 9 (look "
          "at it with: hyalite inspect s.yaml --pixel 1,1 --pass 9)");
}

TEST_CASE("a sum that overflows the film is counted and left unchanged") {
    // 2^52 is the end: 2^51 twice is too much
    SmallFilm small;
    const std::vector<vec3> bright(SmallFilm::kPixels, vec3(0x1p51F, 1, 1));
    for (std::uint32_t pass = 0; pass < 6; pass += 2) { // all of one camera sequence
        small.addPass(pass, bright, std::vector<vec3>(SmallFilm::kPixels, vec3(0)));
    }
    CHECK(small.film.faults().at(shared::kFilmTooBright).count == std::uint64_t{2} * SmallFilm::kPixels);
    CHECK(small.film.faults().at(shared::kFilmTooBright).pass == 2);
    CHECK(small.film.state().sums.at(0)[0].red.high == 1U << 31U);
}

TEST_CASE("merged films count, add and overflow like a single one") {
    const std::vector<vec3> ones(SmallFilm::kPixels, vec3(1));
    const std::vector<vec3> bright(SmallFilm::kPixels, vec3(0x1p51F, kNan, 1));
    SmallFilm first;
    SmallFilm second;
    first.addPass(2, ones, bright);
    second.addPass(0, ones, bright);
    second.addPass(1, ones, ones);
    render::FilmState film = first.film.state();
    render::addFilm(film, second.film.state());
    CHECK(film.passes.text() == "0:3");
    CHECK(valueOf(film.sums.at(0)[3].blue) == 2);
    const auto fault = [&](std::uint32_t kind) { return film.faults.at(shared::kFilmFaults + kind); };
    CHECK(fault(shared::kFilmNotANumber).count == std::uint64_t{2} * SmallFilm::kPixels);
    CHECK(fault(shared::kFilmNotANumber).pass == 0);
    CHECK(fault(shared::kFilmTooBright).count == SmallFilm::kPixels);
}

TEST_CASE("a set of passes knows its ranges, its sequences and its overlap with others") {
    render::PassSet set({{8, 10}, {0, 3}, {3, 4}, {12, 13}, {5, 8}});
    CHECK(set.ranges() == std::vector<render::PassRange>{{0, 4}, {5, 10}, {12, 13}});
    CHECK(set.text() == "0:4, 5:10, 12:13");
    CHECK(set.count() == 10);
    CHECK(set.count(0) == 5); // 0 2 6 8 12
    CHECK(set.count(1) == 5); // 1 3 5 7 9
    CHECK(set.contains(3));
    CHECK_FALSE(set.contains(4));
    CHECK(set.countWithin({3, 9}) == 5); // 3 5 6 7 8
    CHECK(set.countWithin({10, 12}) == 0);
    CHECK(set.common({4, 6}) == render::PassRange{5, 6});
    CHECK_FALSE(set.common({10, 12}));
    set.add({4, 5});
    set.add({10, 12});
    CHECK(set.text() == "0:13");
}

TEST_CASE("a checkpoint keeps every counter, and merged parts sum all of them") {
    const test::TemporaryFolder folder;
    std::vector<render::Checkpoint> parts;
    for (std::uint32_t pass = 0; pass < 2; ++pass) {
        render::Checkpoint part;
        part.film.resolution = {1, 1};
        part.film.layers = {{"light"}};
        part.film.passes.add({pass, pass + 1});
        part.film.faults.resize(shared::kFilmFaults);
        part.film.sums.fill(std::vector<shared::FilmColor>(1));
        part.film.sought = {pass};
        for (const render::CounterRow& row : render::kCounters) {
            // Different ones, more than 32 bits each
            part.counts[row.counter] = (std::uint64_t{1} << 33U) * (pass + 1) + static_cast<std::uint64_t>(row.counter);
        }
        const auto file = folder / std::to_string(pass);
        render::writeCheckpoint(file, part);
        parts.push_back(render::readCheckpoint(file));
    }
    render::addCheckpoint(parts[0], parts[1], "1");
    CHECK(parts[1].film.sought == std::vector<std::uint32_t>{1});
    CHECK(parts[0].film.sought == std::vector<std::uint32_t>{1});
    for (const render::CounterRow& row : render::kCounters) {
        INFO(row.key);
        CHECK(parts[0].counts[row.counter] ==
              3 * (std::uint64_t{1} << 33U) + 2 * static_cast<std::uint64_t>(row.counter));
    }
}

} // namespace hyalite::testing
