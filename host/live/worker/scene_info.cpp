#include "live/worker/scene_info.h"

#include "live/messages/setting_rows.h"
#include "scene/model/recentre.h"

#include <array>

namespace hyalite::live {

namespace {

std::array<double, 3> listOf(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace

SceneInfo sceneInfoOf(const Scene& scene, const View& view) {
    SceneInfo info;
    for (const Texture& texture : scene.textures) {
        if (const auto* custom = std::get_if<CustomTexture>(&texture.model)) {
            info.code.push_back(custom->code->file);
        }
    }
    for (const Material& material : scene.materials) {
        if (material.model.code != nullptr) {
            info.code.push_back(material.model.code->file);
        }
    }
    if (scene.render.photonMap.customFilter) {
        info.code.push_back(scene.render.photonMap.customFilter->file);
    }
    const Camera camera = inWorld(scene.camera, scene);
    info.camera = {.position = listOf(camera.position),
                   .lookAt = listOf(camera.lookAt),
                   .up = listOf(camera.up),
                   .fov = camera.fov,
                   .resolution = {camera.resolution.x, camera.resolution.y}};
    info.settings = settingValues(scene);
    info.shown = view.shown;
    return info;
}

PictureInfo pictureInfoOf(const LiveRenderer::Frame& frame) {
    PictureInfo info;
    info.width = frame.image.picture.width;
    info.height = frame.image.picture.height;
    info.isPreview = frame.isPreview;
    info.passes = frame.passes;
    info.ofPasses = frame.ofPasses;
    info.error = frame.error;
    for (const auto& [name, time] : frame.stages) {
        info.stages.push_back({.name = name, .seconds = time.seconds, .dispatches = time.dispatches});
    }
    info.photonsStored = frame.counts[render::Counter::PhotonsStored];
    info.causticPhotonsStored = frame.counts[render::Counter::CausticPhotonsStored];
    info.radius = frame.notes.searchRadius;
    info.warnings = frame.notes.warnings;
    return info;
}

} // namespace hyalite::live
