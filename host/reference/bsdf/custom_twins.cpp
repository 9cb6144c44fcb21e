// A twin goes here: its function, and a row of kTextures or kReflectances.
#include "reference/bsdf/custom_twins.h"

#include "shaders/shared/random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hyalite::reference {

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

// scenes/experiments/marble.glsl: veins where a coordinate, bent by noise, passes a whole number.
double cornerValue(const dvec3& corner) {
    const auto word = [](double x) { return static_cast<std::uint32_t>(static_cast<std::int32_t>(x)); };
    const std::uint32_t bits =
        shared::hashCombine(shared::hashCombine(shared::hash(word(corner.x)), word(corner.y)), word(corner.z));
    return static_cast<double>(bits >> 8U) * 0x1p-24;
}

double valueNoise(const dvec3& p) {
    const dvec3 corner = glm::floor(p);
    const dvec3 f = p - corner;
    const dvec3 w = f * f * (3.0 - 2.0 * f);
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const dvec3 step(i & 1, i >> 1 & 1, i >> 2);
        const dvec3 share = glm::mix(1.0 - w, w, step);
        sum += share.x * share.y * share.z * cornerValue(corner + step);
    }
    return sum;
}

dvec3 marble(const dvec3& position, const dvec2& /*uv*/, const dvec4& parameters) {
    const dvec3 p = position * parameters.x;
    double turbulence = 0;
    double scale = 1;
    for (int octave = 0; octave < 4; ++octave) {
        turbulence += (valueNoise(p * scale) - 0.5) / scale;
        scale *= 2;
    }
    const double along = p.x + p.y + parameters.y * turbulence;
    const double distance = std::abs(along - std::floor(along) - 0.5);
    const double vein = std::max(0.0, 1 - distance * parameters.z);
    return glm::mix(dvec3(0.85, 0.83, 0.8), dvec3(0.12, 0.13, 0.18), vein * vein);
}

// scenes/experiments/oil.glsl: a film between two faces of the reflectance R. Waves that go through it 2 m times more
// than the first add up to Airy's 1 / (1 + F sin^2(delta / 2)) of transmitted light, F = 4 R / (1 - R)^2; the rest is
// reflected.
dvec3 oil(double cosine, const dvec4& parameters) {
    const double index = parameters.y;
    const double refracted = std::asin(std::sqrt(1 - cosine * cosine) / index); // Snell
    const double R = parameters.z;
    const double F = 4 * R / ((1 - R) * (1 - R));
    const auto reflectance = [&](double wavelength) {
        const double halfDelta = 2 * std::numbers::pi / wavelength * index * parameters.x * std::cos(refracted);
        return 1 - 1 / (1 + F * std::pow(std::sin(halfDelta), 2));
    };
    return {reflectance(610), reflectance(545), reflectance(450)};
}

constexpr auto kTextures = std::to_array<std::pair<std::string_view, CustomTextureTwin>>({
    {"marble", marble},
});
constexpr auto kReflectances = std::to_array<std::pair<std::string_view, CustomReflectanceTwin>>({
    {"oil", oil},
});

template <class Twins>
auto findTwin(const Twins& twins, std::string_view function) {
    const auto found = std::ranges::find(twins, function, [](const auto& twin) { return twin.first; });
    return found == twins.end() ? nullptr : found->second;
}

} // namespace

CustomTextureTwin customTextureTwin(std::string_view function) {
    return findTwin(kTextures, function);
}

CustomReflectanceTwin customReflectanceTwin(std::string_view function) {
    return findTwin(kReflectances, function);
}

const CustomCode* textureWithoutTwin(const Scene& scene) {
    for (const Texture& texture : scene.textures) {
        const auto* custom = std::get_if<CustomTexture>(&texture.model);
        if (custom != nullptr && customTextureTwin(custom->code->function) == nullptr) {
            return custom->code.get();
        }
    }
    return nullptr;
}

const CustomCode* reflectanceWithoutTwin(const Scene& scene) {
    for (const Material& material : scene.materials) {
        const CustomCode* code = material.model.code.get();
        if (code != nullptr && customReflectanceTwin(code->function) == nullptr) {
            return code;
        }
    }
    return nullptr;
}

const CustomCode* codeWithoutTwin(const Scene& scene) {
    const CustomCode* texture = textureWithoutTwin(scene);
    const CustomCode* reflectance = reflectanceWithoutTwin(scene);
    return texture != nullptr       ? texture
           : reflectance != nullptr ? reflectance
                                    : scene.render.photonMap.customFilter.get();
}

} // namespace hyalite::reference
