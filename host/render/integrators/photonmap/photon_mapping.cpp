#include "render/integrators/photonmap/photon_mapping.h"

#include "geometry/light_use.h"
#include "reference/integrators/photon_views.h"
#include "render/film/scene_identity.h"
#include "render/photons/photon_file.h"

#include <algorithm>

namespace hyalite::render {

namespace {

constexpr std::uint32_t kAllLight =
    1U << shared::kPhotonDirect | 1U << shared::kPhotonIndirect | 1U << shared::kPhotonCaustic;

// Colours of the drawn photons by kind: yellow, blue, red, magenta.
constexpr std::array<glm::vec3, 4> kPointColors{
    {{1.0F, 0.8F, 0.1F}, {0.1F, 0.3F, 1.0F}, {1.0F, 0.1F, 0.05F}, {0.5F, 0.0F, 0.5F}}};

std::vector<LayerKind> layersOf(const RenderSettings& render) {
    switch (render.photonMap.view) {
    case PhotonView::GlobalMap:
        return {{"emitted"}, {"global_map"}};
    case PhotonView::CausticMap:
        return {{"caustic_map"}};
    case PhotonView::Radius:
        return {{"radius"}};
    case PhotonView::Photons:
        return {{"emitted"}, {"direct"}, {"caustic"}, {"indirect"}, {"photons"}};
    case PhotonView::Picture:
        break;
    }
    return {{"emitted"}, {"direct"}, {"caustic"}, {"indirect"}};
}

} // namespace

IntegratorKind PhotonMapping::kind() {
    return {.name = "photonmap",
            .layers = layersOf,
            .make = makeIntegrator<PhotonMapping>,
            .reference = reference::renderPhotonMap,
            .referenceHasLayers = true,
            .keepsPhotons = true,
            .simplifyForPaths = [](RenderSettings& render) { render.photonMap.view = PhotonView::Picture; }};
}

PhotonMapping::PhotonMapping(const IntegratorInput& input)
    : device_(input.device), scene_(input.scene), deviceScene_(input.deviceScene), film_(input.film),
      files_(input.photonFiles), cameraPaths_(device_, scene_, deviceScene_, film_.pixelCount(), film_.sought()),
      lightSampler_(device_, deviceScene_, film_.pixelCount(), film_.sought()), maps_(device_, scene_, deviceScene_),
      startGatherRays_(device_.kernel("start_gather_rays", deviceScene_.specialization)),
      skipShadowRays_(device_.kernel("skip_shadow_rays")), addGatheredLight_(device_.kernel("add_gathered_light")),
      visiblePoints_(device_.context, film_.pixelCount(), "visible points"),
      gatherPoints_(device_.context, film_.pixelCount(), "ends of gathering rays"),
      emitted_(device_.context, film_.pixelCount(), "emitted light"),
      unused_(device_.context, film_.pixelCount(), "emission seen by gathering rays"),
      direct_(device_.context, film_.pixelCount(), "direct light"),
      caustic_(device_.context, film_.pixelCount(), "caustics"),
      indirect_(device_.context, film_.pixelCount(), "indirect light"),
      found_(device_.context, film_.pixelCount(), "light found by gathering rays"),
      radii_(device_.context, film_.pixelCount(), "radii of estimates"),
      lit_(device_.context, film_.pixelCount(), "lights seen"),
      shadowed_(device_.context, film_.pixelCount(), "lights hidden"),
      raysSaved_(device_.context, "count of shadow rays saved") {}

void PhotonMapping::renderPass(std::uint32_t pass) {
    // Each pixel's first diffuse surface, through mirrors and glass, and the emission on the way; at rough metal and
    // glass also the direct light
    device_.commands.clear(direct_.buffer());
    cameraPaths_.generate(pass);
    cameraPaths_.follow(pass, visiblePoints_, emitted_, &direct_);
    switch (scene_.render.photonMap.view) {
    case PhotonView::GlobalMap:
        maps_.estimateGlobal(visiblePoints_, kAllLight, indirect_, radii_);
        film_.add(device_, 0, emitted_);
        film_.add(device_, 1, indirect_);
        break;
    case PhotonView::CausticMap:
        maps_.estimateCaustics(visiblePoints_, caustic_, radii_);
        film_.add(device_, 0, caustic_);
        break;
    case PhotonView::Radius:
        maps_.estimateGlobal(visiblePoints_, kAllLight, indirect_, radii_);
        showRadii();
        film_.add(device_, 0, caustic_);
        break;
    case PhotonView::Photons:
        renderLight(pass);
        film_.add(device_, 4, points_);
        break;
    case PhotonView::Picture:
        renderLight(pass);
        break;
    }
    device_.commands.finish();
    const RaysTraced rays = cameraPaths_.raysTraced();
    counts_[Counter::CameraRays] = rays.camera;
    counts_[Counter::GatheringRays] = rays.gathering;
    counts_[Counter::ShadowRays] = rays.shadow + lightSampler_.raysTraced();
    counts_[Counter::ShadowRaysSaved] = raysSaved_.read();
    counts_[Counter::PhotonRays] = maps_.raysTraced();
}

void PhotonMapping::showRadii() {
    device_.commands.finish();
    std::vector<glm::vec3> colors;
    for (const float radius : radii_.read()) {
        colors.emplace_back(radius);
    }
    caustic_.write(colors);
}

void PhotonMapping::begin() {
    if (files_.load.empty()) {
        maps_.trace();
    } else {
        maps_.load(readPhotons(files_.load, identifyPhotons(scene_, deviceScene_, device_.compiler)));
    }
    if (!files_.save.empty()) {
        writePhotons(files_.save, maps_.lists(), identifyPhotons(scene_, deviceScene_, device_.compiler));
    }
    maps_.build();
    if (scene_.render.photonMap.view == PhotonView::Photons) {
        drawPhotons();
    }
    noteMaps();
}

void PhotonMapping::noteMaps() {
    const PhotonMapSettings& settings = scene_.render.photonMap;
    const PhotonLists& lists = maps_.lists();
    counts_[Counter::PhotonsEmitted] = scene_.render.photons;
    counts_[Counter::PhotonsStored] = lists.global.size();
    counts_[Counter::CausticPhotonsEmitted] = maps_.hasTargets() ? settings.causticPhotons : 0;
    counts_[Counter::CausticPhotonsStored] = lists.caustic.size();
    notes_.lights = maps_.balance();
    const auto warn = [&](const std::string& text) { notes_.warnings.push_back(text); };
    if (lists.global.empty()) {
        warn("no photon landed on a diffuse surface: there is no indirect light (do the lights shine into the scene?)");
    }
    if (maps_.hasTargets() && settings.causticPhotons > 0 && lists.caustic.empty()) {
        warn("none of the " + std::to_string(settings.causticPhotons) +
             " caustic photons reached a diffuse surface through a mirror or glass: there are no caustics (can the "
             "lights reach anything specular?)");
    }
    if (!lists.global.empty() && lists.global.size() < settings.nearest) {
        warn("the global map holds " + std::to_string(lists.global.size()) + " photons, fewer than render.nearest = " +
             std::to_string(settings.nearest) + ": every estimate uses all photons within its radius");
    }
}

void PhotonMapping::renderLight(std::uint32_t pass) {
    // Direct light on diffuse surfaces, one light at a time, with a shadow ray where the photons do not decide; of many
    // lights, a picked one
    sampleDirectLight(pass);
    // Light that comes only by mirrors and glass
    maps_.estimateCaustics(visiblePoints_, caustic_, radii_);
    // Light that comes by other diffuse surfaces
    if (scene_.render.photonMap.gatherRays > 0) {
        gatherIndirectLight(pass);
    } else {
        maps_.estimateGlobal(visiblePoints_, 1U << shared::kPhotonIndirect, indirect_, radii_);
    }
    film_.add(device_, 0, emitted_);
    film_.add(device_, 1, direct_);
    film_.add(device_, 2, caustic_);
    film_.add(device_, 3, indirect_);
}

void PhotonMapping::sampleDirectLight(std::uint32_t pass) {
    gpu::Commands& commands = device_.commands;
    const std::uint32_t pixels = film_.pixelCount();
    if (deviceScene_.lightCount > kMostLightsAsked) {
        lightSampler_.sample(visiblePoints_, shared::kNone, pass, scene_.render.maxDepth);
        lightSampler_.trace(direct_);
        return;
    }
    const bool classified = scene_.render.photonMap.shadowPhotons > 0;
    if (classified) {
        maps_.classify(visiblePoints_, lit_, shadowed_);
    }
    for (std::uint32_t light = 0; light < deviceScene_.lightCount; ++light) {
        lightSampler_.sample(visiblePoints_, light, pass, scene_.render.maxDepth);
        if (classified && light < shared::kMostClassifiedLights) {
            commands.run(skipShadowRays_,
                         shared::SkipShadowRaysArguments{.lit = lit_,
                                                         .shadowed = shadowed_,
                                                         .shadowRays = lightSampler_.shadowRays(),
                                                         .contributions = lightSampler_.contributions(),
                                                         .direct = direct_,
                                                         .raysSaved = raysSaved_,
                                                         .light = light,
                                                         .count = pixels},
                         pixels);
        }
        lightSampler_.trace(direct_);
    }
}

void PhotonMapping::gatherIndirectLight(std::uint32_t pass) {
    gpu::Commands& commands = device_.commands;
    const PhotonMapSettings& settings = scene_.render.photonMap;
    const std::uint32_t pixels = film_.pixelCount();
    const float scale = 1 / static_cast<float>(settings.gatherRays);
    commands.clear(indirect_.buffer());
    for (std::uint32_t ray = 0; ray < settings.gatherRays; ++ray) {
        const std::uint32_t gather = shared::gatherPass(pass, settings.gatherRays, ray);
        CameraQueue& queue = cameraPaths_.queue();
        commands.run(startGatherRays_,
                     shared::StartGatherRaysArguments{.visiblePoints = visiblePoints_,
                                                      .materials = deviceScene_.materials,
                                                      .rays = queue.nextRays,
                                                      .paths = queue.nextPaths,
                                                      .alive = queue.alive,
                                                      .count = pixels,
                                                      .pass = gather},
                     pixels);
        commands.clear(gatherPoints_.buffer());
        cameraPaths_.start(pixels);
        // Emission and direct light along the gathering rays are skipped: caustic and direct light already contain them
        cameraPaths_.follow(gather, gatherPoints_, unused_, nullptr);
        if (settings.precomputedIrradiance) {
            maps_.addIrradiance(gatherPoints_, indirect_, scale);
        }
        // Where no record is on the same surface nearby, or none is computed: a full estimate
        maps_.estimateGlobal(gatherPoints_, kAllLight, found_, radii_);
        commands.run(
            addGatheredLight_,
            shared::AddGatheredLightArguments{.colors = found_, .gathered = indirect_, .count = pixels, .scale = scale},
            pixels);
    }
}

void PhotonMapping::drawPhotons() {
    const gpu::Array<shared::uint> splatted(device_.context, std::size_t{4} * film_.pixelCount(), "photons per pixel");
    const gpu::FinishAtEnd finish(device_.commands);
    device_.commands.clear(splatted.buffer());
    maps_.splat(splatted);
    device_.commands.finish();
    const std::vector<shared::uint> counts = splatted.read();
    std::vector<glm::vec3> colors(film_.pixelCount());
    for (std::size_t pixel = 0; pixel < colors.size(); ++pixel) {
        for (std::size_t kind = 0; kind < kPointColors.size(); ++kind) {
            colors[pixel] += static_cast<float>(std::min(counts[4 * pixel + kind], 1U)) * kPointColors.at(kind);
        }
    }
    points_ = {device_.context, std::span<const glm::vec3>(colors), "photons as points"};
}

} // namespace hyalite::render
