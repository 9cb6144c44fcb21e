// Every mistake in a shape, with its place: the dollar sign in the text.
#include "unit/scene/bad_scene.h"

using namespace hyalite;
using namespace hyalite::test;

namespace {

std::string with(const std::string& shape, const std::string& transform = "[]") {
    return withObject("{material: gray, transform: " + transform + ", shape: " + shape + "}");
}

} // namespace

TEST_CASE("mistakes in boxes are reported at the key") {
    checkAll({
        {with("${type: box, max: [1, 1, 1]}"), "missing key 'min'"},
        {with("${type: box, min: [1, 1, 1]}"), "missing key 'max'"},
        {with("{type: box, min: [0, 0, 0], max: $[1, 0, 1]}"), "'max' must be above that of 'min'"},
        {with("{type: box, min: [0, 0, 0], max: $[1, 1, -1]}"), "'max' must be above that of 'min'"},
        {with("{type: box, min: [0, 0, $null], max: [1, 1, 1]}"), "must be a number, found nothing"},
        {with("{type: box, min: [0, 0, 0], max: [1, $1e10, 1]}"), "[-1e+09, 1e+09] m"},
        {with("{type: box, min: [0, 0, 0], max: [1, 1, 1], $clip: 1}"), "unknown key 'clip'"},
    });
}

TEST_CASE("mistakes in cylinders and cones are reported at the key") {
    checkAll({
        {with("${type: cylinder, base: [0, 0, 0], radius: 1}"), "missing key 'top'"},
        {with("{type: cylinder, base: [0, 1, 0], top: $[0, 1, 0], radius: 1}"), "'top' and 'base' are the same point"},
        {with("{type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: $0}"), "'radius' must be in [1e-09, 1e+09] m"},
        {with("{type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 1, open: $1}"),
         "'open' must be true or false, found 1"},
        {with("{type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 1, open: $'true'}"), "true or false"},
        {with("{type: cylinder, base: [0, 0, 0], top: [0, 1, 0], radius: 1, $caps: false}"), "unknown key 'caps'"},
        {with("{type: cone, base: [0, 1, 0], top: $[0, 1, 0], radius: 1}"), "'top' and 'base' are the same point"},
        {with("{type: cone, base: [0, 0, 0], top: [0, 1, 0], radius: $0}"), "one of 'radius' and 'top_radius'"},
        {with("{type: cone, base: [0, 0, 0], top: [0, 1, 0], radius: $-1}"), "'radius' must be in [0, 1e+09] m"},
        {with("{type: cone, base: [0, 0, 0], top: [0, 1, 0], radius: 1, top_radius: $-1}"), "found -1"},
        {with("{type: cone, base: [0, 0, 0], top: [0, 1, 0], radius: 1, $topradius: 1}"), "unknown key 'topradius'",
         "did you mean 'top_radius'?"},
    });
}

TEST_CASE("mistakes in tori, planes and disks are reported at the key") {
    checkAll({
        {with("${type: torus, minor: 1}"), "missing key 'major'"},
        {with("{type: torus, major: 1, minor: $1}"), "'minor' must be less than 'major', 1 m",
         "the tube would intersect the axis"},
        {with("{type: torus, major: 1, minor: $2}"), "'minor' must be less than 'major'"},
        {with("{type: torus, major: 1, minor: $0}"), "'minor' must be in [1e-09, 1e+09] m"},
        {with("{type: torus, major: 1, minor: 0.5, axis: $[0, 0, 0]}"), "'axis' must not be zero"},
        {with("${type: plane, point: [0, 0, 0]}"), "missing key 'normal'"},
        {with("{type: plane, point: [0, 0, 0], normal: $[0, 0, 0]}"), "'normal' must not be zero"},
        {with("${type: plane, normal: [0, 1, 0]}"), "missing key 'point'"},
        {with("{type: disk, normal: $[0, 0, 0], radius: 1}"), "'normal' must not be zero"},
        {with("{type: disk, normal: [0, 1, 0], radius: $0}"), "'radius' must be in"},
        {with("${type: disk, normal: [0, 1, 0]}"), "missing key 'radius'"},
    });
}

