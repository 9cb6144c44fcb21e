// See learn_lights.h.
#include "reference/integrators/learn_lights.h"

#include "reference/integrators/path.h"
#include "reference/integrators/shading.h"

#include <algorithm>

namespace hyalite::reference {

namespace {

void tryFrom(const World& world, std::uint32_t pixel, std::vector<LightUse>& uses) {
    NextRay step{.ray = generateCameraRay(world, pixel, kLearningPass),
                 .path = beginCameraPath(world, pixel, kLearningPass)};
    for (std::uint32_t depth = 1; depth < world.render.maxDepth; ++depth) {
        const std::optional<Hit> hit = traceClosest(world, step.ray);
        if (!hit) {
            return;
        }
        const Shading shading = shadeSurface(world, step.ray, *hit, step.path, depth, kLearningPass);
        std::optional<NextRay> next = shading.next[0];
        if (shading.visible && depth <= kLearningDepth) {
            for (std::uint32_t light = 0; light < world.lights.size(); ++light) {
                tryLight(world, *shading.visible, light, uses[light]);
            }
            next =
                depth < kLearningDepth ? bouncePath(world, *shading.visible, step.path, kLearningPass) : std::nullopt;
        } else if (shading.visible) {
            return;
        }
        if (!next) {
            return;
        }
        step = *next;
    }
}

} // namespace

void tryLight(const World& world, const VisiblePoint& x, std::uint32_t light, LightUse& use) {
    const std::optional<LightSample> sample = sampleLight(world, x, kLearningPass, light);
    if (!sample || sample->contribution == glm::dvec3(0)) {
        return;
    }
    ++use.tried;
    if (traceShadow(world, sample->from, sample->to)) {
        ++use.seen;
        use.brought += (sample->contribution.x + sample->contribution.y + sample->contribution.z) / 3;
    }
}

std::vector<LightUse> tryLights(World world) {
    const std::uint32_t side = learningSide(world.lights.size());
    world.camera.width = side;
    world.camera.height = side;
    std::vector<LightUse> uses(world.lights.size());
    for (std::uint32_t pixel = 0; pixel < side * side; ++pixel) {
        tryFrom(world, pixel, uses);
    }
    return uses;
}

void learnLights(World& world, const std::vector<double>& shares) {
    if (!learnsLights(world.lights.size()) || world.cameraPaths.followsAllWays) {
        return;
    }
    const std::vector<LightUse> uses = tryLights(world);
    scaleIntensities(world.lightTree, uses);
    std::vector<double> pmf;
    for (const Light& light : world.lights) {
        pmf.push_back(light.pmf);
    }
    pmf = learnedPmf(pmf, shares, uses);
    double sum = 0;
    for (std::size_t i = 0; i < pmf.size(); ++i) {
        sum += pmf[i];
        world.lights[i].pmf = pmf[i];
        world.lights[i].cdf = sum;
    }
    world.lights.back().cdf = 1;
}

} // namespace hyalite::reference
