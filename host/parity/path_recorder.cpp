#include "parity/path_recorder.h"

#include "shaders/shared/kernel_arguments.h"

#include <algorithm>

namespace hyalite::parity {

namespace {

using glm::dvec3;

constexpr std::size_t kWhole = SIZE_MAX / 1024; // of arrays by pixel: as many as there are

// The part of a vertex that follows from its ray and hit.
DeviceVertex vertexAt(const Sides& sides, const shared::Ray& ray, const shared::Hit& hit,
                      std::optional<reference::Surface>& surface) {
    DeviceVertex vertex;
    vertex.ray = ray;
    vertex.hit = hit;
    vertex.from = dvec3(ray.origin);
    vertex.direction = dvec3(ray.direction);
    const auto met = sides.toTwin(hit);
    surface.reset();
    if (met) {
        surface = reference::evaluateSurface(sides.world(), sides.toTwin(ray), *met);
        vertex.position = surface->position;
        vertex.normal = surface->normal;
        vertex.front = surface->front;
        vertex.object = met->object;
        vertex.primitive = met->primitive;
        vertex.material = sides.numberOf(surface->material);
    }
    return vertex;
}

std::uint32_t wayOn(const std::optional<reference::Surface>& surface, const shared::Ray& next) {
    const bool through = surface && glm::dot(dvec3(next.direction), surface->geometricNormal) < 0;
    return through ? kTransmitted : kReflected;
}

} // namespace

std::string describeChoice(const Vertex& vertex) {
    if (vertex.object == shared::kNone) {
        return "leaves the scene";
    }
    std::string text;
    const auto add = [&](std::uint32_t bit, const char* word) {
        if ((vertex.choice & bit) != 0) {
            text += (text.empty() ? "" : ", ") + std::string(word);
        }
    };
    add(kDiffuse, (vertex.choice & kBounced) == 0 ? "ends on a diffuse surface" : "on a diffuse surface");
    add(kBounced, "goes on by the cosine");
    add(kStored, "stored");
    add(kReflected, "reflected");
    add(kTransmitted, "transmitted");
    return text.empty() ? "ends" : text;
}

void PathRecorder::see(const Observed& dispatch) {
    const std::string& kernel = dispatch.kernel();
    if (kernel == "trace_whitted") {
        if (dispatch.arguments<shared::TraceWhittedArguments>().fromCamera != 0) {
            fromCamera_ = ++cameraPasses_ <= kRecordedPasses;
        }
        if (fromCamera_) {
            seeTree(dispatch);
        }
    } else if (kernel == "generate_camera_rays") {
        fromCamera_ = ++cameraPasses_ <= kRecordedPasses;
    } else if (kernel == "start_gather_rays") {
        fromCamera_ = false;
    } else if (kernel == "shade_surface" && fromCamera_) {
        seeShading(dispatch);
    } else if (kernel == "bounce_paths" && fromCamera_) {
        seeBounces(dispatch);
    } else if ((kernel == "emit_photons" || kernel == "emit_caustic_photons") &&
               photonPasses_.size() < kRecordedPasses) {
        seeEmission(dispatch);
    } else if (kernel == "scatter_photon" && !onlyPixel_) {
        seeScattering(dispatch);
    }
}

void PathRecorder::seeShading(const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::ShadeSurfaceArguments>();
    const auto rays = dispatch.before<shared::Ray>(args.rays, args.count);
    const auto hits = dispatch.before<shared::Hit>(args.hits, args.count);
    const auto paths = dispatch.before<shared::CameraPath>(args.paths, args.count);
    const auto visible = dispatch.after<shared::VisiblePoint>(args.visiblePoints, kWhole);
    const auto nextRays = dispatch.after<shared::Ray>(args.nextRays, args.count);
    const auto alive = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        const std::uint32_t pixel = paths[i].pixel;
        const std::vector<DeviceVertex>& path = paths_[{false, args.pass, pixel}];
        const bool hasEnded = !path.empty() && (path.back().choice & (kDiffuse | kBounced)) == kDiffuse;
        if (!hasEnded) { // what follows a visible point is another integrator's matter
            addVertex({rays[i], hits[i], paths[i], visible[pixel], nextRays.subspan(i, alive[i])}, args.depth,
                      args.pass);
        }
    }
}

