// A picture, the layers that it is the sum of, and further quantities of its pixels.
#pragma once

#include "image/image.h"

#include <optional>
#include <string>
#include <vector>

namespace hyalite {

// What a renderer sums over its passes.
struct LayerKind {
    std::string name;
    bool isLight = true; // part of the picture; else a quantity of its own, such as a radius
};

struct NamedImage {
    std::string name;
    Image image;
};

struct LayeredImage {
    Image picture;                  // the sum of the layers that are light, in their order
    std::vector<NamedImage> layers; // empty where there is only one
    std::optional<Image> error;     // standard error of the picture, by chance alone; none before the second pass
};

// layers[i] is of kind kinds[i], all of one size; some layer is light.
[[nodiscard]] LayeredImage compose(const std::vector<LayerKind>& kinds, std::vector<Image> layers);

} // namespace hyalite
