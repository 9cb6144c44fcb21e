// Daylight sky with sun and ground [Preetham99]. It has no light type on the device: it becomes an environment, with
// the sun as a disc in it or as a directional light.
#include "kinds/lights/environment.h"
#include "kinds/lights/light_kinds.h"
#include "kinds/lights/sky_model.h"
#include "scene/yaml/read_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace hyalite::kinds {
namespace {

using glm::dvec3;
using std::numbers::pi;

constexpr KeyDoc kSun{.name = "sun",
                      .type = KeyType::Vector,
                      .range = kDirection,
                      .required = true,
                      .text = "direction towards the sun, any nonzero length; above the horizon: y > 0"};
constexpr KeyDoc kTurbidity{.name = "turbidity",
                            .range = {2, 10},
                            .defaultText = "3",
                            .text = "extinction by haze and air relative to air alone: 2 very clear, 3 clear, 10 hazy"};
constexpr KeyDoc kScale{.name = "scale",
                        .range = {0, kLargestEmission},
                        .defaultText = "1",
                        .text = "factor of all radiances, including the sun's",
                        .rangeText = "(0, 1e12]"};
constexpr KeyDoc kSunScale{.name = "sun_scale",
                           .range = {0, 1e6},
                           .defaultText = "1",
                           .text = "factor of the sun alone; 0: no visible sun, the sky stays lit"};
constexpr KeyDoc kSunRadius{
    .name = "sun_radius",
    .range = {0, 10, true, true, "degrees"},
    .defaultText = "0.265",
    .text = "angular radius of the sun; 0: a directional light, with hard shadows, invisible to rays"};
constexpr KeyDoc kGround{.name = "ground_albedo",
                         .type = KeyType::Color,
                         .range = {0, 1},
                         .defaultText = "0.2",
                         .text = "albedo of the ground below the horizon, which sky and sun light"};
constexpr KeyDoc kResolution{.name = "resolution",
                             .type = KeyType::WholeNumber,
                             .range = {16, 4096},
                             .defaultText = "512",
                             .text =
                                 "rows of the environment, with twice as many columns; at 512, a row is 0.35 degrees"};
constexpr std::array kKeys{kSun, kTurbidity, kScale, kSunScale, kSunRadius, kGround, kResolution, kPhotonShare};

struct Sky {
    dvec3 sun{0, 1, 0}; // unit
    double turbidity = 3;
    double scale = 1;
    double sunScale = 1;
    double sunRadius = 0.265; // [degrees]
    dvec3 groundAlbedo{0.2};
    std::uint32_t resolution = 512;
};

// An equirectangular grid with twice as many columns as rows: the centre is in direction -z, the upper edge +y.
struct Grid {
    int rows;

    [[nodiscard]] int columns() const { return 2 * rows; }
    // The unit direction through the point (x, y) of the grid, in texels from its upper left corner.
    [[nodiscard]] dvec3 direction(double x, double y) const {
        const double phi = 2 * pi * x / columns();
        const double theta = pi * y / rows;
        return {-std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
    }
    // Solid angle of a texel of the row [sr].
    [[nodiscard]] double solidAngle(int row) const {
        return 2 * pi / columns() * (std::cos(pi * row / rows) - std::cos(pi * (row + 1) / rows));
    }
    // Irradiance of level ground from a texel of the row, per unit radiance: the integral of the cosine [sr].
    [[nodiscard]] double projectedAngle(int row) const {
        const double top = std::sin(pi * row / rows);
        const double bottom = std::sin(pi * std::min(row + 1.0, rows / 2.0) / rows);
        return pi / columns() * (bottom * bottom - top * top);
    }
};

// Fraction of a texel that the sun covers, from 16 x 16 points in it.
double coverage(const Grid& grid, const Sky& sky, int x, int y) {
    constexpr int kPlaces = 16;
    const double sine = std::sin(glm::radians(sky.sunRadius) / 2);
    int covered = 0;
    for (int i = 0; i < kPlaces * kPlaces; ++i) {
        const dvec3 direction = grid.direction(x + (i % kPlaces + 0.5) / kPlaces, y + (i / kPlaces + 0.5) / kPlaces);
        covered += glm::length(direction - sky.sun) / 2 <= sine ? 1 : 0; // the chord: acos is coarse near 1
    }
    return static_cast<double>(covered) / (kPlaces * kPlaces);
}

// Adds the sun's disc to the texels that it covers. Its irradiance is exact for any texel size; a sun smaller than a
// texel fills the texel that contains it.
void addSun(Image& image, const Grid& grid, const Sky& sky, const dvec3& irradiance) {
    const double around = std::atan2(-sky.sun.x, sky.sun.z) / (2 * pi);
    const int sunColumn =
        std::min(static_cast<int>((around - std::floor(around)) * grid.columns()), grid.columns() - 1);
    const int sunRow = std::min(static_cast<int>(std::acos(std::min(sky.sun.y, 1.0)) / pi * grid.rows), grid.rows - 1);
    const double reach = glm::radians(sky.sunRadius) + 2 * pi / grid.rows; // a texel's diagonal and more
    std::vector<double> weights(image.pixels.size(), 0);
    double total = 0; // solid angle [sr]
    const auto add = [&](int x, int y, double weight) {
        weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns()) + static_cast<std::size_t>(x)] =
            weight;
        total += weight * grid.solidAngle(y);
    };
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns(); ++x) {
            if (glm::dot(grid.direction(x + 0.5, y + 0.5), sky.sun) > std::cos(std::min(reach, pi))) {
                add(x, y, coverage(grid, sky, x, y));
            }
        }
    }
    if (total == 0) {
        add(sunColumn, sunRow, 1);
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
        image.pixels[i] = dvec3(image.pixels[i]) + irradiance * (weights[i] / total);
    }
}

