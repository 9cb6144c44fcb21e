// Photon paths: their start, and what becomes of them at surfaces.
#include "parity/at_hit.h"

#include "reference/bsdf/bsdf.h"
#include "reference/photons/projection_map.h"
#include "reference/textures/texture.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

Answer emissionAnswer(const Sides& sides, const reference::PhotonPath& path, const reference::Ray& ray) {
    Answer answer;
    answer.exact("light", path.light);
    answer.exact("photon", path.photon);
    answer.exact("kind", static_cast<std::uint64_t>(path.kind));
    answer.exact("medium", sides.numberOf(path.medium));
    answer.exact("shines", largestComponent(path.power) > 0 && ray.tMax > 0 ? 1 : 0);
    answer.vector("origin", ray.origin);
    answer.vector("direction", ray.direction);
    answer.vector("power", path.power);
    return answer;
}

void compareEmission(const Stage& stage, std::span<const shared::Ray> rays, std::span<const shared::PhotonPath> paths,
                     std::uint32_t first, const reference::PhotonPass& pass) {
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        const Sides& sides = stage.sides;
        const std::uint32_t photon = first + i;
        stage.compare(i, emissionAnswer(sides, sides.toTwin(paths[i]), sides.toTwin(rays[i])), [&](Nudge nudge) {
            const reference::Emission emission = reference::emitPhoton(sides.world(), photon, pass, nudge.shift());
            return emissionAnswer(sides, {.power = emission.power, .photon = photon, .light = emission.light},
                                  emission.ray);
        });
    }
}

void addPhoton(Answer& answer, std::uint32_t kind, std::uint32_t length, bool marked, const reference::Photon& photon) {
    answer.exact("kind", kind);
    answer.exact("length", length);
    answer.exact("marked", marked ? 1 : 0);
    answer.vector("position", photon.position);
    answer.vector("direction", photon.direction);
    answer.vector("normal", photon.normal);
    answer.vector("power", photon.power);
}

struct ScatterStage {
    const Stage& stage;
    shared::ScatterPhotonArguments args;
    reference::PhotonPass pass;
    std::span<const shared::Ray> rays;
    std::span<const shared::Hit> hits;
    std::span<const shared::PhotonPath> paths;
    std::span<const shared::Photon> photons;
    std::span<const shared::PhotonFate> fatesBefore, fates;
    std::span<const shared::Ray> nextRays;
    std::span<const shared::PhotonPath> nextPaths;
    std::span<const shared::uint> alive;

    explicit ScatterStage(const Stage& s) : stage(s), args(s.seen.arguments<shared::ScatterPhotonArguments>()) {
        const std::size_t all = SIZE_MAX / 1024; // fates stand at the photons' numbers
        pass = {.sequence = args.sequence, .count = args.count, .kinds = args.kinds};
        rays = s.seen.before<shared::Ray>(args.rays, args.count);
        hits = s.seen.before<shared::Hit>(args.hits, args.count);
        paths = s.seen.before<shared::PhotonPath>(args.paths, args.count);
        photons = s.seen.after<shared::Photon>(args.photons, args.firstPhoton + std::size_t{args.count});
        photons = photons.subspan(args.firstPhoton);
        fatesBefore = s.seen.before<shared::PhotonFate>(args.fates, all);
        fates = s.seen.after<shared::PhotonFate>(args.fates, all);
        nextRays = s.seen.after<shared::Ray>(args.nextRays, args.count);
        nextPaths = s.seen.after<shared::PhotonPath>(args.nextPaths, args.count);
        alive = s.seen.after<shared::uint>(args.alive, args.count);
    }

    // Stored, absorbed, escaped and cut off so far.
    [[nodiscard]] static dvec3 sum(const shared::PhotonFate& fate) {
        return dvec3(fate.stored) + dvec3(fate.absorbed) + dvec3(fate.escaped) + dvec3(fate.cutOff);
    }

    void addNext(Answer& answer, const std::optional<reference::Ray>& ray, const reference::PhotonPath& path,
                 const reference::Surface& surface, bool isCsg, double arriving) const {
        answer.exact("goes on", ray ? 1 : 0);
        if (!ray) {
            return;
        }
        const double side = glm::dot(ray->direction, surface.geometricNormal) < 0 ? -1 : 1;
        answer.exact("through", side < 0 ? 1 : 0);
        answer.exact("moved off",
                     isCsg || side * glm::dot(ray->origin - surface.position, surface.geometricNormal) >= 0 ? 1 : 0);
        answer.exact("next kind", static_cast<std::uint64_t>(path.kind));
        answer.exact("next photon", path.photon);
        answer.exact("next light", path.light);
        answer.exact("next medium", stage.sides.numberOf(path.medium));
        answer.vector("next origin", ray->origin);
        answer.vector("next direction", ray->direction);
        answer.vector("next power", path.power, arriving); // a lobe may pass on a small share
    }

    [[nodiscard]] Answer deviceAnswer(std::size_t i, const reference::Surface* surface, bool isCsg) const {
        const shared::Photon& photon = photons[i];
        const bool isStored = photon.surface != shared::kNone;
        Answer answer;
        answer.exact("stored", isStored ? 1 : 0);
        if (isStored) {
            addPhoton(answer, photon.surface >> shared::kKindShift & 3U, photon.surface >> shared::kLengthShift,
                      (photon.direction & shared::kMarkedPhoton) != 0, stage.sides.toTwin(photon));
        }
        const bool goesOn = alive[i] != 0;
        if (surface != nullptr) {
            addNext(answer, goesOn ? std::optional(stage.sides.toTwin(nextRays[i])) : std::nullopt,
                    stage.sides.toTwin(nextPaths[i]), *surface, isCsg, largestComponent(dvec3(paths[i].power)));
        }
        if (args.account != 0) {
            const std::uint32_t number = paths[i].photon;
            const dvec3 onward = goesOn ? dvec3(nextPaths[i].power) : dvec3(0);
            answer.vector("account", sum(fates[number]) - sum(fatesBefore[number]) + onward);
        }
        return answer;
    }

