#include "render/film.h"

#include <utility>

namespace hyalite::render {

Film::Film(Device& device, glm::uvec2 resolution, std::vector<LayerKind> layers)
    : resolution_(resolution), layers_(std::move(layers)), accumulateFilm_(device.kernel("accumulate_film")),
      resolveFilm_(device.kernel("resolve_film")), image_(device.context, pixelCount(), "image") {
    for (const LayerKind& layer : layers_) {
        sums_.emplace_back(device.context, pixelCount(), "film of " + layer.name);
        device.commands.clear(sums_.back().buffer());
    }
}

void Film::add(Device& device, std::size_t layer, const gpu::Array<glm::vec3>& colors) const {
    device.commands.run(accumulateFilm_, shared::AccumulateFilmArguments{colors, sums_.at(layer), pixelCount(), 1},
                        pixelCount());
}

LayeredImage Film::resolve(Device& device, std::uint32_t passes) const {
    const float scale = 1 / static_cast<float>(passes);
    std::vector<Image> images;
    for (const auto& sums : sums_) {
        device.commands.run(resolveFilm_, shared::ResolveFilmArguments{sums, image_, pixelCount(), scale},
                            pixelCount());
        device.commands.finish();
        images.emplace_back(static_cast<int>(resolution_.x), static_cast<int>(resolution_.y));
        images.back().pixels = image_.read();
    }
    return compose(layers_, std::move(images));
}

} // namespace hyalite::render
