#include "render/film/scene_identity.h"

#include "base/fnv.h"
#include "gpu/shader_compiler.h"
#include "scene/model/render_seed.h"

#include <array>
#include <charconv>
#include <filesystem>

namespace hyalite::render {

namespace {

template <class T>
std::uint64_t fnvOf(const gpu::Array<T>& array, std::uint64_t state) {
    return fnv(std::as_bytes(array.host()), state);
}

// The shortest text that reads back as the same number.
template <class Number>
std::string text(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return {digits.data(), end};
}

std::string hexadecimal(std::uint64_t value) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
    return {digits.data(), end};
}

} // namespace

std::uint64_t hashOf(const DeviceScene& deviceScene) {
    std::uint64_t state = kFnvStart;
    state = fnvOf(deviceScene.materials, state);
    for (shared::LightRecord light : deviceScene.lights.host()) {
        light.triangles = {}; // where parts of lights stand differs from run to run; the parts themselves follow
        light.texels = {};
        light.cdfs = {};
        state = fnv(std::as_bytes(std::span(&light, 1)), state);
    }
    state = fnvOf(deviceScene.lightTriangles, state);
    state = fnvOf(deviceScene.lightTexels, state);
    state = fnvOf(deviceScene.lightCdfs, state);
    state = fnvOf(deviceScene.textures, state);
    state = fnvOf(deviceScene.textureCoordinates, state);
    state = fnvOf(deviceScene.instances, state);
    state = fnvOf(deviceScene.normals, state);
    state = fnvOf(deviceScene.geometry, state);
    return fnvOf(deviceScene.objects, state);
}

RenderIdentity identify(const Scene& scene, const DeviceScene& deviceScene, const gpu::ShaderCompiler& compiler) {
    const RenderSettings& render = scene.render;
    const PhotonMapSettings& maps = render.photonMap;
    const glm::uvec2 resolution = scene.camera.resolution;
    RenderIdentity identity;
    identity.scene = std::filesystem::path(scene.file).filename().string();
    identity.settings = {
        {"integrator", render.integrator},
        {"camera.resolution", text(resolution.x) + 'x' + text(resolution.y)},
        {"render.seed", text(render.seed)},
        {"render.sampler", nameOf(render.sampler)},
        {"render.max_depth", text(render.maxDepth)},
        {"render.photons", text(render.photons)},
        {"render.radius", text(render.radius)},
        {"render.alpha", text(render.alpha)},
        {"render.min_weight", text(render.minWeight)},
        {"render.caustic_photons", text(maps.causticPhotons)},
        {"render.projection_map", text(maps.projectionMap ? 1 : 0)},
        {"render.photon_structure", text(static_cast<int>(maps.structure))},
        {"render.nearest", text(maps.nearest)},
        {"render.caustic_nearest", text(maps.causticNearest)},
        {"render.caustic_radius", text(maps.causticRadius)},
        {"render.filter", text(static_cast<int>(maps.filter))},
        {"render.caustic_filter", text(static_cast<int>(maps.causticFilter))},
        {"render.cone_constant", text(maps.coneConstant)},
        {"render.differential_checking", text(maps.differentialChecking ? 1 : 0)},
        {"render.gather_rays", text(maps.gatherRays)},
        {"render.precomputed_irradiance", text(maps.precomputedIrradiance ? 1 : 0)},
        {"render.shadow_photons", text(maps.shadowPhotons)},
        {"render.view", text(static_cast<int>(maps.view))},
        {"the scene's hash", hexadecimal(fnv(std::as_bytes(std::span(&deviceScene.camera, 1)), hashOf(deviceScene)))},
        {"the shaders' hash", hexadecimal(compiler.hashOfSources())},
    };
    return identity;
}

std::uint64_t photonFingerprint(const Scene& scene, const DeviceScene& deviceScene) {
    const RenderSettings& render = scene.render;
    const PhotonMapSettings& maps = render.photonMap;
    const std::array<std::uint32_t, 6> settings{render.photons,     renderSeed(render).sequence,
                                                render.maxDepth,    maps.causticPhotons,
                                                maps.projectionMap, maps.shadowPhotons > 0 ? 1U : 0U};
    return fnv(std::as_bytes(std::span(settings)), hashOf(deviceScene));
}

} // namespace hyalite::render