// The sky above the horizon and the ground below it, without the sun's disc.
Image skyImage(const Grid& grid, const Sky& sky, const dvec3& sunOnGround) {
    const SkyModel model(sky.turbidity, sky.sun);
    Image image(grid.columns(), grid.rows);
    dvec3 ground = sunOnGround; // irradiance [W/m^2]
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns() && 2 * y < grid.rows; ++x) {
            const dvec3 radiance = sky.scale * model.radiance(grid.direction(x + 0.5, y + 0.5));
            image.at(x, y) = radiance;
            ground += radiance * grid.projectedAngle(y);
        }
    }
    for (int y = (grid.rows + 1) / 2; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns(); ++x) {
            image.at(x, y) = sky.groundAlbedo * ground / pi; // Lambert's law
        }
    }
    return image;
}

void read(Reader& reader, const std::filesystem::path& /*folder*/, Scene& scene) {
    checkFirstEnvironment(reader, scene);
    Sky sky;
    double photonShare = 1;
    const Value sun = reader.require(kSun.name);
    sky.sun = readUnit(sun);
    if (!(sky.sun.y > 0)) {
        sun.fail("the sun must be above the horizon", "y must be above 0; there is no night sky model");
    }
    readKey(reader, kTurbidity, sky.turbidity);
    readKey(reader, kScale, sky.scale);
    readKey(reader, kSunScale, sky.sunScale);
    readKey(reader, kSunRadius, sky.sunRadius);
    readKey(reader, kGround, sky.groundAlbedo);
    readKey(reader, kResolution, sky.resolution);
    readKey(reader, kPhotonShare, photonShare);
    if (sky.scale == 0) {
        reader.require(kScale.name).fail("this light emits nothing", "give it a scale above 0 or remove it");
    }

    const double air = relativeAirMass(std::acos(std::min(sky.sun.y, 1.0)));
    const dvec3 irradiance =
        sky.scale * sky.sunScale * sunIrradiance(sky.turbidity, air); // of a surface that faces the sun
    const Grid grid{static_cast<int>(sky.resolution)};
    Environment environment{.image = skyImage(grid, sky, irradiance * sky.sun.y), .photonShare = photonShare};
    const bool isSeen = irradiance != dvec3(0);
    if (isSeen && sky.sunRadius > 0) {
        addSun(environment.image, grid, sky, irradiance);
    } else if (isSeen) {
        scene.directionals.push_back(
            {.direction = -sky.sun, .irradiance = irradiance, .photonShare = photonShare, .where = reader.where()});
    }
    const auto isTooBright = [](const glm::vec3& c) { return !(std::max({c.x, c.y, c.z}) <= kLargestEmission); };
    if (std::any_of(environment.image.pixels.begin(), environment.image.pixels.end(), isTooBright)) {
        reader.map().fail("the sky is too bright", "its radiance must be " + kRadiance.text());
    }
    environment.where = reader.where();
    scene.environment = std::move(environment);
}

} // namespace

constinit const LightKind kSkyLight{
    .doc =
        {.type = "sky",
         .schemaName = "skyLight",
         .text =
             "A *sky* is a daylight sky [Preetham99] with its sun and flat ground below the horizon. It becomes the "
             "scene's environment, so a scene has at most one of the two. +y is up. White of luminance Y has a "
             "radiance "
             "of Y / 179 W/(m² sr) in each channel of linear sRGB. The sun is a black body of 5772 K seen through air "
             "and haze; its disc is drawn into the environment's pixels and has the sun's irradiance at any "
             "resolution.",
         .keys = kKeys},
    .read = read};

} // namespace hyalite::kinds