    [[nodiscard]] Answer twinAnswer(std::size_t i, std::optional<reference::Hit> hit, Nudge nudge) const {
        const Sides& sides = stage.sides;
        reference::Ray ray = sides.toTwin(rays[i]);
        ray.origin = nudge.point(ray.origin, sides.scale());
        ray.direction = nudge.direction(ray.direction);
        const reference::PhotonPath path = sides.toTwin(paths[i]);
        Answer answer;
        if (hit) {
            hit->t = nudge.number(hit->t);
            hit->u = nudge.number(hit->u);
            hit->v = nudge.number(hit->v);
            const auto scatter = reference::scatterPhoton(sides.world(), ray, *hit, path, args.depth, pass);
            answer.exact("stored", scatter.stored ? 1 : 0);
            if (scatter.stored) {
                const bool isDirect = path.kind == reference::PhotonKind::Direct;
                addPhoton(answer, static_cast<std::uint32_t>(path.kind), isDirect ? path.light : args.depth,
                          (path.photon + args.depth) % shared::kMarkEvery == 0, *scatter.stored);
            }
            addNext(answer, scatter.next, scatter.path, reference::evaluateSurface(sides.world(), ray, *hit), true,
                    largestComponent(path.power));
        } else {
            answer.exact("stored", 0);
        }
        if (args.account != 0) {
            answer.vector("account", path.power); // nothing is lost
        }
        return answer;
    }

    void compare(std::size_t i) const {
        compareAtHit(*this, i, [&] {
            return OffenderInputs{{"photon", std::to_string(paths[i].photon)},
                                  {"power", describe(dvec3(paths[i].power))}};
        });
    }
};

} // namespace

void compareEmitPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::EmitPhotonsArguments>();
    compareEmission(stage, stage.seen.after<shared::Ray>(args.rays, args.count),
                    stage.seen.after<shared::PhotonPath>(args.paths, args.count), args.first,
                    {.sequence = args.sequence, .count = args.ofPass});
}

void compareEmitCausticPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::EmitCausticPhotonsArguments>();
    compareEmission(stage, stage.seen.after<shared::Ray>(args.rays, args.count),
                    stage.seen.after<shared::PhotonPath>(args.paths, args.count), args.first,
                    {.sequence = args.sequence, .count = args.ofPass, .aimed = true});
}

void compareScatterPhoton(const Stage& stage) {
    const ScatterStage scatter(stage);
    for (std::size_t i = 0; i < scatter.args.count; ++i) {
        scatter.compare(i);
    }
}

void compareCastShadowPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::CastShadowPhotonsArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.rays, args.count);
    const auto hits = stage.seen.before<shared::Hit>(args.hits, args.count);
    const auto paths = stage.seen.before<shared::PhotonPath>(args.paths, args.count);
    const auto photons = stage.seen.after<shared::Photon>(args.photons, args.firstPhoton + std::size_t{args.count})
                             .subspan(args.firstPhoton);
    const auto nextRays = stage.seen.after<shared::Ray>(args.nextRays, args.count);
    const auto nextPaths = stage.seen.after<shared::PhotonPath>(args.nextPaths, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::Photon& photon = photons[i];
        Answer device;
        device.exact("stored", photon.surface != shared::kNone ? 1 : 0);
        if (photon.surface != shared::kNone) {
            addPhoton(device, photon.surface >> shared::kKindShift & 3U, photon.surface >> shared::kLengthShift,
                      (photon.direction & shared::kMarkedPhoton) != 0, sides.toTwin(photon));
        }
        device.exact("goes on", alive[i]);
        if (alive[i] != 0) {
            device.exact("next kind", nextPaths[i].kind);
            device.vector("next origin", dvec3(nextRays[i].origin));
            device.vector("next direction", dvec3(nextRays[i].direction));
        }
        const reference::Ray exactRay = sides.toTwin(rays[i]);
        const auto exactHit = sides.refined(exactRay, rays[i].from, hits[i]);
        stage.compare(i, device, [&](Nudge nudge) {
            Answer answer;
            if (!exactHit) {
                answer.exact("stored", 0);
                answer.exact("goes on", 0);
                return answer;
            }
            reference::Ray ray = exactRay;
            ray.origin = nudge.point(ray.origin, sides.scale());
            ray.direction = nudge.direction(ray.direction);
            const reference::Surface surface = reference::evaluateSurface(sides.world(), ray, *exactHit);
            const bool isStored = surface.material != nullptr &&
                                  reference::diffusePart(reference::texturedModel(sides.world(), surface)).has_value();
            answer.exact("stored", isStored ? 1 : 0);
            if (isStored) {
                addPhoton(answer, paths[i].kind, paths[i].light, false,
                          {.position = surface.position,
                           .direction = -ray.direction,
                           .normal = surface.normal,
                           .power = dvec3(0)});
            }
            answer.exact("goes on", 1);
            answer.exact("next kind", shared::kPhotonShadow);
            answer.vector("next origin", reference::leave(surface, ray.direction));
            answer.vector("next direction", ray.direction);
            return answer;
        });
    }
}

} // namespace hyalite::parity
