// What photons nearby tell of a place: radiance, irradiance, visibility.
#include "parity/twins.h"

#include "reference/photons/photon_map.h"
#include "reference/photons/radiance_estimate.h"
#include "reference/photons/shadow_photons.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

// The photons of the table, as the reference keeps them.
reference::PhotonMap mapOf(const Stage& stage, std::size_t first, std::size_t count) {
    std::vector<reference::Photon> photons;
    for (const shared::Photon& photon : stage.seen.table<shared::Photon>(TABLE_PHOTONS, first, count)) {
        photons.push_back(stage.sides.toTwin(photon));
    }
    return reference::PhotonMap(std::move(photons));
}

OffenderInputs inputsOf(const shared::VisiblePoint& x) {
    return {{"position", describe(dvec3(x.position))},
            {"normal", describe(dvec3(x.normal))},
            {"f", describe(dvec3(x.f))},
            {"depth", std::to_string(x.depth)},
            {"pixel", std::to_string(x.pixel)}};
}

reference::VisiblePoint nudged(const Stage& stage, const shared::VisiblePoint& point, Nudge& nudge) {
    reference::VisiblePoint x = stage.sides.toTwin(point);
    x.position = nudge.point(x.position, stage.sides.scale());
    x.normal = nudge.direction(x.normal);
    return x;
}

} // namespace

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
        device.vector("gathered", dvec3(gathered[i]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                Answer answer;
                const double radius = nudge.number(double{args.radius});
                answer.vector("gathered", point.depth == 0 ? dvec3(0)
                                                           : reference::gatherRadiance(map, nudged(stage, point, nudge),
                                                                                       radius, args.maxDepth));
                return answer;
            },
            [&] { return inputsOf(point); });
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
        device.vector("gathered", dvec3(gathered[i]));
        device.number("radius", double{radii[i]});
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
                                                            .maxChange = double{args.maxChange}});
                }
                Answer answer;
                answer.vector("gathered", estimate.radiance);
                answer.number("radius", estimate.radius);
                return answer;
            },
            [&] { return inputsOf(point); });
    }
}

void compareBeginIrradiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::BeginIrradianceArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto points = stage.seen.after<shared::VisiblePoint>(args.visiblePoints, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::Photon& photon = photons[i];
        const bool isMarked = photon.surface != shared::kNone && (photon.direction & shared::kMarkedPhoton) != 0;
        Answer device;
        Answer answer;
        device.exact("depth", points[i].depth);
        answer.exact("depth", isMarked ? 1 : 0);
        if (isMarked && points[i].depth != 0) {
            const dvec3 normal = glm::normalize(unpackDirection(photon.surface, shared::kNormalBits));
            device.vector("position", dvec3(points[i].position));
            answer.vector("position", dvec3(photon.position));
            device.vector("normal", dvec3(points[i].normal));
            answer.vector("normal", normal);
            device.vector("side", glm::normalize(unpackDirection(points[i].geometricNormal, 16)));
            answer.vector("side", normal);
            device.vector("f", dvec3(points[i].f));
            answer.vector("f", dvec3(1));
        }
        stage.compareExact(i, device, answer);
    }
}

void compareStoreIrradiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::StoreIrradianceArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto irradiance = stage.seen.before<glm::vec3>(args.irradiance, args.count);
    const auto records = stage.seen.after<shared::Photon>(args.records, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        shared::Photon expected = photons[i];
        expected.power = irradiance[i];
        if ((expected.direction & shared::kMarkedPhoton) == 0) {
            expected.surface = shared::kNone;
        }
        const bool isNone = expected.surface == shared::kNone; // of which nothing else counts
        Answer device;
        device.exact("surface", records[i].surface);
        device.exact("record", isNone || sameBits(records[i], expected) ? 1 : 0);
        Answer answer;
        answer.exact("surface", expected.surface);
        answer.exact("record", 1);
        stage.compareExact(i, device, answer);
    }
}

void compareLookUpIrradiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::LookUpIrradianceArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.gathered, args.count);
    const auto after = stage.seen.after<glm::vec3>(args.gathered, args.count);
    const reference::PhotonMap map = mapOf(stage, args.map.base, args.map.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        Answer device;
        device.vector("gathered", dvec3(after[i]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                dvec3 gathered(before[i]);
                if (point.depth != 0) {
                    const reference::VisiblePoint y = nudged(stage, point, nudge);
                    const auto isOnSide = [&](const reference::Photon& record) {
                        return glm::dot(record.normal, y.normal) > 0.5 && glm::dot(record.direction, y.normal) > 0;
                    };
                    const auto nearest = map.nearest(y.position, 1, nudge.number(double{args.radius}), isOnSide);
                    if (!nearest.empty()) { // a coat lets in 20/21 of light that comes evenly from everywhere
                        gathered += y.f * map.photons()[nearest.front().index].power *
                                    (double{args.scale} * (y.coated ? 20.0 / 21 : 1));
                    }
                }
                Answer answer;
                answer.vector("gathered", gathered);
                return answer;
            },
            [&] { return inputsOf(point); });
    }
}

void compareClassifyVisibility(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::ClassifyVisibilityArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto lit = stage.seen.after<shared::uint>(args.lit, args.count);
    const auto shadowed = stage.seen.after<shared::uint>(args.shadowed, args.count);
    const reference::PhotonMap map = mapOf(stage, args.map.base, args.map.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        Answer device;
        device.exact("lit", lit[i]);
        device.exact("shadowed", shadowed[i]);
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                reference::Visibility visibility;
                if (point.depth != 0) {
                    const double radius = nudge.number(double{args.radius});
                    visibility = reference::classifyVisibility(map, nudged(stage, point, nudge), args.lightCount,
                                                               args.agreeing, radius);
                }
                Answer answer;
                answer.exact("lit", visibility.lit);
                answer.exact("shadowed", visibility.shadowed);
                return answer;
            },
            [&] { return inputsOf(point); });
    }
}

void compareSkipShadowRays(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::SkipShadowRaysArguments>();
    const auto lit = stage.seen.before<shared::uint>(args.lit, args.count);
    const auto shadowed = stage.seen.before<shared::uint>(args.shadowed, args.count);
    const auto raysBefore = stage.seen.before<shared::Ray>(args.shadowRays, args.count);
    const auto rays = stage.seen.after<shared::Ray>(args.shadowRays, args.count);
    const auto contributions = stage.seen.before<glm::vec3>(args.contributions, args.count);
    const auto directBefore = stage.seen.before<glm::vec3>(args.direct, args.count);
    const auto direct = stage.seen.after<glm::vec3>(args.direct, args.count);
    std::array<std::uint32_t, 2> counted{}; // rays spared, rays left
    for (std::size_t i = 0; i < args.count; ++i) {
        const bool isRay = raysBefore[i].tMax > 0;
        const bool isLit = (lit[i] >> args.light & 1U) != 0;
        const bool isKnown = isLit || (shadowed[i] >> args.light & 1U) != 0;
        counted.at(isKnown ? 0 : 1) += isRay ? 1 : 0;
        Answer device;
        device.exact("traced", rays[i].tMax > 0 ? 1 : 0);
        device.vector("direct", dvec3(direct[i]));
        Answer answer;
        answer.exact("traced", isRay && !isKnown ? 1 : 0);
        answer.vector("direct", dvec3(directBefore[i]) + (isRay && isLit ? dvec3(contributions[i]) : dvec3(0)));
        stage.compareExact(i, device, answer);
    }
    const auto countsBefore = stage.seen.before<shared::uint>(args.counts, 2);
    const auto counts = stage.seen.after<shared::uint>(args.counts, 2);
    for (std::size_t i = 0; i < 2; ++i) {
        Answer device;
        device.exact("count", counts[i] - countsBefore[i]);
        Answer answer;
        answer.exact("count", counted.at(i));
        stage.compareExact(i, device, answer);
    }
}

} // namespace hyalite::parity
