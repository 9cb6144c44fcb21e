#include "render/film.h"

namespace hyalite::render {

Film::Film(Device& device, glm::uvec2 resolution)
    : resolution_(resolution), resolveFilm_(device.kernel("resolve_film")), sums_(device.context, pixelCount(), "film"),
      image_(device.context, pixelCount(), "image") {
    device.commands.clear(sums_.buffer());
}

Image Film::resolve(Device& device, std::uint32_t passes) const {
    const float scale = 1 / static_cast<float>(passes);
    device.commands.run(resolveFilm_, shared::ResolveFilmArguments{sums_, image_, pixelCount(), scale}, pixelCount());
    device.commands.finish();
    Image image(static_cast<int>(resolution_.x), static_cast<int>(resolution_.y));
    image.pixels = image_.read();
    return image;
}

} // namespace hyalite::render
