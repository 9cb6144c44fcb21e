// Camera paths: their start, and what becomes of them at surfaces.
#include "parity/at_hit.h"

#include "reference/path.h"
#include "reference/sampling.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <numbers>

namespace hyalite::parity {

namespace {

using glm::dvec3;

// A shading on either side, slot by slot of the next rays.
struct Slots {
    std::array<bool, 2> alive{};
    std::array<reference::Ray, 2> rays;
    std::array<reference::CameraPath, 2> paths;
    double arriving =
        0; // throughput that came here: what a lobe makes of it may be a small share, and is right to that
};

struct NextFields {
    std::string_view alive, through, movedOff, seed, medium, origin, direction, beta, pdfW;
};
constexpr NextFields kFirst{"next 1",        "next 1 through",   "next 1 moved off", "next 1 seed", "next 1 medium",
                            "next 1 origin", "next 1 direction", "next 1 beta",      "next 1 pdfW"};
constexpr NextFields kSecond{"next 2",        "next 2 through",   "next 2 moved off", "next 2 seed", "next 2 medium",
                             "next 2 origin", "next 2 direction", "next 2 beta",      "next 2 pdfW"};

// `surface`: where the ray leaves, in double precision. A ray must start on the side that it goes to.
void addNext(Answer& answer, const NextFields& fields, const Sides& sides, const Slots& slots, std::size_t slot,
             const reference::Surface& surface, bool isCsg) {
    answer.exact(fields.alive, slots.alive[slot] ? 1 : 0);
    if (!slots.alive[slot]) {
        return;
    }
    const reference::Ray& ray = slots.rays[slot];
    const reference::CameraPath& path = slots.paths[slot];
    const double side = glm::dot(ray.direction, surface.geometricNormal) < 0 ? -1 : 1;
    answer.exact(fields.through, side < 0 ? 1 : 0);
    answer.exact(fields.movedOff,
                 isCsg || side * glm::dot(ray.origin - surface.position, surface.geometricNormal) >= 0 ? 1 : 0);
    answer.exact(fields.seed, path.samplerSeed);
    answer.exact(fields.medium, sides.numberOf(path.medium));
    answer.vector(fields.origin, ray.origin);
    answer.vector(fields.direction, ray.direction);
    answer.vector(fields.beta, path.beta, slots.arriving);
    answer.number(fields.pdfW, path.pdfW);
}

// `isOff`: it stands on the side that the path came from.
void addVisible(Answer& answer, const reference::VisiblePoint& x, bool isOff) {
    answer.exact("visible moved off", isOff ? 1 : 0);
    answer.exact("visible depth", x.depth);
    answer.exact("visible seed", x.samplerSeed);
    answer.exact("visible coat", x.coated ? 1 : 0);
    answer.vector("visible position", x.shadowOrigin);
    answer.vector("visible normal", x.normal);
    answer.vector("visible side", x.geometricNormal);
    answer.vector("visible f", x.f);
}

void addRough(Answer& answer, const reference::RoughPoint& x) {
    answer.exact("rough seed", x.samplerSeed);
    answer.vector("rough position", x.surface.position);
    answer.vector("rough normal", x.surface.normal);
    answer.vector("rough wo", x.wo);
    answer.vector("rough beta", x.beta);
    answer.number("rough eta", std::holds_alternative<Dielectric>(x.lobe.model) ? x.lobe.eta : 1);
    answer.number("rough alpha", x.lobe.alpha);
}

struct ShadeStage {
    const Stage& stage;
    shared::ShadeSurfaceArguments args;
    std::span<const shared::Ray> rays;
    std::span<const shared::Hit> hits;
    std::span<const shared::CameraPath> paths;
    std::span<const glm::vec3> emittedBefore, emitted;
    std::span<const shared::VisiblePoint> visible;
    std::span<const shared::RoughPoint> rough;
    std::span<const shared::Ray> nextRays;
    std::span<const shared::CameraPath> nextPaths;
    std::span<const shared::uint> alive;

    explicit ShadeStage(const Stage& s) : stage(s), args(s.seen.arguments<shared::ShadeSurfaceArguments>()) {
        const std::size_t slots = (1 + args.split) * std::size_t{args.count};
        const std::size_t all = SIZE_MAX / 1024; // results stand at pixels: as many as there are
        rays = s.seen.before<shared::Ray>(args.rays, args.count);
        hits = s.seen.before<shared::Hit>(args.hits, args.count);
        paths = s.seen.before<shared::CameraPath>(args.paths, args.count);
        emittedBefore = s.seen.before<glm::vec3>(args.emitted, all);
        emitted = s.seen.after<glm::vec3>(args.emitted, all);
        visible = s.seen.after<shared::VisiblePoint>(args.visiblePoints, all);
        rough = s.seen.after<shared::RoughPoint>(args.roughPoints, args.count);
        nextRays = s.seen.after<shared::Ray>(args.nextRays, slots);
        nextPaths = s.seen.after<shared::CameraPath>(args.nextPaths, slots);
        alive = s.seen.after<shared::uint>(args.alive, slots);
    }

