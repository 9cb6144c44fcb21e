// Light from an image around the scene: shaders/lights/environment.glsl, host/reference/lights/environment.cpp.
#include "kinds/lights/environment.h"

#include "image/image_io.h"
#include "kinds/lights/light_kinds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hyalite::kinds {
namespace {

using glm::dvec3;
using glm::vec3;
using std::numbers::pi;

constexpr KeyDoc kImage{.name = "image",
                        .type = KeyType::Text,
                        .defaultText = "none",
                        .text = "EXR or PNG file, equirectangular; path relative to the scene file",
                        .schema = R"({"type": "string", "minLength": 1})"};
constexpr KeyDoc kColor{.name = "radiance",
                        .type = KeyType::Color,
                        .range = kRadiance,
                        .defaultText = "1",
                        .text = "uniform radiance, instead of an `image`; not all 0"};
constexpr KeyDoc kScale{.name = "scale",
                        .range = {0, kLargestEmission},
                        .defaultText = "1",
                        .text = "factor of all radiances",
                        .rangeText = "(0, 1e12]"};
constexpr KeyDoc kRotation{.name = "rotation",
                           .range = {-1e6, 1e6, true, true, "degrees"},
                           .defaultText = "0",
                           .text = "rotation about +y, counter-clockwise seen from above"};
constexpr std::array kKeys{kImage, kColor, kScale, kRotation, kPhotonShare};

// Reads the image and checks that every pixel is a valid radiance.
Image readMap(const Value& file, const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / file.text();
    Image image;
    try {
        image = readImage(path);
    } catch (const Error& error) {
        file.fail(path.string() + ": " + error.message(), error.hint());
    }
    if (countNotFinite(image) > 0) {
        file.fail("the image has values that are not finite");
    }
    const auto isNegative = [](const glm::vec3& c) { return c.x < 0 || c.y < 0 || c.z < 0; };
    if (std::any_of(image.pixels.begin(), image.pixels.end(), isNegative)) {
        file.fail("the image has negative values", "radiance must be at least 0");
    }
    if (std::all_of(image.pixels.begin(), image.pixels.end(), [](const glm::vec3& c) { return c == glm::vec3(0); })) {
        file.fail("the image is black", "remove the environment");
    }
    return image;
}

void read(Reader& reader, const std::filesystem::path& folder, Scene& scene) {
    checkFirstEnvironment(reader, scene);
    Environment environment;
    const auto image = reader.find(kImage.name);
    const auto radiance = reader.find(kColor.name);
    if (image && radiance) {
        radiance->fail("'image' and 'radiance' exclude each other", "remove one of them");
    }
    const auto scale = reader.find(kScale.name);
    if (scale) {
        scale->read(environment.scale, kScale.range);
    }
    readKey(reader, kRotation, environment.rotation);
    readKey(reader, kPhotonShare, environment.photonShare);
    reader.finish(); // report a wrong key before reading a large file
    if (image) {
        environment.image = readMap(*image, folder);
    } else {
        glm::dvec3 color(1);
        if (radiance) {
            radiance->readColor(color, kColor.range);
            if (color == glm::dvec3(0)) {
                radiance->fail("this light emits nothing", "give it a radiance above 0 or leave it out");
            }
        }
        environment.image = Image(1, 1);
        environment.image.at(0, 0) = color;
    }
    double largest = 0;
    for (const glm::vec3& c : environment.image.pixels) {
        largest = std::max(largest, static_cast<double>(std::max({c.x, c.y, c.z})));
    }
    if (!(largest * environment.scale > 0)) {
        (scale ? *scale : reader.map()).fail("this light emits nothing", "give it a scale above 0 or leave it out");
    }
    if (largest * environment.scale > kLargestEmission) {
        (image ? *image : reader.map()).fail("the environment is too bright", "its radiance is " + kRadiance.text());
    }
    environment.where = reader.where();
    scene.environment = std::move(environment);
}

shared::LightRecord record(const Scene& scene, const Environment& environment, LightTable& table) {
    const Image& image = environment.image;
    shared::LightRecord r = endlessLight(scene, shared::kLightEnvironment);
    r.columns = static_cast<std::uint32_t>(image.width);
    r.rows = static_cast<std::uint32_t>(image.height);
    const double turns = environment.rotation / 360;
    r.rotation = static_cast<float>(turns - std::floor(turns));
    r.rotation = r.rotation < 1 ? r.rotation : 0;
    r.cdfs.address = table.cdfs.size() * sizeof(float);
    r.texels.address = table.texels.size() * sizeof(vec3);

    // The solid angle of a row's texel is 2 pi / columns times the difference of the cosines at the row's edges
    dvec3 integral(0);
    std::vector<double> rowWeights;
    std::vector<float> columnCdfs;
    for (int y = 0; y < image.height; ++y) {
        const double top = pi * y / image.height;
        const double bottom = pi * (y + 1) / image.height;
        const double band = 2 * std::sin((bottom - top) / 2) * std::sin((bottom + top) / 2);
        std::vector<double> weights;
        for (int x = 0; x < image.width; ++x) {
            const dvec3 radiance = dvec3(image.at(x, y)) * environment.scale;
            table.texels.emplace_back(radiance);
            weights.push_back(channelMean(radiance));
            integral += radiance * (2 * pi / image.width * band);
        }
        rowWeights.push_back(appendCdf(columnCdfs, weights) * band);
    }
    appendCdf(table.cdfs, rowWeights);
    table.cdfs.insert(table.cdfs.end(), columnCdfs.begin(), columnCdfs.end());
    r.emission = integral / (4 * pi);
    r.power = double{r.area} * integral;
    return r;
}

void addRecords(const Scene& scene, LightTable& table) {
    if (scene.environment) {
        table.add(record(scene, *scene.environment, table), scene.environment->photonShare);
    }
}

} // namespace

void checkFirstEnvironment(const Reader& reader, const Scene& scene) {
    if (scene.environment) {
        reader.map().fail("a scene has at most one environment", "remove this one or the first");
    }
}

constinit const LightKind kEnvironmentLight{
    .doc =
        {.type = "environment",
         .schemaName = "environment",
         .text =
             "An *environment* surrounds the scene; a scene has at most one. Its image is equirectangular: azimuth "
             "from left to right, the centre in direction -z, the right quarter in direction +x, +y at the upper edge. "
             "Radiance is constant over each pixel. Rays that hit nothing see it; photons and light samples are "
             "distributed by the mean of the three channels. PNG files are read as sRGB.",
         .keys = kKeys,
         .rules = R"({"not": {"required": ["image", "radiance"]}})"},
    .read = read,
    .addRecords = addRecords,
    .reference = referenceLight<reference::SurroundingLight>()};

} // namespace hyalite::kinds