TEST_CASE("mistakes in named quadrics are reported at the key") {
    checkAll({
        {with("${type: ellipsoid}"), "missing key 'radii'"},
        {with("{type: ellipsoid, radii: [1, $0, 1]}"), "'radii' must be in [1e-09, 1e+09] m, found 0"},
        {with("{type: ellipsoid, radii: $2}"), "'radii' must be a list of 3 numbers"},
        {with("{type: paraboloid, radii: [1, $-1, 1]}"), "found -1"},
        {with("{type: paraboloid, radii: [1, 1, 1], axis: $[0, 0, 0]}"), "'axis' must not be zero"},
        {with("{type: $hyperboloid, radii: [1, 1, 1]}"), "unknown shape 'hyperboloid'"},
        {with("{type: paraboloid, radii: [1, 1, 1], $radius: 1}"), "unknown key 'radius'", "did you mean 'radii'?"},
    });
}

TEST_CASE("mistakes in the coefficients of a quadric are reported there") {
    checkAll({
        {with("${type: quadric}"), "missing key 'coefficients'"},
        {with("{type: quadric, coefficients: $[1, 2, 3]}"), "a list of 10 numbers, found a list of 3"},
        {with("{type: quadric, coefficients: [1, 0, 0, 0, $.inf, 0, 0, 1, 0, -1]}"), "a finite number"},
        {with("{type: quadric, coefficients: [1, 0, 0, 0, $1e31, 0, 0, 1, 0, -1]}"), "in [-1e+30, 1e+30]"},
        {with("{type: quadric, coefficients: $[0, 0, 0, 0, 0, 0, 0, 0, 0, 0]}"), "all coefficients"},
        {with("{type: quadric, coefficients: $[0, 0, 0, 0, 0, 0, 0, 0, 0, 0], clip: {min: [0, 0, 0]}}"),
         "all coefficients"},
        {with("{type: quadric, coefficients: $[0, 0, 0, 0, 0, 0, 0, 0, 0, -1]}"), "only the last coefficient is not 0",
         "within a 'clip' makes a box"},
        {with("{type: quadric, coefficients: $[0, 0, 0, 0, 0, 0, 0, 0, 0, 1], clip: {min: [0, 0, 0], max: [1, 1, 1]}}"),
         "only the last coefficient is not 0"},
        // x^2 + y^2 + z^2 + 1 is above 0 everywhere, x^2 nowhere below it, and -x^2 - 1 never reaches it.
        {with("{type: quadric, coefficients: $[1, 0, 0, 0, 1, 0, 0, 1, 0, 1]}"), "no inside: q is nowhere below 0"},
        {with("{type: quadric, coefficients: $[1, 0, 0, 0, 0, 0, 0, 0, 0, 0]}"), "no inside: q is nowhere below 0"},
        {with("{type: quadric, coefficients: $[-1, 0, 0, 0, 0, 0, 0, 0, 0, -1]}"),
         "no surface: q is below 0 everywhere", "'clip'"},
    });
}

TEST_CASE("mistakes in clip boxes are reported at the key") {
    const auto ball = [](const std::string& rest) { return with("{type: ellipsoid, radii: [1, 1, 1], " + rest + "}"); };
    checkAll({
        {ball("clip: $5"), "'clip' must be a map"},
        {ball("clip: ${}"), "this clip box has no side"},
        {ball("clip: ${min: [null, null, null]}"), "this clip box has no side", "not null"},
        {ball("clip: {min: $[0, 0]}"), "'min' must be a list of 3"},
        {ball("clip: {min: [0, 0, $.inf]}"), "a finite number"},
        {ball("clip: {min: [0, 0, $none]}"), "must be a number"},
        {ball("clip: {$mim: [0, 0, 0]}"), "unknown key 'mim'", "did you mean 'min'?"},
        {ball("clip: {min: [0, 0, 0], max: $[1, 0, 1]}"), "'max' must be above that of 'min'"},
        {ball("clip: {min: [null, 0.5, 0], max: $[null, -0.5, null]}"), "'max' must be above that of 'min'"},
        {ball("clip: ${min: [2, null, null]}"), "no inside within its clip box"},
        // Touching at one point is not holding anything.
        {ball("clip: ${min: [1, null, null]}"), "no inside within its clip box"},
        // Near a corner of the box around it, where the ball does not reach: 3 * 0.8^2 > 1.
        {ball("clip: ${min: [0.8, 0.8, 0.8]}"), "no inside within its clip box"},
        // Within the ball, capped faces are a box, and without them nothing is to be seen.
        {ball("clip: ${min: [-0.1, -0.1, -0.1], max: [0.1, 0.1, 0.1]}, caps: false"), "no surface within its clip box"},
        {ball("caps: $true"), "'caps' needs a clip box", "add a 'clip'"},
        {ball("clip: {min: [0, 0, 0]}, caps: $maybe"), "'caps' must be true or false"},
        {with("{type: hyperboloid_two_sheets, radii: [1, 1, 1], clip: ${min: [null, -0.5, null], "
              "max: [null, 0.5, null]}}"),
         "no inside within its clip box"},
        {with("{type: quadric, coefficients: [0, 0, 0, 0, 0, 0, 0, 0, 0, -1], clip: ${max: [1, 1, 1]}, caps: false}"),
         "no surface within its clip box"},
    });
}

