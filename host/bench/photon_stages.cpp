#include "bench/photon_stages.h"

#include "bench/timing.h"
#include "geometry/search_radius.h"
#include "render/photons/photon_grid.h"
#include "render/photons/photon_paths.h"
#include "render/photons/photon_query.h"
#include "render/photons/photon_slots.h"
#include "render/photons/photon_tree.h"
#include "render/wavefront/camera_paths.h"
#include "scene/model/bounds.h"
#include "scene/model/render_seed.h"

#include <functional>

namespace hyalite::bench {

namespace {

constexpr std::uint32_t kKinds = 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic;
constexpr std::uint32_t kNearest = 50;     // the scene format's default
constexpr double kLargestEstimate = 0.125; // also the default, as a fraction of the scene's radius

class PhotonStages {
public:
    PhotonStages(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene,
                 const BenchOptions& options, SceneResult& result)
        : device_(device), scene_(scene), deviceScene_(deviceScene), options_(options), result_(result),
          paths_(device, scene, deviceScene, options.photons) {}

    void measure() {
        const double radius = pilotRadius();
        slots_ = trace(options_.photons);
        add("photons", "photons", options_.photons, [&] { slots_ = trace(options_.photons); });
        table_ = {device_.context, slots_, "measured photons"};
        device_.tables.set(TABLE_PHOTONS, table_.buffer(), gpu::TexelFormat::Float4);
        findVisiblePoints();
        measureGrid(static_cast<float>(radius));
        measureTree();
    }

private:
    // Measures `body`, which must finish all its commands.
    void add(const std::string& stage, const std::string& unit, std::uint64_t count,
             const std::function<void()>& body) {
        if (options_.wants(stage)) {
            result_.stages.push_back({stage, unit, count, timesOf(options_.runs, body), {}});
        }
    }

    [[nodiscard]] std::uint32_t trace(std::uint32_t count) {
        const std::uint32_t sequence = shared::photonSequence(renderSeed(scene_.render), shared::kGlobalPhotons, 0);
        const std::uint32_t slots = paths_.trace({.sequence = sequence, .count = count, .kinds = kKinds});
        device_.commands.finish();
        return slots;
    }

    [[nodiscard]] double pilotRadius() {
        const std::uint32_t count = std::min(options_.photons, kPilotPhotons);
        const std::uint32_t slots = trace(count);
        std::vector<glm::dvec3> positions;
        for (const shared::Photon& photon : render::storedPhotons(paths_.photons(), slots)) {
            positions.emplace_back(photon.position);
        }
        return searchRadiusFor(kPhotonsPerSearch, positions, count, options_.photons,
                               {.sceneRadius = sceneRadius(scene_)});
    }

    void findVisiblePoints() {
        const std::uint32_t pixels = scene_.camera.resolution.x * scene_.camera.resolution.y;
        render::CameraPaths camera(device_, scene_, deviceScene_, pixels);
        points_ = {device_.context, pixels, "visible points"};
        gathered_ = {device_.context, pixels, "gathered light"};
        radii_ = {device_.context, pixels, "radii"};
        camera.generate(0);
        camera.follow(0, points_, gathered_, nullptr);
        device_.commands.finish();
    }

    void measureGrid(float radius) {
        render::PhotonGrid grid(device_);
        const auto build = [&] {
            grid.build(device_, paths_.photons(), slots_, radius, table_, 0);
            device_.commands.finish();
        };
        build();
        add("grid", "photons", grid.photonCount(), build);
        const gpu::Kernel gather = device_.kernel("gather_radiance", deviceScene_.specialization);
        const auto count = static_cast<std::uint32_t>(points_.count());
        add("gather", "points", count, [&] {
            device_.commands.run(gather,
                                 shared::GatherRadianceArguments{points_, deviceScene_.materials, grid.cellStarts(),
                                                                 gathered_, grid.record(), radius, count,
                                                                 scene_.render.maxDepth, deviceScene_.widthOf(count),
                                                                 static_cast<float>(surfaceError(scene_))},
                                 count);
            device_.commands.finish();
        });
    }

    void measureTree() {
        render::PhotonTree tree(device_);
        const auto build = [&] {
            tree.build(device_, paths_.photons(), slots_, table_, 0);
            device_.commands.finish();
        };
        build();
        add("tree", "photons", tree.photonCount(), build);
        render::RadianceEstimate estimate(device_, deviceScene_, PhotonStructure::Tree, kNearest);
        const render::PhotonSearch search{.nearest = kNearest,
                                          .radius = static_cast<float>(kLargestEstimate * sceneRadius(scene_)),
                                          .kinds = kKinds,
                                          .maxDepth = scene_.render.maxDepth,
                                          .surfaceError = static_cast<float>(surfaceError(scene_))};
        const auto count = static_cast<std::uint32_t>(points_.count());
        add("estimate", "points", count, [&] {
            estimate.run(device_, tree.map(), points_, count, search, {}, gathered_, radii_);
            device_.commands.finish();
        });
    }

    render::Device& device_;
    const Scene& scene_;
    const render::DeviceScene& deviceScene_;
    const BenchOptions& options_;
    SceneResult& result_;
    render::PhotonPaths paths_;
    std::uint32_t slots_ = 0;
    gpu::Array<shared::Photon> table_; // TABLE_PHOTONS
    gpu::Array<shared::VisiblePoint> points_;
    gpu::Array<glm::vec3> gathered_;
    gpu::Array<float> radii_;
};

} // namespace

void measurePhotonStages(render::Device& device, const Scene& scene, const render::DeviceScene& deviceScene,
                         const BenchOptions& options, SceneResult& result) {
    bool wanted = false;
    for (const char* stage : {"photons", "grid", "gather", "tree", "estimate"}) {
        wanted = wanted || options.wants(stage);
    }
    if (wanted) {
        PhotonStages(device, scene, deviceScene, options, result).measure();
    }
}

} // namespace hyalite::bench
