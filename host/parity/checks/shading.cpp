#include "parity/checks/shading.h"

#include "parity/checks/at_hit.h"
#include "reference/integrators/path.h"
#include "reference/lights/receiver.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

// The shading result of either side, one slot per next ray.
struct Slots {
    std::array<bool, 2> alive{};
    std::array<reference::Ray, 2> rays;
    std::array<reference::CameraPath, 2> paths;
    double arriving =
        0; // throughput on arrival: a lobe may pass on a small share of it, accurate relative to what arrived
};

struct NextFields {
    const Field &alive, &through, &movedOff, &seed, &medium, &origin, &direction, &beta, &pdfW;
};
constexpr NextFields kFirst{kShading.next1,          kShading.next1Through, kShading.next1MovedOff,
                            kShading.next1Seed,      kShading.next1Medium,  kShading.next1Origin,
                            kShading.next1Direction, kShading.next1Beta,    kShading.next1PdfW};
constexpr NextFields kSecond{kShading.next2,          kShading.next2Through, kShading.next2MovedOff,
                             kShading.next2Seed,      kShading.next2Medium,  kShading.next2Origin,
                             kShading.next2Direction, kShading.next2Beta,    kShading.next2PdfW};

// `surface`: where the ray starts, in double precision. A ray must start on the side into which it points.
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
    answer.exact(fields.medium, sides.numberOf(path.media));
    answer.vector(fields.origin, ray.origin);
    answer.vector(fields.direction, ray.direction);
    answer.vector(fields.beta, path.beta, slots.arriving);
    answer.number(fields.pdfW, path.pdfW);
}

// `position`: on the surface. `isOff`: the device's point is on the side that the path came from.
void addVisible(Answer& answer, const reference::VisiblePoint& x, const dvec3& position, bool isOff) {
    answer.exact(kShading.visibleMovedOff, isOff ? 1 : 0);
    answer.exact(kShading.visibleDepth, x.depth);
    answer.exact(kShading.visibleSeed, x.samplerSeed);
    answer.vector(kShading.visiblePosition, x.shadowOrigin);
    answer.vector(kShading.visibleOnSurface, position);
    answer.vector(kShading.visibleNormal, x.normal);
    answer.vector(kShading.visibleSide, x.geometricNormal);
    answer.vector(kShading.visibleWo, x.wo);
    answer.vector(kShading.visibleF, reference::receiverAt(x).f);
}

void addRough(Answer& answer, const reference::RoughPoint& x) {
    answer.exact(kShading.roughSeed, x.samplerSeed);
    answer.vector(kShading.roughPosition, x.surface.position);
    answer.vector(kShading.roughNormal, x.surface.normal);
    answer.vector(kShading.roughWo, x.wo);
    answer.vector(kShading.roughBeta, x.beta);
    answer.number(kShading.roughEta, x.lobe.eta);
    answer.number(kShading.roughAlpha, x.lobe.alpha);
}

} // namespace

Answer AtSurface::deviceAnswer(std::size_t i, const reference::Surface* surface, bool isCsg) const {
    const std::size_t result = resultOf(i);
    // Ignores points of an earlier surface and points that reflect nothing
    const bool isVisible = visible[result].depth == args.depth && stage.sides.reflects(visible[result]);
    const bool isRough = hasRough(i) && rough[i].depth != 0;
    Answer answer;
    answer.exact(kShading.visible, isVisible ? 1 : 0);
    answer.exact(kShading.rough, isRough ? 1 : 0);
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
        addVisible(answer, x, dvec3(visible[result].onSurface), isOff);
    }
    if (isRough) {
        addRough(answer, stage.sides.toTwin(rough[i]));
    }
    if (isEmissionUsed()) {
        answer.vector(kShading.emitted, dvec3(emitted[result]));
    }
    return answer;
}

Answer AtSurface::twinAnswer(std::size_t i, std::optional<reference::Hit> hit, Nudge nudge) const {
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
        if (shading.visible && reference::receiverAt(*shading.visible).f == dvec3(0)) {
            shading.visible.reset();
        }
    } else {
        shading = reference::shadeMiss(sides.world(), ray, path);
    }
    std::size_t slot = 0; // the first ray followed uses the first slot
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
    answer.exact(kShading.visible, shading.visible ? 1 : 0);
    answer.exact(kShading.rough, shading.rough && hasRough(i) ? 1 : 0);
    if (hit) {
        addNext(answer, kFirst, sides, slots, 0, surface, true);
        addNext(answer, kSecond, sides, slots, 1, surface, true);
    }
    if (shading.visible) {
        addVisible(answer, *shading.visible, shading.visible->position, true);
    }
    if (shading.rough && hasRough(i)) {
        addRough(answer, *shading.rough);
    }
    if (isEmissionUsed()) {
        answer.vector(kShading.emitted, shading.emitted + (adds ? dvec3(emittedBefore[result]) : dvec3(0)));
    }
    return answer;
}

void AtSurface::compare(std::size_t i) const {
    compareAtHit(*this, i, [&] {
        return OffenderInputs{{"pixel", std::to_string(paths[i].pixel)}, {"beta", describe(dvec3(paths[i].beta))}};
    });
}

} // namespace hyalite::parity