void PathRecorder::seeTree(const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::TraceWhittedArguments>();
    const auto rays = dispatch.after<shared::Ray>(args.keptRays, args.count);
    const auto hits = dispatch.after<shared::Hit>(args.hits, args.count);
    const auto paths = dispatch.after<shared::CameraPath>(args.keptPaths, args.count);
    const auto visible = dispatch.after<shared::VisiblePoint>(args.visiblePoints, args.count);
    const auto nextRays = dispatch.after<shared::Ray>(args.nextRays, 2 * std::size_t{args.count});
    const auto alive = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        addVertex({rays[i], hits[i], paths[i], visible[i], nextRays.subspan(2 * i, alive[i])}, args.depth, args.pass);
    }
}

void PathRecorder::addVertex(const Shaded& shaded, std::uint32_t depth, std::uint32_t pass) {
    if (leavesOut(shaded.path.pixel)) {
        return;
    }
    std::optional<reference::Surface> surface;
    DeviceVertex vertex = vertexAt(sides_, shaded.ray, shaded.hit, surface);
    vertex.seed = shaded.path.samplerSeed;
    vertex.depth = depth;
    vertex.medium = shaded.path.medium;
    vertex.weight = dvec3(shaded.path.beta);
    vertex.pdfW = double{shaded.path.pdfW};
    // A path that goes on from diffuse surfaces may have left a point at an earlier one
    vertex.choice = shaded.visible.depth == depth && shaded.visible.f != glm::vec3(0) ? kDiffuse : 0;
    for (const shared::Ray& next : shaded.next) {
        vertex.choice |= wayOn(surface, next);
    }
    paths_[{false, pass, shaded.path.pixel}].push_back(vertex);
}

void PathRecorder::seeBounces(const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::BouncePathsArguments>();
    const auto paths = dispatch.before<shared::CameraPath>(args.paths, args.count);
    const auto before = dispatch.before<shared::uint>(args.alive, args.count);
    const auto after = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        if (before[i] == 0 && after[i] != 0 && !leavesOut(paths[i].pixel)) {
            paths_[{false, args.pass, paths[i].pixel}].back().choice |= kBounced;
        }
    }
}

void PathRecorder::seeEmission(const Observed& dispatch) {
    if (dispatch.kernel() == "emit_caustic_photons") {
        const auto args = dispatch.arguments<shared::EmitCausticPhotonsArguments>();
        photonPasses_[args.sequence].pass = {.sequence = args.sequence, .count = args.ofPass, .aimed = true};
        return;
    }
    const auto args = dispatch.arguments<shared::EmitPhotonsArguments>();
    photonPasses_[args.sequence].pass = {.sequence = args.sequence, .count = args.ofPass};
}

void PathRecorder::seeScattering(const Observed& dispatch) {
    const auto args = dispatch.arguments<shared::ScatterPhotonArguments>();
    const auto pass = photonPasses_.find(args.sequence);
    if (pass == photonPasses_.end()) {
        return;
    }
    pass->second.pass.kinds = args.kinds;
    pass->second.maxDepth = args.maxDepth;
    const auto rays = dispatch.before<shared::Ray>(args.rays, args.count);
    const auto hits = dispatch.before<shared::Hit>(args.hits, args.count);
    const auto paths = dispatch.before<shared::PhotonPath>(args.paths, args.count);
    const auto photons = dispatch.after<shared::Photon>(args.photons, args.firstPhoton + std::size_t{args.count})
                             .subspan(args.firstPhoton);
    const auto nextRays = dispatch.after<shared::Ray>(args.nextRays, args.count);
    const auto alive = dispatch.after<shared::uint>(args.alive, args.count);
    for (std::size_t i = 0; i < args.count; ++i) {
        std::optional<reference::Surface> surface;
        DeviceVertex vertex = vertexAt(sides_, rays[i], hits[i], surface);
        vertex.depth = args.depth;
        vertex.medium = paths[i].medium;
        vertex.weight = dvec3(paths[i].power);
        vertex.photonKind = paths[i].kind;
        vertex.light = paths[i].light;
        vertex.choice = photons[i].surface != shared::kNone ? kStored : 0;
        vertex.choice |= alive[i] != 0 ? wayOn(surface, nextRays[i]) : 0;
        paths_[{true, args.sequence, paths[i].photon}].push_back(vertex);
    }
}

} // namespace hyalite::parity
