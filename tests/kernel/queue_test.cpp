// The kernels that keep lists: prefix sums, compaction, sums over a pixel's paths, the film.
#include "kernel/kernel_support.h"
#include "reference/film/film.h"
#include "render/film/film.h"
#include "render/wavefront/device_counter.h"
#include "render/wavefront/next_rays.h"
#include "render/wavefront/path_queue.h"
#include "render/wavefront/prefix_sum.h"

#include <numeric>

namespace hyalite::testing {

TEST_CASE("prefix sums equal the sequential ones at every size around the chunks") {
    BothSides both(reference::test::cornellBox());
    render::PrefixSum prefixSum(both.device);
    reference::test::Random random;
    // One chunk, chunks of chunks, and three levels; large before small, so that old contents would show
    for (const std::uint32_t count : {2097153U, 1U, 127U, 128U, 129U, 16384U, 16385U, 2097152U, 300000U}) {
        std::vector<shared::uint> values(count);
        for (auto& value : values) {
            value = static_cast<shared::uint>(random.between(0, 5));
        }
        const auto input = both.upload(values);
        const auto sums = both.room<shared::uint>(count + 1);
        prefixSum.run(both.device, input, sums, count);
        both.device.commands.finish();
        std::vector<shared::uint> expected(count + 1, 0);
        std::inclusive_scan(values.begin(), values.end(), expected.begin() + 1);
        CHECK(sums.read() == expected);
    }
}

TEST_CASE("the size of a queue says how many workgroups of which rows its elements need") {
    const auto sizeIs = [](std::uint32_t count, std::uint32_t x, std::uint32_t y) {
        const shared::QueueSize size = shared::queueSize(count, 7);
        return size.count == count && size.groupsX == x && size.groupsY == y && size.groupsZ == 1 && size.before == 7;
    };
    CHECK(sizeIs(0, 0, 0));
    CHECK(sizeIs(1, 1, 1));
    CHECK(sizeIs(64, 1, 1));
    CHECK(sizeIs(65, 2, 1));
    CHECK(sizeIs(32768 * 64, 32768, 1)); // a row
    CHECK(sizeIs(32768 * 64 + 1, 32768, 2));
    CHECK(sizeIs(0xffffffff, 32768, 2048)); // 2^26 groups
    CHECK(shared::chunksOf(0) == 0);
    CHECK(shared::chunksOf(128) == 1);
    CHECK(shared::chunksOf(129) == 2);
}

TEST_CASE("compaction keeps the paths that go on, in their order, and counts them, bounce after bounce") {
    BothSides both(reference::test::cornellBox());
    render::Compaction compaction(both.device);
    // Of one workgroup's sums, and of chunks; 2 and 1 levels
    for (const std::uint32_t count : {300'000U, 10'000U}) {
        CAPTURE(count);
        render::CameraQueue camera(both.device.context, count);
        render::PhotonQueue photon(both.device.context, count);
        const render::DeviceCounter counter(both.device.context, "paths");
        std::vector<shared::Ray> rays(count);
        std::vector<shared::CameraPath> cameraPaths(count);
        std::vector<shared::PhotonPath> photonPaths(count);
        std::vector<shared::uint> alive(count);
        std::vector<std::uint32_t> kept(count);
        std::iota(kept.begin(), kept.end(), 0U);
        camera.sizes.begin(both.device, count);
        photon.sizes.begin(both.device, count);
        std::uint64_t counted = 0;
        for (const std::uint32_t every : {3U, 2U, 1U}) { // a third goes on, half of these, none
            std::vector<std::uint32_t> next;
            for (std::uint32_t i = 0; i < kept.size(); ++i) {
                rays[i].tMax = static_cast<float>(kept[i]);
                cameraPaths[i].pixel = kept[i];
                photonPaths[i].media = kept[i];
                alive[i] = every > 1 && shared::hash(kept[i]) % every == 0 ? 1 : 0;
                if (alive[i] != 0) {
                    next.push_back(kept[i]);
                }
            }
            counted += kept.size();
            camera.nextRays.write(rays);
            camera.nextPaths.write(cameraPaths);
            camera.alive.write(alive);
            compaction.run(both.device, camera, counter);
            photon.nextRays.write(rays);
            photon.nextPaths.write(photonPaths);
            photon.alive.write(alive);
            compaction.run(both.device, photon);
            REQUIRE(camera.sizes.read(both.device).count == next.size());
            REQUIRE(photon.sizes.read(both.device).count == next.size());
            CHECK(camera.sizes.read(both.device).before == counted);
            const auto outRays = camera.rays.read();
            const auto outCamera = camera.paths.read();
            const auto outPhoton = photon.paths.read();
            for (std::size_t i = 0; i < next.size(); ++i) {
                REQUIRE(outRays[i].tMax == static_cast<float>(next[i]));
                REQUIRE(outCamera[i].pixel == next[i]);
                REQUIRE(outPhoton[i].media == next[i]);
            }
            kept = next;
        }
        CHECK(counter.read() == counted);
    }
}

TEST_CASE("a counter on the device carries into its upper word") {
    BothSides both(reference::test::cornellBox());
    render::CameraQueue queue(both.device.context, 1000);
    render::Compaction compaction(both.device);
    const render::DeviceCounter counter(both.device.context, "carrying");
    counter.set(0x5'ffff'fff0); // 16 from the carry
    queue.alive.fill(0);
    queue.sizes.begin(both.device, 1000);
    compaction.run(both.device, queue, counter);
    both.device.commands.finish();
    CHECK(counter.read() == 0x5'ffff'fff0 + 1000);
}

TEST_CASE("the slots of next rays are listed without gaps, in order, as far as there is room") {
    BothSides both(reference::test::cornellBox());
    render::NextRays nextRays(both.device);
    const gpu::Array<shared::uint> slots = both.room<shared::uint>(40000);
    // Chunks begun and full, few chunks and many; large before small, so that old contents would show
    for (const std::uint32_t count : {20000U, 1U, 127U, 128U, 129U, 5000U}) {
        std::vector<shared::uint> alive(count);
        std::vector<shared::uint> expected;
        for (std::uint32_t i = 0; i < count; ++i) {
            alive[i] = shared::hash(i) % 3;
            for (std::uint32_t child = 0; child < alive[i]; ++child) {
                expected.push_back(2 * i + child);
            }
        }
        const auto deviceAlive = both.upload(alive);
        render::QueueSizes sizes(both.device.context, 2, "test");
        sizes.begin(both.device, count);
        nextRays.count(both.device, deviceAlive, sizes);
        both.device.commands.finish();
        REQUIRE(sizes.readNext().count == expected.size());
        nextRays.list(both.device, deviceAlive, sizes, 2, slots);
        both.device.commands.finish();
        const auto listed = slots.read();
        CHECK(std::equal(expected.begin(), expected.end(), listed.begin()));

        const auto few = both.upload(std::vector<shared::uint>(expected.size() / 2, shared::kNone));
        nextRays.list(both.device, deviceAlive, sizes, 2, few);
        both.device.commands.finish();
        const auto first = few.read();
        CHECK(std::equal(first.begin(), first.end(), expected.begin()));
    }
}

TEST_CASE("the paths of a pixel are summed whole, and other pixels are left alone") {
    BothSides both(reference::test::cornellBox());
    // Pixel 3 has three paths, pixel 5 one, pixel 6 two; powers of two add without rounding
    const std::vector<shared::uint> pixels{3, 3, 3, 5, 6, 6};
    std::vector<vec3> light;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        light.emplace_back(vec3(1, 65, 1) * static_cast<float>(1U << i));
    }
    const auto devicePixels = both.upload(pixels);
    const auto deviceLight = both.upload(light);
    const auto radiance = both.upload(std::vector<vec3>(8, vec3(0.5)));
    both.run("sum_paths", shared::SumPathsArguments{devicePixels, deviceLight, radiance, 6, {}}, 6);
    const auto sum = radiance.read();
    CHECK(sum[3] == vec3(0.5 + 7, 0.5 + 7 + 64 * 7, 0.5 + 7));
    CHECK(sum[5] == vec3(0.5 + 8, 0.5 + 8 + 64 * 8, 0.5 + 8));
    CHECK(sum[6] == vec3(0.5 + 48, 0.5 + 48 + 64 * 48, 0.5 + 48));
    for (const std::size_t other : {0U, 1U, 2U, 4U, 7U}) {
        CHECK(sum[other] == vec3(0.5));
    }
}

