// Irradiance at every fourth photon, and its lookup [Christensen99].
#include "parity/checks/checks.h"

#include "parity/checks/photon_map_of.h"
#include "reference/lights/receiver.h"

#include "shaders/shared/kernel_arguments.h"
#include "shaders/shared/limits.h"

#include <bit>

namespace hyalite::parity {

namespace {

using glm::dvec3;

struct PointFields : FieldSet<5> {
    const Field& depth = exact("depth");
    const Field& position = vector("position", kSame);
    const Field& normal = angle("normal");
    const Field& side = angle("side", kSide);
    const Field& material = exact("material");
};
constexpr PointFields kPoints;

struct RecordFields : FieldSet<2> {
    const Field& surface = exact("surface");
    const Field& record = exact("record");
};
constexpr RecordFields kRecords;

struct LookUpFields : FieldSet<2> {
    const Field& found = exact("found", kRim);
    const Field& gathered = vector("gathered", kSum, Scale::Value, "two records at equal distance");
};
constexpr LookUpFields kLookUp;

void compareBeginIrradiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::BeginIrradianceArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto points = stage.seen.after<shared::VisiblePoint>(args.visiblePoints, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::Photon& photon = photons[i];
        const bool isMarked = photon.surface != shared::kNone && (photon.direction & shared::kMarkedPhoton) != 0;
        Answer device;
        Answer answer;
        device.exact(kPoints.depth, points[i].depth);
        answer.exact(kPoints.depth, isMarked ? 1 : 0);
        if (isMarked && points[i].depth != 0) {
            const dvec3 normal = glm::normalize(unpackDirection(photon.surface, shared::kNormalBits));
            device.vector(kPoints.position, dvec3(points[i].position));
            answer.vector(kPoints.position, dvec3(photon.position));
            device.vector(kPoints.normal, dvec3(points[i].normal));
            answer.vector(kPoints.normal, normal);
            device.vector(kPoints.side, glm::normalize(unpackDirection(points[i].geometricNormal, 16)));
            answer.vector(kPoints.side, normal);
            device.exact(kPoints.material, points[i].material);
            answer.exact(kPoints.material, shared::kNone);
        }
        stage.compareExact(i, device, answer);
    }
}

void compareStoreIrradiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::StoreIrradianceArguments>();
    const auto photons = stage.seen.before<shared::Photon>(args.photons, args.count);
    const auto irradiance = stage.seen.before<glm::vec3>(args.irradiance, args.count);
    const auto radii = stage.seen.before<float>(args.radii, args.count);
    const auto records = stage.seen.after<shared::Photon>(args.records, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        shared::Photon expected = photons[i];
        expected.power = irradiance[i];
        if ((expected.direction & shared::kMarkedPhoton) == 0) {
            expected.surface = shared::kNone;
        }
        expected.direction = std::bit_cast<std::uint32_t>(radii[i]) >> 2U;
        const bool isNone = expected.surface == shared::kNone; // then no other field counts
        Answer device;
        device.exact(kRecords.surface, records[i].surface);
        device.exact(kRecords.record, isNone || sameBits(records[i], expected) ? 1 : 0);
        Answer answer;
        answer.exact(kRecords.surface, expected.surface);
        answer.exact(kRecords.record, 1);
        stage.compareExact(i, device, answer);
    }
}

void compareLookUpIrradiance(const Stage& stage) {
    const auto args = stage.seen.arguments<shared::LookUpIrradianceArguments>();
    const auto points = stage.seen.before<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto before = stage.seen.before<glm::vec3>(args.gathered, args.count);
    const auto after = stage.seen.after<glm::vec3>(args.gathered, args.count);
    const auto pointsAfter = stage.seen.after<shared::VisiblePoint>(args.visiblePoints, args.count);
    const reference::PhotonMap map = mapOf(stage, args.map.base, args.map.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const shared::VisiblePoint& point = points[i];
        Answer device;
        device.exact(kLookUp.found, pointsAfter[i].depth == 0 ? 1 : 0);
        device.vector(kLookUp.gathered, dvec3(after[i]));
        stage.compare(
            i, device,
            [&](Nudge nudge) {
                dvec3 gathered(before[i]);
                bool isDone = point.depth == 0;
                if (!isDone) {
                    const reference::VisiblePoint y = nudged(stage, point, nudge);
                    const auto E = reference::recordedIrradiance(map, y, nudge.number(double{args.radius}),
                                                                 double{args.surfaceError});
                    if (E) {
                        const reference::Receiver receiver = reference::receiverAt(y);
                        gathered += receiver.f * *E * (double{args.scale} * receiver.meanIncident());
                        isDone = true;
                    }
                }
                Answer answer;
                answer.exact(kLookUp.found, isDone ? 1 : 0);
                answer.vector(kLookUp.gathered, gathered);
                return answer;
            },
            [&] { return visibleInputs(point); });
    }
}

} // namespace

const Check kBeginIrradiance{
    .kernel = "begin_irradiance", .compare = compareBeginIrradiance, .fields = {kPoints.all()}};
const Check kStoreIrradiance{
    .kernel = "store_irradiance", .compare = compareStoreIrradiance, .fields = {kRecords.all()}};
const Check kLookUpIrradiance{.kernel = "look_up_irradiance",
                              .compare = compareLookUpIrradiance,
                              .fields = {kLookUp.all()},
                              .runs = kRunsTextures};

} // namespace hyalite::parity
