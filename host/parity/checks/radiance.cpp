// Radiance estimates from nearby photons.
#include "parity/checks/checks.h"

#include "parity/checks/photon_map_of.h"
#include "reference/photons/radiance_estimate.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct GatherFields : FieldSet<1> {
    const Field& gathered = vector("gathered", kSum, Scale::Value, kRim);
};
constexpr GatherFields kGather;

struct EstimateFields : FieldSet<2> {
    const Field& gathered = vector("gathered", kSum, Scale::Value, kRim);
    const Field& radius = number("radius", kDisc, Scale::Value, kRim);
};
constexpr EstimateFields kEstimate;

void compareGatherRadiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::GatherRadianceArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto gathered = stage.seen.after<glm::vec3>(args.gathered, args.count);
    const std::size_t buckets = std::size_t{args.grid.bucketMask} + 1;
    const std::size_t photons = stage.seen.before<shared::uint>(args.cellStarts, buckets + 1)[buckets];
    const reference::PhotonMap map = mapOf(stage, 0, photons);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        Answer device;
        device.vector(kGather.gathered, dvec3(gathered[i]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                Answer answer;
                const double radius = nudge.number(double{args.radius});
                answer.vector(kGather.gathered,
                              point.depth == 0 ? dvec3(0)
                                               : reference::gatherRadiance(map, nudged(stage, point, nudge), radius,
                                                                           args.maxDepth, double{args.surfaceError}));
                return answer;
            },
            [&] { return visibleInputs(point); });
    }
}

void compareEstimateRadiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::EstimateRadianceArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto gathered = stage.seen.after<glm::vec3>(args.gathered, args.count);
    const auto radii = stage.seen.after<float>(args.radii, args.count);
    const reference::PhotonMap map = mapOf(stage, args.map.base, args.map.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        Answer device;
        device.vector(kEstimate.gathered, dvec3(gathered[i]));
        device.number(kEstimate.radius, double{radii[i]});
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                const double radius = nudge.number(double{args.radius});
                reference::RadianceEstimate estimate;
                if (point.depth != 0) {
                    estimate = reference::estimateRadiance(map, nudged(stage, point, nudge),
                                                           {.nearest = args.nearest,
                                                            .radius = radius,
                                                            .kinds = args.kinds,
                                                            .maxDepth = args.maxDepth,
                                                            .filter = static_cast<PhotonFilter>(args.filterKind),
                                                            .coneConstant = double{args.filterConstant},
                                                            .maxChange = double{args.maxChange},
                                                            .surfaceError = double{args.surfaceError},
                                                            .eye = dvec3(args.eye),
                                                            .footprint = double{args.footprint}});
                }
                Answer answer;
                answer.vector(kEstimate.gathered, estimate.radiance);
                answer.number(kEstimate.radius, estimate.radius);
                return answer;
            },
            [&] { return visibleInputs(point); });
    }
}

} // namespace

const Check kGatherRadiance{
    .kernel = "gather_radiance", .compare = compareGatherRadiance, .fields = {kGather.all()}, .runs = kRunsTextures};
const Check kEstimateRadiance{.kernel = "estimate_radiance",
                              .compare = compareEstimateRadiance,
                              .fields = {kEstimate.all()},
                              .runs = kRunsTextures | kRunsFilter};

} // namespace hyalite::parity