    [[nodiscard]] bool hasRough(std::size_t i) const { return i < rough.size() && rough.size() == args.count; }

    // What the device made of path i; `surface`: the twin's, nullptr where the ray hits nothing.
    [[nodiscard]] Answer deviceAnswer(std::size_t i, const reference::Surface* surface, bool isCsg) const {
        const std::size_t result = args.split != 0 ? i : paths[i].pixel;
        // Not of an earlier surface, nor where nothing is reflected
        const bool isVisible = visible[result].depth == args.depth && visible[result].f != glm::vec3(0);
        const bool isRough = hasRough(i) && rough[i].depth != 0;
        Answer answer;
        answer.exact("visible", isVisible ? 1 : 0);
        answer.exact("rough", isRough ? 1 : 0);
        if (surface != nullptr) {
            Slots slots{.alive = {}, .rays = {}, .paths = {}, .arriving = largestComponent(dvec3(paths[i].beta))};
            for (std::size_t slot = 0; slot <= args.split; ++slot) {
                const std::size_t at = (1 + args.split) * i + slot;
                slots.alive[slot] = alive[at] != 0;
                slots.rays[slot] = stage.sides.toTwin(nextRays[at]);
                slots.paths[slot] = stage.sides.toTwin(nextPaths[at]);
            }
            addNext(answer, kFirst, stage.sides, slots, 0, *surface, isCsg);
            addNext(answer, kSecond, stage.sides, slots, 1, *surface, isCsg);
        }
        if (isVisible) {
            const reference::VisiblePoint x = stage.sides.toTwin(visible[result]);
            const bool isOff =
                surface == nullptr || isCsg || glm::dot(x.position - surface->position, surface->geometricNormal) >= 0;
            addVisible(answer, x, isOff);
        }
        if (isRough) {
            addRough(answer, stage.sides.toTwin(rough[i]));
        }
        answer.vector("emitted", dvec3(emitted[result]));
        return answer;
    }

    [[nodiscard]] Answer twinAnswer(std::size_t i, std::optional<reference::Hit> hit, Nudge nudge) const {
        const Sides& sides = stage.sides;
        reference::Ray ray = sides.toTwin(rays[i]);
        ray.origin = nudge.point(ray.origin, sides.scale());
        ray.direction = nudge.direction(ray.direction);
        const reference::CameraPath path = sides.toTwin(paths[i]);
        reference::Shading shading;
        Slots slots{.alive = {}, .rays = {}, .paths = {}, .arriving = largestComponent(path.beta)};
        reference::Surface surface{};
        if (hit) {
            hit->t = nudge.number(hit->t);
            hit->u = nudge.number(hit->u);
            hit->v = nudge.number(hit->v);
            surface = reference::evaluateSurface(sides.world(), ray, *hit);
            shading = reference::shadeSurface(sides.world(), ray, *hit, path, args.depth, args.pass);
            if (shading.visible && shading.visible->f == dvec3(0)) {
                shading.visible.reset();
            }
        } else {
            shading = reference::shadeMiss(sides.world(), ray, path);
        }
        // With one slot, reflected and refracted rays share it
        for (std::size_t child = 0; child < 2; ++child) {
            if (const auto& next = shading.next.at(child)) {
                const std::size_t slot = args.split != 0 ? child : 0;
                slots.alive.at(slot) = true;
                slots.rays.at(slot) = next->ray;
                slots.paths.at(slot) = next->path;
            }
        }
        const std::size_t result = args.split != 0 ? i : paths[i].pixel;
        const bool adds = args.split == 0 && args.depth > 1;
        Answer answer;
        answer.exact("visible", shading.visible ? 1 : 0);
        answer.exact("rough", shading.rough && hasRough(i) ? 1 : 0);
        if (hit) {
            addNext(answer, kFirst, sides, slots, 0, surface, true);
            addNext(answer, kSecond, sides, slots, 1, surface, true);
        }
        if (shading.visible) {
            addVisible(answer, *shading.visible, true);
        }
        if (shading.rough && hasRough(i)) {
            addRough(answer, *shading.rough);
        }
        answer.vector("emitted", shading.emitted + (adds ? dvec3(emittedBefore[result]) : dvec3(0)));
        return answer;
    }

