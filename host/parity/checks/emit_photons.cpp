// The start of photon paths at lights.
#include "parity/checks/checks.h"

#include "parity/path_recorder.h"
#include "reference/photons/projection_map.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct EmissionFields : FieldSet<8> {
    const Field& light = exact("light", kDecision);
    const Field& photon = exact("photon");
    const Field& kind = exact("kind");
    const Field& medium = exact("medium");
    const Field& shines = exact("shines", kGrazing);
    const Field& origin = place("origin");
    const Field& direction = angle("direction", kSampled);
    const Field& power = vector("power", kWeight);
};
constexpr EmissionFields kEmission;

Answer emissionAnswer(const Sides& sides, const reference::PhotonPath& path, const reference::Ray& ray) {
    Answer answer;
    answer.exact(kEmission.light, path.light);
    answer.exact(kEmission.photon, path.photon);
    answer.exact(kEmission.kind, static_cast<std::uint64_t>(path.kind));
    answer.exact(kEmission.medium, sides.numberOf(path.media));
    answer.exact(kEmission.shines, largestComponent(path.power) > 0 && ray.tMax > 0 ? 1 : 0);
    answer.vector(kEmission.origin, ray.origin);
    answer.vector(kEmission.direction, ray.direction);
    answer.vector(kEmission.power, path.power);
    return answer;
}

void compareEmission(const Stage& stage, std::span<const shared::Ray> rays, std::span<const shared::PhotonPath> paths,
                     std::uint32_t first, const reference::PhotonPass& pass) {
    for (std::uint32_t i = 0; i < paths.size(); ++i) {
        const Sides& sides = stage.sides;
        const std::uint32_t photon = first + i;
        stage.compare(i, emissionAnswer(sides, sides.toTwin(paths[i]), sides.toTwin(rays[i])), [&](Nudge nudge) {
            const reference::Emission emission = reference::emitPhoton(sides.world(), photon, pass, nudge.shift());
            return emissionAnswer(sides,
                                  {.power = emission.power,
                                   .photon = photon,
                                   .light = emission.light,
                                   .media = sides.world().lights[emission.light].media},
                                  emission.ray);
        });
    }
}

reference::PhotonPass passOf(const shared::EmitPhotonsArguments& args) {
    return {.sequence = args.sequence, .count = args.ofPass};
}
reference::PhotonPass passOf(const shared::EmitCausticPhotonsArguments& args) {
    return {.sequence = args.sequence, .count = args.ofPass, .aimed = true};
}

template <class Arguments>
void compareEmitted(const Stage& stage) {
    const auto args = stage.seen.arguments<Arguments>();
    compareEmission(stage, stage.seen.after<shared::Ray>(args.rays, args.count),
                    stage.seen.after<shared::PhotonPath>(args.paths, args.count), args.first, passOf(args));
}

template <class Arguments>
void notePass(PathRecorder& recorder, const Observed& dispatch) {
    recorder.beginPhotonPass(passOf(dispatch.arguments<Arguments>()));
}

} // namespace

const Check kEmitPhotons{.kernel = "emit_photons",
                         .compare = compareEmitted<shared::EmitPhotonsArguments>,
                         .fields = {kEmission.all()},
                         .paths = {.ofPhotons = true, .begins = true, .take = notePass<shared::EmitPhotonsArguments>}};

const Check kEmitCausticPhotons{
    .kernel = "emit_caustic_photons",
    .compare = compareEmitted<shared::EmitCausticPhotonsArguments>,
    .fields = {kEmission.all()},
    .paths = {.ofPhotons = true, .begins = true, .take = notePass<shared::EmitCausticPhotonsArguments>}};

} // namespace hyalite::parity
