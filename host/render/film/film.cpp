#include "render/film/film.h"

#include "shaders/shared/limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hyalite::render {

namespace {

// Number of faults and their lowest pixel; at first none.
constexpr glm::uvec2 kNoFault{0, shared::kNone};

} // namespace

Film::Film(Device& device, glm::uvec2 resolution, std::vector<LayerKind> layers)
    : resolution_(resolution), layers_(std::move(layers)), accumulateFilm_(device.kernel("accumulate_film")),
      resolveFilm_(device.kernel("resolve_film")), estimateError_(device.kernel("estimate_error")),
      image_(device.context, pixelCount(), "image"),
      errorSums_(device.context, (pixelCount() + shared::kErrorChunk - 1) / shared::kErrorChunk, "sums of errors"),
      darkCounts_(device.context, errorSums_.count(), "counts of black pixels"),
      sought_(device.context, pixelCount(), "pixels where light was sought") {
    device.commands.clear(sought_.buffer());
    for (auto& sums : sums_) {
        sums = {device.context, layers_.size() * pixelCount(), "film"};
        device.commands.clear(sums.buffer());
    }
    faults_.resize(layers_.size() * shared::kFilmFaults);
    passFaults_ = {device.context, faults_.size(), "faults of the film", gpu::Memory::Host};
    std::ranges::fill(passFaults_.host(), kNoFault);
}

void Film::endPass() {
    const std::span<glm::uvec2> found = passFaults_.host();
    for (std::size_t i = 0; i < found.size(); ++i) {
        addFault(faults_[i], {found[i].x, pass_, found[i].y});
    }
    std::ranges::fill(found, kNoFault);
    passes_.add({pass_, pass_ + 1});
}

shared::FilmArray Film::sums(std::size_t sequence, std::size_t layer) const {
    return {sums_.at(sequence).buffer().address() + layer * pixelCount() * sizeof(shared::FilmColor)};
}

void Film::add(Device& device, std::size_t layer, const gpu::Array<glm::vec3>& colors) {
    const shared::UintArray faults{passFaults_.buffer().address() + layer * shared::kFilmFaults * sizeof(glm::uvec2)};
    device.commands.run(accumulateFilm_,
                        shared::AccumulateFilmArguments{.colors = colors,
                                                        .film = sums(pass_ % shared::kCameraSequences, layer),
                                                        .faults = faults,
                                                        .count = pixelCount()},
                        pixelCount());
}

LayeredImage Film::resolve(Device& device) {
    const auto read = [&] {
        Image image(static_cast<int>(resolution_.x), static_cast<int>(resolution_.y));
        image.pixels = image_.read();
        return image;
    };
    const float scale = 1 / static_cast<float>(passes_.count());
    std::vector<Image> images;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        device.commands.run(resolveFilm_,
                            shared::ResolveFilmArguments{.first = sums(0, layer),
                                                         .second = sums(1, layer),
                                                         .image = image_,
                                                         .count = pixelCount(),
                                                         .scale = scale},
                            pixelCount());
        device.commands.finish();
        images.push_back(read());
    }
    LayeredImage result = compose(layers_, std::move(images));
    static_cast<void>(estimateError(device));
    if (passes_.count(0) > 0 && passes_.count(1) > 0) {
        result.error = read();
    }
    return result;
}

ErrorEstimate Film::estimateError(Device& device) {
    const std::uint32_t first = passes_.count(0);
    const std::uint32_t second = passes_.count(1);
    if (first == 0 || second == 0) {
        return {};
    }
    std::uint32_t light = 0;
    for (std::size_t layer = 0; layer < layers_.size(); ++layer) {
        light |= layers_[layer].isLight ? 1U << layer : 0U;
    }
    device.commands.run(estimateError_,
                        shared::EstimateErrorArguments{.first = sums_[0],
                                                       .second = sums_[1],
                                                       .sought = sought_,
                                                       .errors = image_,
                                                       .sums = errorSums_,
                                                       .dark = darkCounts_,
                                                       .count = pixelCount(),
                                                       .firstPasses = static_cast<float>(first),
                                                       .secondPasses = static_cast<float>(second),
                                                       .layers = static_cast<std::uint32_t>(layers_.size()),
                                                       .light = light},
                        static_cast<std::uint32_t>(errorSums_.count()));
    device.commands.finish();
    double sum = 0;
    for (const float chunk : errorSums_.read()) {
        sum += chunk;
    }
    glm::uvec2 dark(0);
    for (const glm::uvec2& chunk : darkCounts_.read()) {
        dark += chunk;
    }
    ErrorEstimate estimate{.darkPixels = dark.y};
    if (dark.x < pixelCount()) {
        estimate.error = std::sqrt(sum / (3.0 * pixelCount()));
    }
    return estimate;
}

FilmState Film::state() const {
    return {resolution_, layers_, passes_, faults_, {sums_[0].read(), sums_[1].read()}, sought_.read()};
}

void Film::restore(Device& device, const FilmState& state) {
    device.commands.finish(); // waits until the sums are cleared
    for (std::size_t sequence = 0; sequence < sums_.size(); ++sequence) {
        sums_.at(sequence).write(state.sums.at(sequence));
    }
    sought_.write(state.sought);
    passes_ = state.passes;
    faults_ = state.faults;
}

} // namespace hyalite::render
