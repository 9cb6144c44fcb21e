// Photons that go straight on through everything, and tell what lies in the shadow.
#include "parity/checks/checks.h"

#include "parity/checks/stored_photon.h"
#include "reference/bsdf/bsdf.h"
#include "reference/textures/texture.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct CastFields : FieldSet<12> {
    const Field& stored = exact("stored");
    const Field& kind = exact("kind");
    const Field& length = exact("length");
    const Field& marked = exact("marked");
    const Field& goesOn = exact("goes on");
    const Field& nextKind = exact("next kind");
    const Field& position = place("position");
    const Field& direction = angle("direction", kPhotonDirection);
    const Field& normal = angle("normal", kPhotonNormal);
    const Field& power = vector("power", kWeight);
    const Field& nextOrigin = place("next origin");
    const Field& nextDirection = angle("next direction");
};
constexpr CastFields kCast;

void compareCastShadowPhotons(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::CastShadowPhotonsArguments>();
    const auto rays = stage.seen.before<shared::Ray>(args.rays, args.count);
    const auto hits = stage.seen.before<shared::Hit>(args.hits, args.count);
    const auto paths = stage.seen.before<shared::PhotonPath>(args.paths, args.count);
    const auto photons = photonsStored(stage.seen, args);
    const auto nextRays = stage.seen.after<shared::Ray>(args.nextRays, args.count);
    const auto nextPaths = stage.seen.after<shared::PhotonPath>(args.nextPaths, args.count);
    const auto alive = stage.seen.after<shared::uint>(args.alive, args.count);
    const Sides& sides = stage.sides;
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::Photon& photon = photons[i];
        Answer device;
        device.exact(kCast.stored, photon.surface != shared::kNone ? 1 : 0);
        if (photon.surface != shared::kNone) {
            addPhoton(device, kCast, photon.surface >> shared::kKindShift & 3U, photon.surface >> shared::kLengthShift,
                      (photon.direction & shared::kMarkedPhoton) != 0, sides.toTwin(photon));
        }
        device.exact(kCast.goesOn, alive[i]);
        if (alive[i] != 0) {
            device.exact(kCast.nextKind, nextPaths[i].kind);
            device.vector(kCast.nextOrigin, dvec3(nextRays[i].origin));
            device.vector(kCast.nextDirection, dvec3(nextRays[i].direction));
        }
        const reference::Ray exactRay = sides.toTwin(rays[i]);
        const auto exactHit = sides.refined(exactRay, rays[i].from, hits[i]);
        stage.compare(i, device, [&](Nudge nudge) {
            Answer answer;
            if (!exactHit) {
                answer.exact(kCast.stored, 0);
                answer.exact(kCast.goesOn, 0);
                return answer;
            }
            reference::Ray ray = exactRay;
            ray.origin = nudge.point(ray.origin, sides.scale());
            ray.direction = nudge.direction(ray.direction);
            const reference::Surface surface = reference::evaluateSurface(sides.world(), ray, *exactHit);
            const bool isStored = surface.material != nullptr &&
                                  reference::diffusePart(reference::texturedModel(sides.world(), surface)).has_value();
            answer.exact(kCast.stored, isStored ? 1 : 0);
            if (isStored) {
                addPhoton(answer, kCast, paths[i].kind, paths[i].light, false,
                          {.position = surface.position,
                           .direction = -ray.direction,
                           .normal = surface.normal,
                           .power = dvec3(0)});
            }
            answer.exact(kCast.goesOn, 1);
            answer.exact(kCast.nextKind, shared::kPhotonShadow);
            answer.vector(kCast.nextOrigin, reference::leave(surface, ray.direction));
            answer.vector(kCast.nextDirection, ray.direction);
            return answer;
        });
    }
}

} // namespace

const Check kCastShadowPhotons{.kernel = "cast_shadow_photons",
                               .compare = compareCastShadowPhotons,
                               .fields = {kCast.all()},
                               .runs = kRunsTextures};

} // namespace hyalite::parity