TEST_CASE("the film starts black, adds passes, and resolves to their means, whose sum is the picture") {
    BothSides both(reference::test::cornellBox());
    render::Film film(both.device, {5, 3}, {{"emitted"}, {"direct"}, {"radius", /*isLight*/ false}, {"photons"}});
    const auto emitted = both.upload(std::vector<vec3>(15, vec3(1, 0, 0)));
    const auto direct = both.upload(std::vector<vec3>(15, vec3(0, 2, 0)));
    auto values = std::vector<vec3>(15, vec3(0, 0, 4));
    values[7] = vec3(8);
    const auto gathered = both.upload(values);
    for (std::uint32_t pass = 0; pass < 4; ++pass) {
        film.beginPass(pass);
        film.add(both.device, 0, emitted);
        film.add(both.device, 1, direct);
        film.add(both.device, 2, gathered);
        film.add(both.device, 3, gathered);
        both.device.commands.finish();
        film.endPass();
    }
    const LayeredImage result = film.resolve(both.device);
    REQUIRE(result.layers.size() == 4);
    CHECK(result.layers[1].name == "direct");
    CHECK(result.layers[1].image.at(2, 1) == vec3(0, 2, 0));
    CHECK(result.layers[2].image.at(2, 1) == vec3(8));
    const Image& image = result.picture; // without the radius
    CHECK(image.width == 5);
    CHECK(image.height == 3);
    CHECK(image.at(2, 1) == vec3(9, 10, 8)); // pixel 7
    CHECK(image.at(0, 0) == vec3(1, 2, 4));
    CHECK(image.at(4, 2) == vec3(1, 2, 4));
}

