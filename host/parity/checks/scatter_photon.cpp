// Photons at surfaces.
#include "parity/checks/checks.h"

#include "parity/checks/at_hit.h"
#include "parity/checks/stored_photon.h"
#include "parity/path_recorder.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct ScatterFields : FieldSet<20> {
    const Field& stored = exact("stored", kDecision);
    const Field& kind = exact("kind");
    const Field& length = exact("length");
    const Field& marked = exact("marked");
    const Field& goesOn = exact("goes on", kDecision);
    const Field& through = exact("through", kDecision);
    const Field& movedOff = exact("moved off", kGrazing);
    const Field& nextKind = exact("next kind", kDecision);
    const Field& nextPhoton = exact("next photon");
    const Field& nextLight = exact("next light");
    const Field& nextMedium = exact("next medium");
    const Field& position = place("position");
    const Field& direction = angle("direction", kPhotonDirection);
    const Field& normal = angle("normal", kPhotonNormal);
    const Field& power = vector("power", kWeight);
    const Field& nextOrigin = place("next origin");
    const Field& nextDirection = angle("next direction", kBounce);
    const Field& nextPower = vector("next power", kWeight);
    const Field& account = vector("account", kWeight);
};
constexpr ScatterFields kScatter;

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
        const std::size_t all = Observed::kWhole; // fates are indexed by photon number
        pass = {.sequence = args.sequence, .count = args.count, .kinds = args.kinds};
        rays = s.seen.before<shared::Ray>(args.rays, args.count);
        hits = s.seen.before<shared::Hit>(args.hits, args.count);
        paths = s.seen.before<shared::PhotonPath>(args.paths, args.count);
        photons = photonsStored(s.seen, args);
        fatesBefore = s.seen.before<shared::PhotonFate>(args.fates, all);
        fates = s.seen.after<shared::PhotonFate>(args.fates, all);
        nextRays = s.seen.after<shared::Ray>(args.nextRays, args.count);
        nextPaths = s.seen.after<shared::PhotonPath>(args.nextPaths, args.count);
        alive = s.seen.after<shared::uint>(args.alive, args.count);
    }

    // Sum of the flux stored, absorbed, escaped and cut off so far.
    [[nodiscard]] static dvec3 sum(const shared::PhotonFate& fate) {
        return dvec3(fate.stored) + dvec3(fate.absorbed) + dvec3(fate.escaped) + dvec3(fate.cutOff);
    }

    void addNext(Answer& answer, const std::optional<reference::Ray>& ray, const reference::PhotonPath& path,
                 const reference::Surface& surface, bool isCsg, double arriving) const {
        answer.exact(kScatter.goesOn, ray ? 1 : 0);
        if (!ray) {
            return;
        }
        const double side = glm::dot(ray->direction, surface.geometricNormal) < 0 ? -1 : 1;
        answer.exact(kScatter.through, side < 0 ? 1 : 0);
        answer.exact(kScatter.movedOff,
                     isCsg || side * glm::dot(ray->origin - surface.position, surface.geometricNormal) >= 0 ? 1 : 0);
        answer.exact(kScatter.nextKind, static_cast<std::uint64_t>(path.kind));
        answer.exact(kScatter.nextPhoton, path.photon);
        answer.exact(kScatter.nextLight, path.light);
        answer.exact(kScatter.nextMedium, stage.sides.numberOf(path.media));
        answer.vector(kScatter.nextOrigin, ray->origin);
        answer.vector(kScatter.nextDirection, ray->direction);
        answer.vector(kScatter.nextPower, path.power, arriving); // a lobe may pass on only a small share
    }

    [[nodiscard]] Answer deviceAnswer(std::size_t i, const reference::Surface* surface, bool isCsg) const {
        const shared::Photon& photon = photons[i];
        const bool isStored = photon.surface != shared::kNone;
        Answer answer;
        answer.exact(kScatter.stored, isStored ? 1 : 0);
        if (isStored) {
            addPhoton(answer, kScatter, photon.surface >> shared::kKindShift & 3U,
                      photon.surface >> shared::kLengthShift, (photon.direction & shared::kMarkedPhoton) != 0,
                      stage.sides.toTwin(photon));
        }
        const bool goesOn = alive[i] != 0;
        if (surface != nullptr) {
            addNext(answer, goesOn ? std::optional(stage.sides.toTwin(nextRays[i])) : std::nullopt,
                    stage.sides.toTwin(nextPaths[i]), *surface, isCsg, largestComponent(dvec3(paths[i].power)));
        }
        if (args.account != 0) {
            const std::uint32_t number = paths[i].photon;
            const dvec3 onward = goesOn ? dvec3(nextPaths[i].power) : dvec3(0);
            answer.vector(kScatter.account, sum(fates[number]) - sum(fatesBefore[number]) + onward);
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
            answer.exact(kScatter.stored, scatter.stored ? 1 : 0);
            if (scatter.stored) {
                const bool isDirect = path.kind == reference::PhotonKind::Direct;
                addPhoton(answer, kScatter, static_cast<std::uint32_t>(path.kind), isDirect ? path.light : args.depth,
                          (path.photon + args.depth) % shared::kMarkEvery == 0, *scatter.stored);
            }
            addNext(answer, scatter.next, scatter.path, reference::evaluateSurface(sides.world(), ray, *hit), true,
                    largestComponent(path.power));
        } else {
            answer.exact(kScatter.stored, 0);
        }
        if (args.account != 0) {
            answer.vector(kScatter.account, path.power); // no flux is lost
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

void compareScatterPhoton(const Stage& stage) {
    const ScatterStage scatter(stage);
    for (std::size_t i = 0; i < scatter.args.count; ++i) {
        scatter.compare(i);
    }
}

void noteScattering(PathRecorder& recorder, const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::ScatterPhotonArguments>();
    if (!recorder.setPhotonPass(args.sequence, args.kinds, args.maxDepth)) {
        return;
    }
    const auto rays = dispatch.before<shared::Ray>(args.rays, args.count);
    const auto hits = dispatch.before<shared::Hit>(args.hits, args.count);
    const auto paths = dispatch.before<shared::PhotonPath>(args.paths, args.count);
    const auto photons = photonsStored(dispatch, args);
    const auto nextRays = dispatch.after<shared::Ray>(args.nextRays, args.count);
    const auto alive = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        recorder.addScattering({.ray = rays[i],
                                .hit = hits[i],
                                .path = paths[i],
                                .isStored = photons[i].surface != shared::kNone,
                                .next = alive[i] != 0 ? &nextRays[i] : nullptr},
                               args.depth, args.sequence);
    }
}

} // namespace

const Check kScatterPhoton{.kernel = "scatter_photon",
                           .compare = compareScatterPhoton,
                           .fields = {kScatter.all()},
                           .runs = kRunsTextures | kRunsReflectances,
                           .paths = {.ofPhotons = true, .take = noteScattering}};

} // namespace hyalite::parity
