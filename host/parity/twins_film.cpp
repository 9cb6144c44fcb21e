// What becomes of light on the way to the picture.
#include "parity/twins.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <array>

namespace hyalite::parity {

namespace {

using glm::dvec3;

constexpr std::size_t kWhole = SIZE_MAX / 1024; // of a buffer

void compareColor(const Stage& stage, std::size_t i, const glm::vec3& device, const dvec3& expected) {
    Answer a;
    a.vector("color", dvec3(device));
    Answer b;
    b.vector("color", expected);
    stage.compareExact(i, a, b);
}

double toNumber(const shared::FilmSum& sum) {
    return std::ldexp(sum.low + std::ldexp(sum.middle, 32) + std::ldexp(sum.high, 64),
                      -static_cast<int>(shared::kFilmFraction));
}

dvec3 filmColor(const shared::FilmColor& color) {
    return {toNumber(color.red), toNumber(color.green), toNumber(color.blue)};
}

constexpr std::size_t kHidden = SIZE_MAX;

// The counter that a photon counts in; kHidden: none, the camera does not see it.
std::size_t counterOf(const Sides& sides, const shared::Photon& photon, Nudge nudge) {
    const reference::CameraFrame& camera = sides.world().camera;
    const dvec3 position = nudge.point(dvec3(photon.position), sides.scale());
    const dvec3 way = position - camera.position;
    const double depth = glm::dot(way, camera.forward);
    if (depth <= 0) {
        return kHidden;
    }
    const double x = glm::dot(way, camera.right) / glm::dot(camera.right, camera.right) / depth;
    const double y = glm::dot(way, camera.up) / glm::dot(camera.up, camera.up) / depth;
    const double column = std::floor((x + 1) / 2 * camera.width);
    const double row = std::floor((1 - y) / 2 * camera.height);
    if (column < 0 || row < 0 || column >= camera.width || row >= camera.height) {
        return kHidden;
    }
    // What is nearer than 99.9 % of the way hides it; its own surface does not
    const double distance = glm::length(way);
    if (reference::traceClosest(sides.world(),
                                {.origin = camera.position, .direction = way / distance, .tMax = 0.999 * distance})) {
        return kHidden;
    }
    const auto pixel = static_cast<std::size_t>(row) * camera.width + static_cast<std::size_t>(column);
    return 4 * pixel + (photon.surface >> shared::kKindShift & 3U);
}

} // namespace

void compareSplatPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SplatPhotonsArguments>();
    const std::size_t counters = std::size_t{4} * args.camera.width * args.camera.height;
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto before = stage.seen.before<shared::uint>(args.counts, counters);
    const auto after = stage.seen.after<shared::uint>(args.counts, counters);
    constexpr std::uint32_t kTries = 8;
    std::vector<std::uint32_t> expected(counters, 0);
    std::vector<std::uint32_t> perhaps(counters, 0); // photons that count here or elsewhere, by a rounding
    for (const shared::Photon& photon : photons) {
        if (photon.surface == shared::kNone) {
            continue;
        }
        std::array<std::size_t, kTries> found{};
        for (std::uint32_t n = 0; n < kTries; ++n) {
            found.at(n) = counterOf(stage.sides, photon, Nudge(n));
        }
        if (found[0] != kHidden) {
            ++expected[found[0]];
        }
        if (std::ranges::count(found, found[0]) != kTries) {
            std::ranges::sort(found);
            const auto last = std::unique(found.begin(), found.end());
            std::for_each(found.begin(), last, [&](std::size_t counter) {
                if (counter != kHidden) {
                    ++perhaps[counter];
                }
            });
        }
    }
    for (std::size_t i = 0; i < counters; ++i) {
        const std::uint64_t counted = after[i] - before[i];
        Answer device;
        device.exact("count", counted);
        stage.compare(i, device, [&](Nudge nudge) {
            const std::uint64_t low = expected[i] > perhaps[i] ? expected[i] - perhaps[i] : 0;
            const bool isPossible = counted >= low && counted <= std::uint64_t{expected[i]} + perhaps[i];
            Answer answer;
            answer.exact("count", nudge.movesNothing() || !isPossible ? expected[i] : counted);
            return answer;
        });
    }
}

void compareSumPaths(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SumPathsArguments>();
    const auto pixels = stage.seen.before<shared::uint>(args.pixels, args.count);
    const auto light = stage.seen.before<glm::vec3>(args.light, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.radiance, kWhole);
    const auto after = stage.seen.after<glm::vec3>(args.radiance, kWhole);
    std::vector<dvec3> expected(before.begin(), before.end());
    for (std::size_t i = 0; i < args.count; ++i) {
        expected[pixels[i]] += dvec3(light[i]);
    }
    for (std::size_t pixel = 0; pixel < expected.size(); ++pixel) {
        compareColor(stage, pixel, after[pixel], expected[pixel]);
    }
}

