#include "render/wavefront/learn_lights.h"

#include "geometry/light_use.h"
#include "kinds/lights/light_table.h"
#include "render/wavefront/camera_paths.h"
#include "scene/model/integrators.h"

#include "shaders/shared/try_lights_arguments.h"

namespace hyalite::render {

namespace {

// As the integrator has it: the same kernels serve both.
AtDiffuse atDiffuse(const Scene& scene) {
    return scene.render.integrator == "path" ? AtDiffuse::Bounces : AtDiffuse::Ends;
}

// Follows the paths of a small picture, bouncing at diffuse surfaces; tries all lights wherever they do.
class Trials {
public:
    // `side`: pixels along each side of the picture.
    Trials(Device& device, const Scene& scene, const DeviceScene& deviceScene, std::uint32_t side)
        : device_(device), deviceScene_(deviceScene), maxDepth_(scene.render.maxDepth), side_(side),
          places_(side * side), cameraPaths_(device, scene, deviceScene, places_, {}, atDiffuse(scene)),
          bouncePaths_(device.kernel("bounce_paths", deviceScene.specialization)),
          tryLights_(device.kernel("try_lights", deviceScene.specialization)),
          visiblePoints_(device.context, places_, "places where lights are tried"),
          emitted_(device.context, places_, "emission at places where lights are tried"),
          brought_(device.context, std::size_t{places_} * deviceScene.lightCount, "light brought"),
          tries_(device.context, brought_.count(), "tries of lights") {
        device.commands.clear(visiblePoints_.buffer());
        device.commands.clear(brought_.buffer());
        device.commands.clear(tries_.buffer());
    }

    [[nodiscard]] std::vector<LightUse> run() {
        shared::CameraRecord camera = deviceScene_.camera;
        camera.width = side_;
        camera.height = side_;
        cameraPaths_.generate(kLearningPass, camera);
        cameraPaths_.follow(kLearningPass, visiblePoints_, emitted_, nullptr, [&](std::uint32_t depth) {
            if (depth <= kLearningDepth && depth + 1 <= maxDepth_) {
                tryLights(depth);
            }
            if (depth < kLearningDepth) {
                bounce(depth);
            }
        });
        device_.commands.finish();
        return uses();
    }

private:
    void tryLights(std::uint32_t depth) {
        const auto count = static_cast<std::uint32_t>(brought_.count());
        device_.commands.run(tryLights_,
                             shared::TryLightsArguments{.visiblePoints = visiblePoints_,
                                                        .materials = deviceScene_.materials,
                                                        .lights = deviceScene_.lights,
                                                        .brought = brought_,
                                                        .tries = tries_,
                                                        .count = count,
                                                        .places = places_,
                                                        .depth = depth,
                                                        .pass = kLearningPass,
                                                        .rootNode = deviceScene_.rootNode},
                             count);
    }

    void bounce(std::uint32_t depth) {
        const CameraQueue& queue = cameraPaths_.queue();
        const gpu::ThreadCount threads = queue.threads();
        device_.commands.run(bouncePaths_,
                             shared::BouncePathsArguments{.paths = queue.paths,
                                                          .visiblePoints = visiblePoints_,
                                                          .materials = deviceScene_.materials,
                                                          .nextRays = queue.nextRays,
                                                          .nextPaths = queue.nextPaths,
                                                          .alive = queue.alive,
                                                          .count = threads.most(),
                                                          .depth = depth,
                                                          .maxDepth = maxDepth_,
                                                          .pass = kLearningPass,
                                                          .live = threads.live()},
                             threads);
    }

    [[nodiscard]] std::vector<LightUse> uses() const {
        const std::vector<float> brought = brought_.read();
        const std::vector<glm::uvec2> tries = tries_.read();
        std::vector<LightUse> uses(deviceScene_.lightCount);
        for (std::size_t i = 0; i < brought.size(); ++i) {
            LightUse& use = uses[i / places_];
            use.brought += double{brought[i]};
            use.tried += tries[i].x;
            use.seen += tries[i].y;
        }
        return uses;
    }

    Device& device_;
    const DeviceScene& deviceScene_;
    std::uint32_t maxDepth_;
    std::uint32_t side_;
    std::uint32_t places_;
    CameraPaths cameraPaths_;
    gpu::Kernel bouncePaths_;
    gpu::Kernel tryLights_;
    gpu::Array<shared::VisiblePoint> visiblePoints_;
    gpu::Array<glm::vec3> emitted_;
    gpu::Array<float> brought_; // light after light, place after place; so are the tries
    gpu::Array<glm::uvec2> tries_;
};

void apply(const std::vector<LightUse>& uses, const Scene& scene, DeviceScene& deviceScene) {
    LightTree tree = buildLightTree(lightExtents(scene));
    scaleIntensities(tree, uses);
    deviceScene.lightNodes.write(kinds::nodeRecords(tree));
    std::vector<shared::LightRecord> lights = deviceScene.lights.read();
    kinds::placeInTree(lights, tree);
    const std::vector<double> shares = photonShares(scene);
    std::vector<double> weights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        weights.push_back(kinds::channelMean(lights[i].power) * shares.at(i));
    }
    const std::vector<double> pmf = learnedPmf(kinds::photonPmf(weights, shares), shares, uses);
    double sum = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        sum += pmf[i];
        lights[i].pmf = static_cast<float>(pmf[i]);
        lights[i].cdf = static_cast<float>(sum);
    }
    lights.back().cdf = 1;
    deviceScene.lights.write(lights);
}

} // namespace

bool learnsLights(const Scene& scene, const DeviceScene& deviceScene) {
    return hyalite::learnsLights(deviceScene.lightCount) &&
           !integratorNamed(scene.render.integrator).cameraPaths.followsAllWays;
}

std::vector<LightUse> tryLights(Device& device, const Scene& scene, const DeviceScene& deviceScene) {
    return Trials(device, scene, deviceScene, learningSide(deviceScene.lightCount)).run();
}

void learnLights(Device& device, const Scene& scene, DeviceScene& deviceScene) {
    if (learnsLights(scene, deviceScene)) {
        apply(tryLights(device, scene, deviceScene), scene, deviceScene);
    }
}

} // namespace hyalite::render
