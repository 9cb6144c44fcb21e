// False colours for a map of errors.
#include "image/error_map.h"

#include "image/srgb.h"

#include <algorithm>

namespace hyalite {
namespace {

// The colours of glowing iron: each third of the range raises one channel of sRGB from 0 to 1, so that a larger error
// is brighter too and the map survives a black-and-white print.
glm::vec3 glow(double value) {
    glm::vec3 colour(0.0F);
    for (int channel = 0; channel < 3; ++channel) {
        const double srgb = std::clamp(3.0 * value - channel, 0.0, 1.0);
        colour[channel] = static_cast<float>(linearFromSrgb(srgb));
    }
    return colour;
}

} // namespace

Image falseColour(const ErrorMap& map, const Crop& crop) {
    Image image(crop.width, crop.height);
    for (int y = 0; y < crop.height; ++y) {
        for (int x = 0; x < crop.width; ++x) {
            image.at(x, y) = glow(map.at(crop.x0 + x, crop.y0 + y));
        }
    }
    return image;
}

} // namespace hyalite