void compareShowSurface(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ShowSurfaceArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.rays, args.count);
    const auto hits = stage.seen.before<shared::Hit>(args.hits, args.count);
    const auto colors = stage.seen.after<glm::vec3>(args.colors, args.count);
    const std::string_view field = args.shown == shared::kShowDepth ? "depth" : "normal";
    for (std::size_t i = 0; i < args.count; ++i) {
        const bool isHit = hits[i].object != shared::kNone;
        Answer device;
        device.vector(field, dvec3(colors[i]));
        stage.compare(i, device, [&](Nudge nudge) {
            Answer answer;
            if (args.shown == shared::kShowDepth) {
                answer.vector(field, dvec3(isHit ? double{hits[i].t} : 0));
                return answer;
            }
            reference::Ray ray = stage.sides.toTwin(rays[i]);
            auto hit = stage.sides.refined(ray, rays[i].from, hits[i]);
            ray.direction = nudge.direction(ray.direction);
            answer.vector(field, hit ? 0.5 + 0.5 * reference::evaluateSurface(stage.sides.world(), ray, *hit).normal
                                     : dvec3(0));
            return answer;
        });
    }
}

void compareAddGatheredLight(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::AddGatheredLightArguments>();
    const auto colors = stage.seen.before<glm::vec3>(args.colors, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.gathered, args.count);
    const auto after = stage.seen.after<glm::vec3>(args.gathered, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareColor(stage, i, after[i], dvec3(before[i]) + double{args.scale} * dvec3(colors[i]));
    }
}

// What the film adds of a colour: whole steps of 2^-44, rounded half up.
dvec3 inSteps(const dvec3& color) {
    return glm::floor(color * 0x1p44 + 0.5) * 0x1p-44;
}

void compareAccumulateFilm(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::AccumulateFilmArguments>();
    const auto colors = stage.seen.before<glm::vec3>(args.colors, args.count);
    const auto before = stage.seen.before<shared::FilmColor>(args.film, args.count);
    const auto after = stage.seen.after<shared::FilmColor>(args.film, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareColor(stage, i, glm::vec3(filmColor(after[i])), filmColor(before[i]) + inSteps(dvec3(colors[i])));
    }
}

void compareResolveFilm(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ResolveFilmArguments>();
    const auto first = stage.seen.before<shared::FilmColor>(args.first, args.count);
    const auto second = stage.seen.before<shared::FilmColor>(args.second, args.count);
    const auto image = stage.seen.after<glm::vec3>(args.image, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        compareColor(stage, i, image[i], double{args.scale} * (filmColor(first[i]) + filmColor(second[i])));
    }
}

// Of each pixel, then of the sums over them.
void compareEstimateError(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::EstimateErrorArguments>();
    const std::size_t layers = std::size_t{args.layers} * args.count;
    const std::size_t chunks = (args.count + shared::kErrorChunk - 1) / shared::kErrorChunk;
    const auto first = stage.seen.before<shared::FilmColor>(args.first, layers);
    const auto second = stage.seen.before<shared::FilmColor>(args.second, layers);
    const auto errors = stage.seen.after<glm::vec3>(args.errors, args.count);
    const auto sums = stage.seen.after<float>(args.sums, chunks);
    const auto n = double{args.firstPasses};
    const auto m = double{args.secondPasses};
    std::vector<double> expected(chunks, 0);
    // A mean's roundings change its error e by as much, and e^2 by 2 e times as much
    std::vector<double> scales(chunks, 0);
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
        // Both means scatter about that of all, each weighted with its share of the passes
        const dvec3 variance =
            n / (n + m) * (a / n - mean) * (a / n - mean) + m / (n + m) * (b / m - mean) * (b / m - mean);
        const dvec3 relative = variance / (mean * mean + 0.01);
        expected[i % chunks] += relative.x + relative.y + relative.z;
        scales[i % chunks] += 2 * (std::sqrt(relative.x) + std::sqrt(relative.y) + std::sqrt(relative.z));
        Answer device;
        device.vector("error", dvec3(errors[i]), largestComponent(mean));
        Answer answer;
        answer.vector("error", glm::sqrt(variance), largestComponent(mean));
        stage.compareExact(i, device, answer);
    }
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
        Answer device;
        device.number("sum", double{sums[chunk]}, scales[chunk]);
        Answer answer;
        answer.number("sum", expected[chunk], scales[chunk]);
        stage.compareExact(args.count + chunk, device, answer);
    }
}

} // namespace hyalite::parity