TEST_CASE("the film's error is the reference's, for even and odd numbers of passes, on pictures of many chunks") {
    BothSides both(reference::test::cornellBox());
    constexpr std::uint32_t kWidth = 37; // 37 * 11 pixels: six chunks and a rest
    constexpr std::uint32_t kHeight = 11;
    const std::vector<LayerKind> layers{{"a"}, {"radius", /*isLight*/ false}, {"b"}};
    render::Film film(both.device, {kWidth, kHeight}, layers);
    // Light is sought in every fifth pixel, and every third is black: every fifteenth is unknown
    const auto seeks = [](std::uint32_t pixel, std::uint32_t /*pass*/) { return pixel % 5 == 0; };
    constexpr std::uint32_t kUnknown = (kWidth * kHeight + 14) / 15;
    reference::LayeredFilm expected(kWidth, kHeight, layers, seeks);
    both.device.commands.finish();
    render::FilmState marked = film.state();
    for (std::uint32_t pixel = 0; pixel < marked.sought.size(); ++pixel) {
        marked.sought[pixel] = seeks(pixel, 0) ? 1 : 0;
    }
    film.restore(both.device, marked);
    reference::test::Random random;
    const auto picture = [&] {
        std::vector<vec3> colors(std::size_t{kWidth} * kHeight);
        for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
            colors[pixel] = pixel % 3 == 0 ? dvec3(0) : dvec3(random.unit(), 10 * random.unit(), 0.01 * random.unit());
        }
        return both.upload(colors);
    };
    for (std::uint32_t pass = 0; pass < 7; ++pass) {
        const std::array colors{picture(), picture(), picture()};
        film.beginPass(pass);
        for (std::size_t layer = 0; layer < 3; ++layer) {
            film.add(both.device, layer, colors.at(layer));
        }
        both.device.commands.finish();
        film.endPass();
        expected.addPass([&](std::uint32_t pixel) {
            return std::array<dvec3, 3>{colors[0].host()[pixel], colors[1].host()[pixel], colors[2].host()[pixel]};
        });
        const std::optional<double> error = film.estimateError(both.device).error;
        REQUIRE(error.has_value() == (pass > 0));
        if (error) {
            // Each of the 37 * 11 * 3 squares is off by some roundings of 6e-8, and where the two means are close by
            // these relative to their difference; the large ones decide
            CHECK_THAT(*error, Catch::Matchers::WithinRel(expected.error().error.value(), 1e-5));
            CHECK(film.estimateError(both.device).darkPixels == kUnknown);
            CHECK(expected.error().darkPixels == kUnknown);
            CHECK(film.estimateError(both.device).error == error); // the same bits
        }
    }
    const LayeredImage device = film.resolve(both.device);
    const LayeredImage reference = expected.mean();
    for (std::size_t pixel = 0; pixel < device.picture.pixels.size(); ++pixel) {
        REQUIRE(distance(device.error->pixels[pixel], dvec3(reference.error->pixels[pixel])) < 1e-5); // of up to 10
    }
}

} // namespace hyalite::testing
