#include "render/film/scene_identity.h"

#include "base/fnv.h"
#include "geometry/light_use.h"
#include "gpu/shader_compiler.h"
#include "scene/model/recentre.h"
#include "scene/yaml/settings_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <filesystem>

namespace hyalite::render {

namespace {

template <class T>
std::uint64_t fnvOf(const gpu::Array<T>& array, std::uint64_t state) {
    constexpr std::size_t kAtOnce = std::size_t{1}
                                    << 20U; // hash in parts: there may be no room for a second copy of a large mesh
    for (std::size_t first = 0; first < array.count(); first += kAtOnce) {
        const std::vector<T> part = array.read(first, std::min(kAtOnce, array.count() - first));
        state = fnv(std::as_bytes(std::span(part)), state);
    }
    return state;
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
    for (shared::LightRecord light : deviceScene.lights.read()) {
        light.triangles = {}; // addresses of parts of lights differ from run to run; the parts themselves follow
        light.texels = {};
        light.cdfs = {};
        light.hierarchy = {};
        light.pmf = 0; // any probabilities give the same picture on average; they may depend on the device's rounding
        light.cdf = 0;
        state = fnv(std::as_bytes(std::span(&light, 1)), state);
    }
    state = fnvOf(deviceScene.lightTriangles, state);
    state = fnvOf(deviceScene.lightTexels, state);
    state = fnvOf(deviceScene.lightCdfs, state);
    state = fnvOf(deviceScene.textures, state);
    state = fnvOf(deviceScene.textureCoordinates, state);
    for (const shared::InstanceRecord& instance : deviceScene.instances.read()) {
        // What it touches follows from the geometry
        constexpr std::size_t kRows = offsetof(shared::InstanceRecord, neighbors);
        state = fnv(std::as_bytes(std::span(&instance, 1)).first(kRows), state);
    }
    state = fnvOf(deviceScene.normals, state);
    state = fnvOf(deviceScene.geometry, state);
    return fnvOf(deviceScene.objects, state);
}

RenderIdentity identify(const Scene& scene, const DeviceScene& deviceScene, const gpu::ShaderCompiler& compiler) {
    const Settings settings{inWorld(scene.camera, scene), scene.render};
    RenderIdentity identity;
    identity.scene = std::filesystem::path(scene.file).filename().string();
    for (const Setting& setting : settingsTable()) {
        if (setting.affectsPicture) {
            identity.settings.emplace_back(dottedName(setting), setting.text(settings));
        }
    }
    const std::vector<double> shares = photonShares(scene);
    const std::uint64_t hash = fnv(std::as_bytes(std::span(&deviceScene.camera, 1)),
                                   fnv(std::as_bytes(std::span(shares)), hashOf(deviceScene)));
    identity.settings.emplace_back("the scene's hash", hexadecimal(hash));
    identity.settings.emplace_back("the shaders' hash", hexadecimal(compiler.hashOfSources()));
    return identity;
}

std::span<const std::string_view> kernelsOfPhotons() {
    static constexpr std::array<std::string_view, 9> kKernels{
        "emit_photons", "emit_caustic_photons", "trace_closest", "scatter_photon", "cast_shadow_photons",
        "scan_group",   "sum_chunks",           "scan_chunks",   "compact_paths"};
    return kKernels;
}

RenderIdentity identifyPhotons(const Scene& scene, const DeviceScene& deviceScene,
                               const gpu::KernelCompiler& compiler) {
    const Settings settings{inWorld(scene.camera, scene), scene.render};
    RenderIdentity identity;
    identity.scene = std::filesystem::path(scene.file).filename().string();
    for (const Setting& setting : settingsTable()) {
        if (setting.photons == PhotonsDepend::OnValue) {
            identity.settings.emplace_back(dottedName(setting), setting.text(settings));
        } else if (setting.photons == PhotonsDepend::OnWhetherZero) {
            identity.settings.emplace_back(dottedName(setting), setting.text(settings) == "0" ? "0" : "not 0");
        }
    }
    identity.settings.emplace_back("the scene's hash", hexadecimal(hashOf(deviceScene)));
    identity.settings.emplace_back("the hash of the GLSL that traces photons",
                                   hexadecimal(compiler.hashOfSources(kernelsOfPhotons())));
    return identity;
}

} // namespace hyalite::render
