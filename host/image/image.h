// A picture in memory: linear RGB radiance, row 0 on top.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace hyalite {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels; // width * height, row by row, linear RGB [W/(m^2 sr)]

    Image() = default;
    Image(int w, int h) : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

    [[nodiscard]] glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
    [[nodiscard]] const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

} // namespace hyalite
