// Shapes of every kind with random sizes and transforms, and random CSG trees over them.
#pragma once

#include "scene/model/bounds.h"
#include "scene/model/quadric.h"
#include "unit/reference/support.h"

#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <string_view>

namespace hyalite::testing {

using glm::dmat4;
using glm::dvec3;
using reference::test::Random;

// Turned, stretched up to four times as much along one axis as along another, and sheared a little.
inline dmat4 randomPlacement(Random& random, double size, double spread) {
    dmat4 shear(1);
    shear[1][0] = random.between(-0.3, 0.3);
    shear[2][1] = random.between(-0.3, 0.3);
    const dvec3 stretch = size * dvec3(random.between(0.5, 2), random.between(0.5, 2), random.between(0.5, 2));
    dmat4 map = glm::translate(dmat4(1), random.inCube(spread));
    map = glm::rotate(map, random.between(0, 2 * std::numbers::pi), random.direction());
    return glm::scale(map, stretch) * shear;
}

// A quadric in its standard position, and its clip box if it needs one.
struct NamedForm {
    std::string_view name;
    QuadricForm form;
    Bounds clip = Bounds::everything();
};

inline const std::vector<NamedForm>& namedForms() {
    const Bounds box{dvec3(-2), dvec3(2)};
    static const std::vector<NamedForm> forms{
        {"ellipsoid", {.a = 1, .e = 2, .h = 4, .j = -1}},
        {"box", {.j = -1}, {{-0.5, -0.7, -0.9}, {0.8, 0.6, 1}}},
        {"cylinder", {.a = 1, .h = 1, .j = -1}, {{-1.1, -1, -1.1}, {1.1, 1, 1.1}}},
        {"cone", {.a = 1, .e = -1, .h = 1}, {{-2, -1, -2}, {2, 0, 2}}},
        {"double cone", {.a = 1, .e = -1, .h = 1}, {{-2, -1, -2}, {2, 1, 2}}},
        {"paraboloid", {.a = 1, .g = -0.5, .h = 1}, {{-2, -1, -2}, {2, 1.5, 2}}},
        {"hyperboloid of one sheet", {.a = 1, .e = -1, .h = 2, .j = -0.3}, box},
        {"hyperboloid of two sheets", {.a = 1, .e = -1, .h = 2, .j = 0.3}, box},
        {"hyperbolic paraboloid", {.a = 1, .g = -0.5, .h = -1}, box},
        {"parabolic cylinder", {.a = 1, .g = -0.5}, box},
        {"two planes", {.a = 1, .j = -0.25}, box},
        {"general",
         {.a = 1, .b = 0.4, .c = -0.3, .d = 0.1, .e = 0.7, .f = 0.2, .g = -0.2, .h = -0.5, .i = 0.3, .j = -0.4},
         box},
    };
    return forms;
}

inline Quadric quadric(const NamedForm& named, const dmat4& objectToWorld) {
    return {.form = named.form, .clip = named.clip, .capped = true, .objectToWorld = objectToWorld};
}

// One of the solids that have a formula, about as large as `size`.
inline Shape randomSolid(Random& random, double size, double spread) {
    const auto& forms = namedForms();
    const auto choice = static_cast<std::size_t>(random.between(0, static_cast<double>(forms.size()) + 2.999));
    if (choice < forms.size()) {
        return quadric(forms[choice], randomPlacement(random, 0.6 * size, spread));
    }
    if (choice == forms.size()) {
        return Sphere{random.inCube(spread), random.between(0.5, 1.5) * size};
    }
    if (choice == forms.size() + 1) {
        return Torus{.major = 1,
                     .minor = random.between(0.1, 0.6),
                     .objectToWorld = randomPlacement(random, 0.6 * size, spread)};
    }
    return Plane{random.inCube(spread), random.direction()};
}

// Appends a tree with this number of leaves to the program; the leaves are split randomly between operands, so trees
// are unbalanced.
template <class MakeLeaf>
void appendTree(Random& random, std::size_t leaves, MakeLeaf&& makeLeaf, std::vector<CsgStep>& program) {
    if (leaves == 1) {
        makeLeaf();
        program.push_back(CsgStep::Leaf);
        return;
    }
    const auto left = 1 + static_cast<std::size_t>(random.unit() * static_cast<double>(leaves - 1));
    appendTree(random, left, makeLeaf, program);
    appendTree(random, leaves - left, makeLeaf, program);
    constexpr CsgStep kOperations[] = {CsgStep::Union, CsgStep::Intersection, CsgStep::Difference};
    program.push_back(kOperations[static_cast<std::size_t>(random.unit() * 3)]);
}

} // namespace hyalite::testing
