#include "reference/integrators/photon_views.h"

#include "reference/film/film.h"
#include "reference/integrators/photon_mapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace hyalite::reference {

namespace {

// Colour of a drawn photon, by kind: direct yellow, indirect blue, caustic red, shadow magenta.
constexpr std::array<glm::dvec3, 4> kPointColors{{{1, 0.8, 0.1}, {0.1, 0.3, 1}, {1, 0.1, 0.05}, {0.5, 0, 0.5}}};

// The pixel that sees a point from the centre of the lens; none if the point is outside the picture or occluded.
// Surfaces within the last thousandth of the distance do not occlude: they are the point's own.
std::optional<std::size_t> pixelOf(const World& world, const glm::dvec3& place) {
    const CameraFrame& camera = world.camera;
    const glm::dvec3 way = place - camera.position;
    const double depth = glm::dot(way, camera.forward);
    if (!(depth > 0)) {
        return std::nullopt;
    }
    const double sx = glm::dot(way, camera.right) / glm::dot(camera.right, camera.right) / depth;
    const double sy = glm::dot(way, camera.up) / glm::dot(camera.up, camera.up) / depth;
    if (!(std::abs(sx) < 1 && std::abs(sy) < 1) ||
        !traceShadow(world, camera.position, camera.position + 0.999 * way)) {
        return std::nullopt;
    }
    const auto x = static_cast<std::size_t>((sx + 1) / 2 * camera.width);
    const auto y = static_cast<std::size_t>((1 - sy) / 2 * camera.height);
    return std::min<std::size_t>(y, camera.height - 1) * camera.width + std::min<std::size_t>(x, camera.width - 1);
}

// Per pixel, the sum of the colours of the photons seen there.
std::vector<glm::dvec3> drawPhotons(const World& world, const PhotonMaps& maps) {
    const std::size_t pixels = std::size_t{world.camera.width} * world.camera.height;
    std::vector<std::array<bool, 4>> seen(pixels);
    for (const PhotonMap* map :
         {&maps.global, maps.caustic ? &*maps.caustic : nullptr, maps.shadow ? &*maps.shadow : nullptr}) {
        for (std::size_t i = 0; map != nullptr && i < map->photons().size(); ++i) {
            const Photon& photon = map->photons()[i];
            if (const std::optional<std::size_t> pixel = pixelOf(world, photon.position)) {
                seen[*pixel].at(static_cast<std::size_t>(photon.kind)) = true;
            }
        }
    }
    std::vector<glm::dvec3> colors(pixels, glm::dvec3(0));
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        for (std::size_t kind = 0; kind < kPointColors.size(); ++kind) {
            colors[pixel] += seen[pixel].at(kind) ? kPointColors.at(kind) : glm::dvec3(0);
        }
    }
    return colors;
}

// Contribution of a pass to each layer of a pixel.
using LayerSample = std::function<std::vector<glm::dvec3>(std::uint32_t pixel, std::uint32_t pass)>;

struct ViewLayers {
    std::vector<LayerKind> kinds;
    LayerSample sample;
};

// Sums what `visit` returns at the visible points of a pixel, and the emission along the path.
template <class Visit>
std::vector<glm::dvec3> sampleMap(const World& world, std::uint32_t pixel, std::uint32_t pass, const Visit& visit) {
    glm::dvec3 emitted(0);
    glm::dvec3 found(0);
    followPath(world, generateCameraRay(world, pixel, pass), beginCameraPath(world, pixel, pass), 1, pass,
               [&](const Shading& shading) {
                   emitted += shading.emitted;
                   if (shading.visible) {
                       found += visit(*shading.visible);
                   }
               });
    return {emitted, found};
}

ViewLayers pictureLayers(const World& world, const PhotonMaps& maps) {
    return {.kinds = {{"emitted"}, {"direct"}, {"caustic"}, {"indirect"}},
            .sample = [&](std::uint32_t pixel, std::uint32_t pass) {
                const LightComponents light = photonMapRadiance(world, maps, pixel, pass);
                return std::vector{light.emitted, light.direct, light.caustic, light.indirect};
            }};
}

ViewLayers layersOfView(const World& world, const PhotonMaps& maps) {
    switch (world.render.photonMap.view) {
    case PhotonView::GlobalMap:
        return {.kinds = {{"emitted"}, {"global_map"}}, .sample = [&](std::uint32_t pixel, std::uint32_t pass) {
                    return sampleMap(world, pixel, pass, [&](const VisiblePoint& x) {
                        return estimateRadiance(maps.global, x, globalOptions(world, maps.globalRadius, kGlobalKinds))
                            .radiance;
                    });
                }};
    case PhotonView::CausticMap:
        return {
            .kinds = {{"emitted", /*isLight*/ false}, {"caustic_map"}},
            .sample = [&](std::uint32_t pixel, std::uint32_t pass) {
                return sampleMap(world, pixel, pass, [&](const VisiblePoint& x) {
                    return maps.caustic
                               ? estimateRadiance(*maps.caustic, x, causticOptions(world, maps.causticRadius)).radiance
                               : glm::dvec3(0);
                });
            }};
    case PhotonView::Radius:
        return {
            .kinds = {{"emitted", /*isLight*/ false}, {"radius"}},
            .sample = [&](std::uint32_t pixel, std::uint32_t pass) {
                return sampleMap(world, pixel, pass, [&](const VisiblePoint& x) {
                    return glm::dvec3(
                        estimateRadiance(maps.global, x, globalOptions(world, maps.globalRadius, kGlobalKinds)).radius);
                });
            }};
    case PhotonView::Photons: {
        ViewLayers layers = pictureLayers(world, maps);
        layers.kinds.push_back({"photons"});
        layers.sample = [picture = std::move(layers.sample), points = drawPhotons(world, maps)](std::uint32_t pixel,
                                                                                                std::uint32_t pass) {
            std::vector<glm::dvec3> sample = picture(pixel, pass);
            sample.push_back(points[pixel]);
            return sample;
        };
        return layers;
    }
    case PhotonView::Picture:
        break;
    }
    return pictureLayers(world, maps);
}

} // namespace

LayeredImage renderPhotonMap(const World& world, const RenderOptions& options) {
    const PhotonMaps maps = buildPhotonMaps(world);
    const ViewLayers layers = layersOfView(world, maps);
    LayeredFilm film(world.camera.width, world.camera.height, layers.kinds,
                     [&](std::uint32_t pixel, std::uint32_t pass) { return seeksLight(world, pixel, pass); });
    for (std::uint32_t pass = 0; pass < world.render.passes; ++pass) {
        film.addPass([&](std::uint32_t pixel) { return layers.sample(pixel, pass); });
        if (options.afterPass && !options.afterPass(pass + 1, film.error())) {
            break;
        }
    }
    return film.mean();
}

} // namespace hyalite::reference
