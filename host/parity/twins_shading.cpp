// What becomes of camera paths at surfaces, where they take one way on and where they take all.
#include "parity/at_hit.h"

#include "reference/integrators/path.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"
#include "shaders/shared/pixel_order.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

constexpr std::size_t kWhole = SIZE_MAX / 1024; // results stand at pixels: as many as there are

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

struct AtSurface {
    const Stage& stage;
    struct {
        std::uint32_t count, depth, pass;
    } args;
    bool isTree; // it takes all ways, and what it finds stands at the path's number; else at its pixel
    std::span<const shared::Ray> rays;
    std::span<const shared::Hit> hits;
    std::span<const shared::CameraPath> paths;
    std::span<const glm::vec3> emittedBefore, emitted;
    std::span<const shared::VisiblePoint> visible;
    std::span<const shared::RoughPoint> rough;
    std::span<const shared::Ray> nextRays;
    std::span<const shared::CameraPath> nextPaths;
    std::span<const shared::uint> alive;

    AtSurface(const Stage& s, const shared::ShadeSurfaceArguments& a)
        : stage(s), args{a.count, a.depth, a.pass}, isTree(false), rays(s.seen.before<shared::Ray>(a.rays, a.count)),
          hits(s.seen.before<shared::Hit>(a.hits, a.count)), paths(s.seen.before<shared::CameraPath>(a.paths, a.count)),
          emittedBefore(s.seen.before<glm::vec3>(a.emitted, kWhole)),
          emitted(s.seen.after<glm::vec3>(a.emitted, kWhole)),
          visible(s.seen.after<shared::VisiblePoint>(a.visiblePoints, kWhole)) {
        setNext(a);
    }

    AtSurface(const Stage& s, const shared::TraceWhittedArguments& a)
        : stage(s), args{a.count, a.depth, a.pass}, isTree(true), rays(s.seen.after<shared::Ray>(a.keptRays, a.count)),
          hits(s.seen.after<shared::Hit>(a.hits, a.count)),
          paths(s.seen.after<shared::CameraPath>(a.keptPaths, a.count)),
          emitted(s.seen.after<glm::vec3>(a.emitted, a.count)),
          visible(s.seen.after<shared::VisiblePoint>(a.visiblePoints, a.count)) {
        setNext(a);
    }

    template <class Arguments>
    void setNext(const Arguments& a) {
        rough = stage.seen.after<shared::RoughPoint>(a.roughPoints, a.count);
        nextRays = stage.seen.after<shared::Ray>(a.nextRays, children() * a.count);
        nextPaths = stage.seen.after<shared::CameraPath>(a.nextPaths, children() * a.count);
        alive = stage.seen.after<shared::uint>(a.alive, a.count);
    }

    [[nodiscard]] std::size_t children() const { return isTree ? 2 : 1; }
    [[nodiscard]] std::size_t resultOf(std::size_t i) const { return isTree ? i : paths[i].pixel; }
    [[nodiscard]] bool hasRough(std::size_t i) const { return i < rough.size() && rough.size() == args.count; }

