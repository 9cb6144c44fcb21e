#include "image/layered_image.h"

#include <utility>

namespace hyalite {

LayeredImage compose(const std::vector<LayerKind>& kinds, std::vector<Image> layers) {
    LayeredImage result;
    if (layers.size() == 1) {
        result.picture = std::move(layers.front());
        return result;
    }
    result.picture = Image(layers.front().width, layers.front().height);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        for (std::size_t pixel = 0; kinds[i].isLight && pixel < layers[i].pixels.size(); ++pixel) {
            result.picture.pixels[pixel] += layers[i].pixels[pixel];
        }
        result.layers.push_back({kinds[i].name, std::move(layers[i])});
    }
    return result;
}

} // namespace hyalite
