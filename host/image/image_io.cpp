// Pictures in files: chooses the format, checks what goes in and out, and leaves the bytes to png.cpp and exr.cpp.
#include "image/image_io.h"

#include "base/error.h"
#include "base/output_file.h"
#include "image/exr.h"
#include "image/png.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <set>
#include <vector>

namespace hyalite {
namespace {

enum class Format { Png, Exr };

Format formatOf(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".png") {
        return Format::Png;
    }
    if (extension == ".exr") {
        return Format::Exr;
    }
    throw Error(ExitCode::WrongUsage, SourceLocation{path.string()},
                extension.empty() ? "no file type given" : "unknown file type '" + extension + "'",
                "pictures are written as .png or .exr");
}

bool isFinite(const glm::vec3& pixel) {
    return std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z);
}

[[noreturn]] void throwNotWritten(const std::filesystem::path& path, const std::string& what,
                                  const std::string& hint = {}) {
    throw Error(ExitCode::OutputNotWritten, SourceLocation{path.string()}, "cannot write the picture: " + what, hint);
}

void checkImage(const std::filesystem::path& path, const Layer& layer) {
    const Image& image = layer.image;
    const std::string name = layer.name.empty() ? "it" : "layer '" + layer.name + "'";
    if (image.width < 1 || image.height < 1) {
        throwNotWritten(path, name + " has no pixels");
    }
    const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.width > kMaxImageSide || image.height > kMaxImageSide || pixels > kMaxImagePixels) {
        throwNotWritten(path, name + " is too large");
    }
    if (image.pixels.size() != pixels) {
        throwNotWritten(path, name + " has " + std::to_string(image.pixels.size()) +
                                  " pixels where its size asks for " + std::to_string(pixels));
    }
    const auto bad = std::ranges::find_if_not(image.pixels, isFinite);
    if (bad != image.pixels.end()) {
        const auto index = static_cast<std::size_t>(bad - image.pixels.begin());
        const auto width = static_cast<std::size_t>(image.width);
        throwNotWritten(path,
                        std::to_string(countNotFinite(image)) + " pixels of " + name +
                            " are NaN or infinite, the first at (" + std::to_string(index % width) + ", " +
                            std::to_string(index / width) + ")",
                        "this is a fault of the program: please report it with the scene");
    }
}

void checkLayers(const std::filesystem::path& path, std::span<const Layer> layers) {
    std::set<std::string> names;
    for (const Layer& layer : layers) {
        checkImage(path, layer);
        if (layer.image.width != layers.front().image.width || layer.image.height != layers.front().image.height) {
            throwNotWritten(path, "layer '" + layer.name + "' differs in size from the first");
        }
        if (!names.insert(layer.name).second) {
            throwNotWritten(path, "two layers are named '" + layer.name + "'");
        }
    }
    if (!names.contains("")) {
        throwNotWritten(path, "no layer is the picture itself");
    }
}

std::vector<std::byte> encode(const std::filesystem::path& path, Format format, std::span<const Layer> layers,
                              const Metadata& metadata) {
    try {
        if (format == Format::Exr) {
            return encodeExr(layers, metadata);
        }
        return encodePng(std::ranges::find(layers, std::string(), &Layer::name)->image);
    } catch (const std::exception& failure) {
        throwNotWritten(path, failure.what());
    }
}

std::vector<std::byte> readFile(const std::filesystem::path& path) {
    const auto fail = [&path](const std::string& what, const std::string& hint = {}) {
        throw Error(ExitCode::BadInput, SourceLocation{path.string()}, "cannot read the picture: " + what, hint);
    };
    std::error_code failure;
    const std::filesystem::file_status status = std::filesystem::status(path, failure);
    if (!std::filesystem::exists(status)) {
        fail(failure ? failure.message() : "no such file");
    }
    if (!std::filesystem::is_regular_file(status)) {
        fail("it is not a file", "give the name of a .png or .exr file");
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        fail("it cannot be opened", "check its permissions");
    }
    std::vector<std::byte> content(std::filesystem::file_size(path));
    stream.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
    if (stream.bad() || static_cast<std::size_t>(stream.gcount()) != content.size()) {
        fail("unexpected end of file");
    }
    return content;
}

} // namespace

std::size_t countNotFinite(const Image& image) {
    return image.pixels.size() - static_cast<std::size_t>(std::ranges::count_if(image.pixels, isFinite));
}

void writeImage(const std::filesystem::path& path, std::span<const Layer> layers, const Metadata& metadata) {
    const Format format = formatOf(path);
    checkLayers(path, layers);
    writeFileAtomically(path, encode(path, format, layers, metadata));
}

void writeImage(const std::filesystem::path& path, const Image& image, const Metadata& metadata) {
    const Layer layer{"", image};
    writeImage(path, std::span(&layer, 1), metadata);
}

void checkImageWritable(const std::filesystem::path& path) {
    static_cast<void>(formatOf(path));
    checkWritable(path);
}

Image readImage(const std::filesystem::path& path) {
    const std::vector<std::byte> file = readFile(path);
    if (looksLikePng(file)) {
        return decodePng(file, path.string());
    }
    if (looksLikeExr(file)) {
        return decodeExr(file, path.string());
    }
    throw Error(ExitCode::BadInput, SourceLocation{path.string()},
                file.empty() ? "the file is empty" : "this is neither a PNG nor an EXR file");
}

} // namespace hyalite
