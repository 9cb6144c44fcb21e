#include "parity/sides.h"

#include "base/error.h"
#include "reference/lights/receiver.h"
#include "reference/media/medium.h"
#include "reference/textures/texture.h"
#include "render/upload/media_word.h"

#include "shaders/shared/limits.h"
#include "shaders/shared/scene_records.h"

namespace hyalite::parity {

namespace {

using glm::dvec3;

// Largest distance between the start of a ray and the surface that it leaves [scale of the scene]: the error bound of
// positions on curved shapes, 2^-20, with a margin for the error of the intersection.
constexpr double kOnSurface = 0x1p-18;

double scaleOf(const Scene& scene, const reference::World& world) {
    double scale = largestComponent(scene.camera.position);
    for (const auto object : world.bounded) {
        const Bounds bounds = worldBounds(scene, scene.objects[object]);
        scale = std::max({scale, largestComponent(bounds.low), largestComponent(bounds.high)});
    }
    return scale;
}

// The device may have learned them from paths that rounding made different.
void takeProbabilities(const render::DeviceScene& deviceScene, reference::World& world) {
    const std::vector<shared::LightRecord> lights = deviceScene.lights.read();
    for (std::size_t i = 0; i < lights.size() && i < world.lights.size(); ++i) {
        world.lights[i].pmf = double{lights[i].pmf};
        world.lights[i].cdf = double{lights[i].cdf};
    }
    const std::vector<shared::LightNode> nodes = deviceScene.lightNodes.read();
    for (std::size_t i = 0; i < nodes.size() && i < world.lightTree.nodes.size(); ++i) {
        world.lightTree.nodes[i].extent.intensity = double{nodes[i].intensity};
    }
}

} // namespace

dvec3 unpackDirection(std::uint32_t packed, std::uint32_t bits) {
    const std::uint32_t mask = (1U << bits) - 1U;
    const auto coordinate = [&](std::uint32_t v) { return double(v & mask) / mask * 2 - 1; };
    dvec3 v(coordinate(packed), coordinate(packed >> bits), 0);
    v.z = 1 - std::abs(v.x) - std::abs(v.y);
    if (v.z < 0) {
        const dvec3 folded = v;
        v.x = (1 - std::abs(folded.y)) * (folded.x < 0 ? -1 : 1);
        v.y = (1 - std::abs(folded.x)) * (folded.y < 0 ? -1 : 1);
    }
    return v;
}

Sides::Sides(const Scene& scene, const render::DeviceScene& deviceScene)
    : scene_(scene), objectOf_(deviceScene.objectOf), leafOf_(deviceScene.leafOf), triangleOf_(deviceScene.triangleOf),
      world_(reference::prepareWorld(scene)), scale_(scaleOf(scene, world_)),
      hasRoughLobes_(deviceScene.hasRoughLobes) {
    takeProbabilities(deviceScene, world_);
}

reference::Ray Sides::toTwin(const shared::Ray& ray) const {
    return {.origin = ray.origin, .direction = glm::normalize(dvec3(ray.direction)), .tMax = double{ray.tMax}};
}

std::optional<reference::Hit> Sides::toTwin(const shared::Hit& hit) const {
    if (hit.object >= objectOf_.size()) {
        return std::nullopt;
    }
    reference::Hit twin{.t = hit.t, .object = objectOf_[hit.object], .u = hit.uv.x, .v = hit.uv.y};
    const Object* object = &scene_.objects[twin.object];
    if (leafOf_[hit.object] != shared::kNone) {
        twin.leaf = leafOf_[hit.object];
        object = &scene_.csgLeaves[twin.leaf];
    }
    const std::uint32_t primitive = hit.primitive & ~shared::kHitEnters;
    const bool isMesh = std::holds_alternative<MeshInstance>(object->shape);
    twin.primitive = isMesh ? (primitive < triangleOf_.size() ? triangleOf_[primitive] : shared::kNone) : primitive;
    return twin;
}

reference::CameraPath Sides::toTwin(const shared::CameraPath& path) const {
    return {.beta = dvec3(path.beta),
            .samplerSeed = path.samplerSeed,
            .media = media(path.media),
            .pdfW = double{path.pdfW}};
}

reference::PhotonPath Sides::toTwin(const shared::PhotonPath& path) const {
    return {.power = dvec3(path.power),
            .photon = path.photon,
            .light = path.light,
            .kind = static_cast<reference::PhotonKind>(path.kind),
            .media = media(path.media)};
}

MaterialModel Sides::materialAt(std::uint32_t number, const dvec3& position, const glm::dvec2& uv, Nudge nudge) const {
    reference::Surface surface{};
    surface.material = material(number);
    surface.position = nudge.point(position, scale_);
    surface.uv = {nudge.number(uv.x), nudge.number(uv.y)};
    return reference::texturedModel(world_, surface);
}

reference::VisiblePoint Sides::toTwin(const shared::VisiblePoint& x, Nudge nudge) const {
    const std::uint32_t left = (x.from & ~shared::kRayInside) - 1U; // wraps around if it is on no object
    const bool isObject = left < objectOf_.size() && leafOf_[left] == shared::kNone;
    return {.position = dvec3(x.position),
            .shadowOrigin = dvec3(x.position),
            .normal = dvec3(x.normal),
            .geometricNormal = glm::normalize(unpackDirection(x.geometricNormal, 16)),
            .wo = glm::normalize(dvec3(x.wo)),
            .beta = dvec3(x.beta) / double{x.probability},
            .material = x.material == shared::kNone
                            ? std::nullopt
                            : std::optional(materialAt(x.material, dvec3(x.onSurface), glm::dvec2(x.uv), nudge)),
            .depth = x.depth,
            .samplerSeed = x.samplerSeed,
            .quad = isObject ? std::get_if<Quad>(&world_.objects[objectOf_[left]].shape) : nullptr,
            .media = media(x.media),
            .disk = isObject ? std::get_if<Disk>(&world_.objects[objectOf_[left]].shape) : nullptr};
}

bool Sides::reflects(const shared::VisiblePoint& x) const {
    return glm::vec3(reference::receiverAt(toTwin(x)).f) != glm::vec3(0);
}

reference::RoughPoint Sides::toTwin(const shared::RoughPoint& x, Nudge nudge) const {
    reference::RoughPoint twin;
    twin.surface.position = dvec3(x.position);
    twin.surface.geometricNormal = glm::normalize(dvec3(x.geometricNormal));
    twin.surface.normal = glm::normalize(dvec3(x.normal));
    twin.surface.offset = double{x.error};
    twin.media = media(x.media);
    twin.beyond = media(x.beyond);
    const bool front = (x.from & shared::kRayInside) == 0;
    const MaterialModel model = reference::relativeTo(
        world_.materials, world_.indicesFromMedia, materialAt(x.material, dvec3(x.position), glm::dvec2(x.uv), nudge),
        {.before = twin.media, .beyond = twin.beyond, .front = front});
    twin.lobe = x.isCoat != 0 ? reference::coatOf(model).value() : reference::lobeOf(model, front).value();
    twin.wo = glm::normalize(dvec3(x.wo));
    twin.beta = dvec3(x.beta);
    twin.depth = x.depth;
    twin.samplerSeed = x.samplerSeed;
    return twin;
}

reference::Photon Sides::toTwin(const shared::Photon& photon) const {
    const std::uint32_t kind = photon.surface >> shared::kKindShift & 3U;
    const bool hasLight = kind == shared::kPhotonDirect || kind == shared::kPhotonShadow;
    const std::uint32_t length = photon.surface >> shared::kLengthShift;
    return {.position = dvec3(photon.position),
            .direction = glm::normalize(unpackDirection(photon.direction, shared::kDirectionBits)),
            .normal = glm::normalize(unpackDirection(photon.surface, shared::kNormalBits)),
            .power = dvec3(photon.power),
            .photon = 0,
            .depth = hasLight ? 1 : length,
            .light = hasLight ? length : 0,
            .kind = static_cast<reference::PhotonKind>(kind),
            .discRadius = double{std::bit_cast<float>(photon.direction << 2U)}};
}

const Material* Sides::material(std::uint32_t number) const {
    return number < world_.materials.size() ? &world_.materials[number] : nullptr;
}

std::uint32_t Sides::numberOf(const reference::Media& media) const {
    return render::mediaWord(scene_, media);
}

reference::Media Sides::media(std::uint32_t word) const {
    return render::mediaOfWord(scene_, word);
}

std::uint32_t Sides::mediumOf(std::uint32_t word) const {
    const Material* material = reference::mediumOf(world_.materials, media(word)).material;
    return material == nullptr ? shared::kNone : static_cast<std::uint32_t>(material - world_.materials.data());
}

std::optional<reference::Hit> Sides::refined(const reference::Ray& ray, std::uint32_t from,
                                             const shared::Hit& hit) const {
    const std::optional<reference::Hit> given = toTwin(hit);
    if (!given) {
        return given;
    }
    const std::optional<reference::Hit> exact = trace(ray, from);
    const bool isSame = exact && exact->object == given->object && exact->leaf == given->leaf &&
                        exact->primitive == given->primitive &&
                        std::abs(exact->t - given->t) < kOnSurface * std::max(scale_, given->t);
    reference::Hit refined = *given;
    refined.t = isSame ? exact->t : given->t;
    return refined;
}

std::optional<reference::Hit> Sides::trace(const reference::Ray& ray, std::uint32_t from) const {
    std::optional<reference::Hit> hit = reference::traceClosest(world_, ray);
    const std::uint32_t left = (from & ~(shared::kRayInside | shared::kRayPasses)) - 1U; // kNone if it leaves no object
    if (!hit || left >= objectOf_.size() || hit->object != objectOf_[left]) {
        return hit;
    }
    // Rays that leave a mesh start beyond the error of its triangles: every hit is real
    if (std::holds_alternative<MeshInstance>(scene_.objects[hit->object].shape)) {
        return hit;
    }
    const double reach = kOnSurface * std::max(scale_, largestComponent(ray.origin));
    const reference::Surface surface = reference::evaluateSurface(world_, ray, *hit);
    if (hit->t * std::abs(glm::dot(ray.direction, surface.geometricNormal)) > reach || hit->t > 1024 * reach) {
        return hit;
    }
    // The ray hit the surface that it leaves: continue just behind it
    reference::Ray onward = ray;
    const double passed = hit->t + reach / 1024;
    onward.origin += passed * ray.direction;
    onward.tMax -= passed;
    hit = reference::traceClosest(world_, onward);
    if (hit) {
        hit->t += passed;
    }
    return hit;
}

bool Sides::touch(const std::optional<reference::Hit>& device, const std::optional<reference::Hit>& twin) const {
    return device && twin && !world_.neighbors.empty() &&
           std::ranges::count(world_.neighbors[device->object], twin->object, &reference::Neighbor::object) > 0;
}

bool Sides::areInOnePlace(const reference::Ray& ray, const std::optional<reference::Hit>& device,
                          const std::optional<reference::Hit>& twin) const {
    if (!device || !twin) {
        return false;
    }
    const double reach = kNudge * 0x1p-24 * std::max(scale_, twin->t);
    const dvec3 place = reference::evaluateSurface(world_, ray, *device).position;
    return std::abs(device->t - twin->t) <= reach &&
           glm::length(place - (ray.origin + device->t * ray.direction)) <= reach;
}

} // namespace hyalite::parity
