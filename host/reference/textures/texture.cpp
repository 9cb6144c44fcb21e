// See texture.h.
#include "reference/textures/texture.h"

#include "reference/bsdf/custom_twins.h"
#include "reference/world.h"

#include <cmath>

namespace hyalite::reference {

namespace {

using glm::dvec2;
using glm::dvec3;

// World-space cells start this fraction of a cell before the multiples of the cell size, so that rounding does not
// decide the colour of a surface that lies in such a plane.
constexpr double kCheckerShift = 0x1p-10;

dvec3 evaluate(const Checker& checker, const dvec2& uv, const dvec3& position) {
    const dvec3 place = checker.inWorld ? position / checker.size + kCheckerShift : dvec3(uv / checker.size, 0);
    const double cells = std::floor(place.x) + std::floor(place.y) + std::floor(place.z);
    return checker.colors.at(std::fmod(cells, 2) == 0 ? 0 : 1);
}

int wrapped(double index, int size) {
    const double rest = index - size * std::floor(index / size);
    return static_cast<int>(rest);
}

// The image repeats in both directions, with v upwards from its lower edge: bilinear interpolation of the four texels
// whose centres surround the point.
dvec3 evaluate(const ImageTexture& texture, const dvec2& uv, const dvec3& /*position*/) {
    const Image& image = *texture.image;
    const double x = uv.x * image.width - 0.5;
    const double y = (1 - uv.y) * image.height - 0.5;
    dvec3 sum(0);
    for (const double column : {std::floor(x), std::floor(x) + 1}) {
        for (const double row : {std::floor(y), std::floor(y) + 1}) {
            const double weight = (1 - std::abs(x - column)) * (1 - std::abs(y - row));
            sum += weight * dvec3(image.at(wrapped(column, image.width), wrapped(row, image.height)));
        }
    }
    return sum;
}

dvec3 evaluate(const CustomTexture& texture, const dvec2& uv, const dvec3& position) {
    const TextureTwin twin = customTextureTwin(*texture.code);
    if (twin == nullptr) {
        throw noTwin(*texture.code);
    }
    return glm::clamp(twin(position, uv, texture.parameters), 0.0, 1.0);
}

} // namespace

dvec3 evaluateTexture(const TextureModel& texture, const dvec2& uv, const dvec3& position) {
    return std::visit([&](const auto& model) { return evaluate(model, uv, position); }, texture);
}

MaterialModel texturedModel(const World& world, const Surface& surface) {
    const auto valueOf = [&](std::size_t texture) {
        return evaluateTexture(world.textures.at(texture).model, surface.uv, world.origin + surface.position);
    };
    MaterialModel model = surface.material->model;
    if (const auto texture = surface.material->colorTexture) {
        model.color *= valueOf(*texture);
    }
    if (const auto texture = surface.material->roughnessTexture) {
        const dvec3 factors = valueOf(*texture);
        model.roughness *= factors.g;
        model.metallic *= factors.b;
    }
    return model;
}

} // namespace hyalite::reference