    // What the device made of path i; `surface`: the twin's, nullptr where the ray hits nothing.
    [[nodiscard]] Answer deviceAnswer(std::size_t i, const reference::Surface* surface, bool isCsg) const {
        const std::size_t result = resultOf(i);
        // Not of an earlier surface, nor where nothing is reflected
        const bool isVisible = visible[result].depth == args.depth && visible[result].f != glm::vec3(0);
        const bool isRough = hasRough(i) && rough[i].depth != 0;
        Answer answer;
        answer.exact("visible", isVisible ? 1 : 0);
        answer.exact("rough", isRough ? 1 : 0);
        if (surface != nullptr) {
            Slots slots{.alive = {}, .rays = {}, .paths = {}, .arriving = largestComponent(dvec3(paths[i].beta))};
            for (std::size_t slot = 0; slot < alive[i] && slot < children(); ++slot) {
                const std::size_t at = children() * i + slot;
                slots.alive.at(slot) = true;
                slots.rays.at(slot) = stage.sides.toTwin(nextRays[at]);
                slots.paths.at(slot) = stage.sides.toTwin(nextPaths[at]);
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
        std::size_t slot = 0; // the first that is followed has the first
        for (const std::optional<reference::NextRay>& next : shading.next) {
            if (next) {
                slots.alive.at(slot) = true;
                slots.rays.at(slot) = next->ray;
                slots.paths.at(slot) = next->path;
                ++slot;
            }
        }
        const std::size_t result = resultOf(i);
        const bool adds = !isTree && args.depth > 1;
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

// What comes straight from the lamps to the visible point of path i, on top of what is emitted there.
void compareLight(const AtSurface& at, const shared::TraceWhittedArguments& args, std::span<const glm::vec3> light,
                  std::size_t i) {
    const Sides& sides = at.stage.sides;
    const shared::VisiblePoint& point = at.visible[i];
    const glm::vec3& emitted = at.emitted[i];
    const glm::vec3& arrived = light[args.fromCamera != 0 ? at.paths[i].pixel : i];
    const auto answerOf = [&](const dvec3& radiance, bool isLit) {
        Answer answer;
        answer.exact("lit", isLit ? 1 : 0);
        answer.vector("light", radiance);
        return answer;
    };
    at.stage.compare(
        i, answerOf(dvec3(arrived), arrived != emitted),
        [&](Nudge nudge) {
            dvec3 direct(0);
            if (point.depth != 0) {
                reference::VisiblePoint x = sides.toTwin(point);
                x.position = nudge.point(x.position, sides.scale());
                x.shadowOrigin = x.position;
                x.normal = nudge.direction(x.normal);
                for (std::uint32_t lamp = 0; lamp < args.lightCount; ++lamp) {
                    const auto sample = reference::sampleLight(sides.world(), x, args.pass, lamp, nudge.shift());
                    if (!sample) {
                        continue;
                    }
                    const dvec3 way = sample->to - sample->from;
                    const double distance = glm::length(way);
                    if (!sides.trace({.origin = sample->from, .direction = way / distance, .tMax = distance},
                                     point.from)) {
                        direct += sample->contribution;
                    }
                }
            }
            // What adds less than a rounding leaves no trace
            return answerOf(dvec3(emitted) + direct, emitted + glm::vec3(direct) != emitted);
        },
        [&] {
            return OffenderInputs{{"position", describe(dvec3(point.position))},
                                  {"normal", describe(dvec3(point.normal))},
                                  {"f", describe(dvec3(point.f))},
                                  {"pixel", std::to_string(point.pixel)}};
        });
}

} // namespace

void compareShadeSurface(const Stage& stage) {
    const AtSurface at(stage, stage.seen.arguments<shared::ShadeSurfaceArguments>());
    for (std::size_t i = 0; i < at.args.count; ++i) {
        at.compare(i);
    }
}

void compareTraceWhitted(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::TraceWhittedArguments>();
    const AtSurface at(stage, args);
    const auto light = stage.seen.after<glm::vec3>(args.light, kWhole);
    const std::uint32_t width = args.camera.width;
    const auto slots = stage.seen.before<shared::uint>(args.slots, args.count);
    const auto rays = stage.seen.before<shared::Ray>(args.rays, kWhole);
    const auto paths = stage.seen.before<shared::CameraPath>(args.paths, kWhole);
    const auto pixels = stage.seen.after<shared::uint>(args.pixels, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (args.fromCamera != 0) {
            const auto thread = static_cast<std::uint32_t>(i);
            const std::uint32_t pixel =
                shared::pixelOfThread(thread, thread / (shared::kTileSide * width), width, args.count);
            compareCameraRay(stage, i, pixel, args.pass, at.rays[i], at.paths[i]);
        } else {
            Answer device;
            device.exact("ray", sameBits(at.rays[i], rays[slots[i]]) ? 1 : 0);
            device.exact("path", sameBits(at.paths[i], paths[slots[i]]) ? 1 : 0);
            device.exact("pixel", pixels[i]);
            Answer expected;
            expected.exact("ray", 1);
            expected.exact("path", 1);
            expected.exact("pixel", paths[slots[i]].pixel);
            stage.compareExact(i, device, expected);
        }
        compareClosestHit(stage, i, at.rays[i], at.hits[i]);
        at.compare(i);
        compareLight(at, args, light, i);
    }
}

} // namespace hyalite::parity
