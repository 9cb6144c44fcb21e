// Camera paths at surfaces, for integrators that follow a single next ray.
#include "parity/checks/checks.h"

#include "parity/checks/shading.h"
#include "parity/path_recorder.h"

namespace hyalite::parity {

namespace {

void compareShadeSurface(const Stage& stage) {
    const AtSurface at(stage, stage.seen.arguments<shared::ShadeSurfaceArguments>());
    for (std::size_t i = 0; i < at.args.count; ++i) {
        at.compare(i);
    }
}

void noteShading(PathRecorder& recorder, const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::ShadeSurfaceArguments>();
    const auto rays = dispatch.before<shared::Ray>(args.rays, args.count);
    const auto hits = dispatch.before<shared::Hit>(args.hits, args.count);
    const auto paths = dispatch.before<shared::CameraPath>(args.paths, args.count);
    const auto visible = dispatch.after<shared::VisiblePoint>(args.visiblePoints, Observed::kWhole);
    const auto nextRays = dispatch.after<shared::Ray>(args.nextRays, args.count);
    const auto alive = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const std::uint32_t pixel = paths[i].pixel;
        // How a path continues after a visible point depends on the integrator
        if (!recorder.hasEnded({false, args.pass, pixel})) {
            recorder.addShading({rays[i], hits[i], paths[i], visible[pixel], nextRays.subspan(i, alive[i])}, args.depth,
                                args.pass);
        }
    }
}

} // namespace

const Check kShadeSurface{.kernel = "shade_surface",
                          .compare = compareShadeSurface,
                          .fields = {kShading.all()},
                          .runs = kRunsTextures | kRunsReflectances,
                          .paths = {.take = noteShading}};

} // namespace hyalite::parity
