#include "render/film.h"

#include <cmath>
#include <utility>

namespace hyalite::render {

Film::Film(Device& device, glm::uvec2 resolution, std::vector<LayerKind> layers)
    : resolution_(resolution), layers_(std::move(layers)), accumulateFilm_(device.kernel("accumulate_film")),
      resolveFilm_(device.kernel("resolve_film")), estimateError_(device.kernel("estimate_error")),
      image_(device.context, pixelCount(), "image"),
      errorSums_(device.context, (pixelCount() + shared::kErrorChunk - 1) / shared::kErrorChunk, "sums of errors") {
    for (auto& sums : sums_) {
        sums = {device.context, layers_.size() * pixelCount(), "film"};
        device.commands.clear(sums.buffer());
    }
}

shared::ColorArray Film::sums(std::size_t sequence, std::size_t layer) const {
    return {sums_.at(sequence).buffer().address() + layer * pixelCount() * sizeof(glm::vec3)};
}

void Film::add(Device& device, std::size_t layer, const gpu::Array<glm::vec3>& colors) const {
    device.commands.run(accumulateFilm_, shared::AccumulateFilmArguments{colors, sums(layer), pixelCount(), 1},
                        pixelCount());
}

LayeredImage Film::resolve(Device& device, std::uint32_t passes) const {
    const auto read = [&] {
        Image image(static_cast<int>(resolution_.x), static_cast<int>(resolution_.y));
        image.pixels = image_.read();
        return image;
    };
    const float scale = 1 / static_cast<float>(passes);
    std::vector<Image> images;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        device.commands.run(resolveFilm_,
                            shared::ResolveFilmArguments{sums(0, layer), sums(1, layer), image_, pixelCount(), scale},
                            pixelCount());
        device.commands.finish();
        images.push_back(read());
    }
    LayeredImage result = compose(layers_, std::move(images));
    if (estimateError(device, passes)) {
        result.error = read();
    }
    return result;
}

std::optional<double> Film::estimateError(Device& device, std::uint32_t passes) const {
    if (passes < shared::kCameraSequences) {
        return std::nullopt;
    }
    std::uint32_t light = 0;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        light |= layers_[layer].isLight ? 1U << layer : 0U;
    }
    const std::uint32_t second = passes / shared::kCameraSequences;
    device.commands.run(estimateError_,
                        shared::EstimateErrorArguments{sums_[0], sums_[1], image_, errorSums_, pixelCount(),
                                                       static_cast<float>(passes - second), static_cast<float>(second),
                                                       static_cast<std::uint32_t>(layers_.size()), light},
                        static_cast<std::uint32_t>(errorSums_.count()));
    device.commands.finish();
    double sum = 0;
    for (const float chunk : errorSums_.host()) {
        sum += chunk;
    }
    return std::sqrt(sum / (3.0 * pixelCount()));
}

} // namespace hyalite::render