    void compare(std::size_t i) const {
        compareAtHit(*this, i, [&] {
            return OffenderInputs{{"pixel", std::to_string(paths[i].pixel)}, {"beta", describe(dvec3(paths[i].beta))}};
        });
    }
};

} // namespace

void compareGenerateCameraRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::GenerateCameraRaysArguments>();
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    for (std::uint32_t pixel = 0; pixel < args.count; ++pixel) {
        const shared::CameraPath& path = paths[pixel];
        Answer device;
        device.exact("pixel", path.pixel);
        device.exact("seed", path.samplerSeed);
        device.exact("medium", path.medium);
        device.vector("beta", dvec3(path.beta));
        device.number("pdfW", double{path.pdfW});
        device.vector("origin", dvec3(rays[pixel].origin));
        device.vector("direction", dvec3(rays[pixel].direction));
        stage.compare(pixel, device, [&](Nudge) {
            const reference::Ray ray = reference::generateCameraRay(stage.sides.world(), pixel, args.pass);
            const reference::CameraPath started = reference::beginCameraPath(stage.sides.world(), pixel, args.pass);
            Answer answer;
            answer.exact("pixel", pixel);
            answer.exact("seed", started.samplerSeed);
            answer.exact("medium", stage.sides.numberOf(started.medium));
            answer.vector("beta", started.beta);
            answer.number("pdfW", started.pdfW);
            answer.vector("origin", ray.origin);
            answer.vector("direction", ray.direction);
            return answer;
        });
    }
}

void compareShadeSurface(const Stage& stage) {
    const ShadeStage shade(stage);
    for (std::size_t i = 0; i < shade.args.count; ++i) {
        shade.compare(i);
    }
}

void compareBouncePaths(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::BouncePathsArguments>();
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, args.count);
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, SIZE_MAX / 1024);
    const auto before = stage.seen.before<shared::uint>(args.alive, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.nextRays, args.count);
    const auto nextPaths = stage.seen.after<shared::CameraPath>(args.nextPaths, args.count);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[paths[i].pixel];
        if (point.depth != args.depth) {
            Answer device;
            device.exact("goes on", alive[i]);
            Answer answer;
            answer.exact("goes on", before[i]);
            stage.compareExact(i, device, answer);
            continue;
        }
        const auto answerOf = [&](const std::optional<reference::NextRay>& next, std::uint32_t pixel,
                                  std::uint32_t from) {
            Answer answer;
            answer.exact("goes on", next ? 1 : 0);
            if (next) {
                answer.exact("seed", next->path.samplerSeed);
                answer.exact("pixel", pixel);
                answer.exact("medium", sides.numberOf(next->path.medium));
                answer.exact("leaves", from);
                answer.vector("origin", next->ray.origin);
                answer.vector("direction", next->ray.direction);
                answer.vector("beta", next->path.beta);
                answer.number("pdfW", next->path.pdfW);
            }
            return answer;
        };
        std::optional<reference::NextRay> device;
        if (alive[i] != 0) {
            device = {sides.toTwin(rays[i]), sides.toTwin(nextPaths[i])};
        }
        stage.compare(
            i, answerOf(device, nextPaths[i].pixel, rays[i].from),
            [&](Nudge nudge) {
                reference::VisiblePoint x = sides.toTwin(point);
                x.normal = nudge.direction(x.normal);
                return answerOf(
                    reference::bouncePath(sides.world(), x, sides.toTwin(paths[i]), args.pass, nudge.shift()),
                    paths[i].pixel, point.from);
            },
            [&] {
                return OffenderInputs{{"position", describe(dvec3(point.position))},
                                      {"normal", describe(dvec3(point.normal))},
                                      {"f", describe(dvec3(point.f))},
                                      {"pixel", std::to_string(point.pixel)}};
            });
    }
}

void compareStartGatherRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::StartGatherRaysArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.rays, args.count);
    const auto paths = stage.seen.after<shared::CameraPath>(args.paths, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const auto answerOf = [](bool isAlive, std::uint32_t seed, const dvec3& origin, const dvec3& direction,
                             const dvec3& beta) {
        Answer answer;
        answer.exact("alive", isAlive ? 1 : 0);
        if (isAlive) {
            answer.exact("seed", seed);
            answer.vector("origin", origin);
            answer.vector("direction", direction);
            answer.vector("beta", beta);
        }
        return answer;
    };
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        stage.compare(i,
                      answerOf(alive[i] != 0, paths[i].samplerSeed, dvec3(rays[i].origin), dvec3(rays[i].direction),
                               dvec3(paths[i].beta)),
                      [&](Nudge nudge) {
                          if (point.depth == 0) {
                              return answerOf(false, 0, {}, {}, {});
                          }
                          reference::VisiblePoint x = stage.sides.toTwin(point);
                          x.normal = nudge.direction(x.normal);
                          const std::uint32_t sequence = shared::gatherSequence(x.samplerSeed);
                          const glm::dvec2 uv = reference::sampleUnitSquare(shared::pathSampler(sequence, args.pass),
                                                                            shared::kGatherDirection, nudge.shift());
                          const dvec3 direction = reference::cosineHemisphere(uv, x.normal);
                          const double c = 1 - std::clamp(glm::dot(direction, x.normal), 0.0, 1.0);
                          const double entering = x.coated ? 1 - std::pow(c, 5) : 1;
                          return answerOf(glm::dot(direction, x.geometricNormal) > 0, sequence, x.position, direction,
                                          x.f * (std::numbers::pi * entering));
                      });
    }
}

} // namespace hyalite::parity