TEST_CASE("a capped box within a solid is a box") {
    const Scene scene = loadWithShape("{type: ellipsoid, radii: [1, 1, 1], clip: {min: [-0.1, -0.1, -0.1], "
                                      "max: [0.1, 0.1, 0.1]}}");
    CHECK(std::get<Quadric>(scene.objects.at(0).shape).capped);
}

TEST_CASE("transforms that leave a shape too thin or too far away are reported") {
    checkAll({
        {with("{type: sphere, radius: 1e-3}", "$[{scale: 1e-7}]"), "the shape is only 1e-10 m thick", "1e-09 m"},
        {with("{type: sphere, radius: 1e-3}", "$[{scale: [1, 1e-7, 1]}]"), "m thick"},
        {with("{type: box, min: [0, 0, 0], max: [1, 1e-6, 1]}", "$[{scale: 1e-4}]"), "m thick"},
        {with("{type: cylinder, base: [0, 0, 0], top: [0, 1e-6, 0], radius: 1}", "$[{scale: 1e-4}]"), "m thick"},
        {with("{type: cone, base: [0, 0, 0], top: [0, 1, 0], radius: 1e-6}", "$[{scale: 1e-4}]"), "m thick"},
        {with("{type: torus, major: 1, minor: 1e-6}", "$[{scale: 1e-4}]"), "m thick"},
        {with("{type: ellipsoid, radii: [1, 1e-6, 1]}", "$[{scale: 1e-4}]"), "m thick"},
        {with("${type: sphere, radius: 1, center: [9e8, 0, 0]}", "[{scale: [2, 1, 1]}]"), "extends beyond 1e+09 m"},
        {with("${type: box, min: [0, 0, 0], max: [1, 1, 1]}", "[{scale: 1e9}, {translate: [5, 0, 0]}]"),
         "extends beyond 1e+09 m"},
        {with("${type: torus, major: 9e8, minor: 2e8}"), "extends beyond 1e+09 m"},
        {with("${type: disk, center: [9e8, 0, 0], normal: [0, 1, 0], radius: 2e8}"), "extends beyond 1e+09 m"},
        {with("${type: plane, point: [9e8, 0, 0], normal: [0, 1, 0]}", "[{scale: 2}]"), "extends beyond 1e+09 m"},
        {with("${type: ellipsoid, center: [9e8, 0, 0], radii: [2e8, 1, 1]}"), "extends beyond 1e+09 m"},
        {with("${type: cylinder, base: [9e8, 0, 0], top: [9e8, 1, 0], radius: 2e8}"), "extends beyond 1e+09 m"},
        {with("{type: disk, normal: [0, 1, 0], radius: 1e-3}", "$[{scale: 1e-7}]"), "flattens the disk"},
    });
}

TEST_CASE("the smallest shapes are accepted, turned or not") {
    CHECK(loadWithShape("{type: sphere, radius: 1e-9}").objects.size() == 1);
    CHECK(loadWithShape("{type: sphere, radius: 1e-9}", "[{rotate: {axis: [1, 2, 3], degrees: 77}}]").objects.size() ==
          1);
    CHECK(loadWithShape("{type: sphere, radius: 1e-9}", "[{scale: [1, 2, 3]}]").objects.size() == 1);
}

TEST_CASE("mistakes in repetitions are reported at the key") {
    const auto repeated = [](const std::string& repeat) {
        return withObject("{material: gray, shape: {type: sphere, radius: 1}, repeat: " + repeat + "}");
    };
    checkAll({
        {repeated("$3"), "must be a list"},
        {repeated("[${count: 3}]"), "missing key 'transform'"},
        {repeated("[${transform: []}]"), "missing key 'count'"},
        {repeated("[{count: $0, transform: []}]"), "'count' must be in [1, 4194304]"},
        {repeated("[{count: 2, transform: [{scale: $0}]}]"), "singular"},
        {repeated("[{count: 4000, transform: []}, ${count: 4000, transform: []}]"), "more than 4194304 copies"},
        {repeated("[{count: 2, transform: [], $times: 3}]"), "unknown key 'times'"},
    });
}
