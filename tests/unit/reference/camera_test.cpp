// The thin lens against the formulas of optics.
#include "reference/camera/camera.h"

#include "reference/world.h"
#include "unit/reference/support.h"

#include <algorithm>

using namespace hyalite;
using namespace hyalite::reference;
using namespace hyalite::reference::test;

namespace {

// A camera at the origin that looks along -z; its focus is 2 m away, its lens 0.2 m wide.
Scene lensScene() {
    Scene scene = onePixel({0, 0, 0}, {0, 0, -1}, "ppm");
    scene.camera.fov = 40;
    scene.camera.aperture = 0.2;
    scene.camera.focusDistance = 2;
    addObject(scene, Quad{{0, 0, -9}, {1, 0, 0}, {0, 1, 0}}, std::nullopt, dvec3(1));
    return scene;
}

// Where a ray passes the plane z = -depth.
dvec2 passage(const Ray& ray, double depth) {
    const double t = (-depth - ray.origin.z) / ray.direction.z;
    return ray.origin + t * ray.direction;
}

} // namespace

TEST_CASE("a ray through the lens meets the central ray in the plane of focus") {
    Scene scene = lensScene();
    const World lens = prepareWorld(scene);
    scene.camera.aperture = 0;
    const World pinhole = prepareWorld(scene);
    for (std::uint32_t pass = 0; pass < 1000; ++pass) {
        const Ray ray = generateCameraRay(lens, 0, pass);
        const Ray middle = generateCameraRay(pinhole, 0, pass);
        CHECK(glm::length(passage(ray, 2) - passage(middle, 2)) < 1e-15);
        CHECK(ray.origin.z == 0);
        CHECK(glm::length(ray.origin) <= 0.1);
    }
}

TEST_CASE("away from the focus a point becomes a disc, as wide as the lens seen from there") {
    // Similar triangles with their common corner in focus at distance s: at distance z the bundle through a lens of
    // radius R is R |z - s| / s wide, and filled as evenly as the lens: the mean square of a disc's radius is half its
    // largest.
    Scene scene = lensScene();
    const World lens = prepareWorld(scene);
    scene.camera.aperture = 0;
    const World pinhole = prepareWorld(scene);
    for (const double depth : {1.0, 3.0, 8.0}) {
        const double expected = 0.1 * std::abs(depth - 2) / 2;
        double largest = 0;
        double squares = 0;
        constexpr std::uint32_t count = 4096;
        for (std::uint32_t pass = 0; pass < count; ++pass) {
            const double off = glm::length(passage(generateCameraRay(lens, 0, pass), depth) -
                                           passage(generateCameraRay(pinhole, 0, pass), depth));
            largest = std::max(largest, off);
            squares += off * off;
        }
        CHECK(largest <= expected * (1 + 1e-12));
        CHECK(largest > 0.999 * expected); // of 4096 even points one falls into the outer 0.2 % of the area
        CHECK_THAT(squares / count,
                   WithinRel(expected * expected / 2, 1e-3)); // stratified: error far below 1/sqrt(4096)
    }
}

TEST_CASE("without a focus distance the camera focuses on look_at") {
    Scene scene = lensScene();
    scene.camera.focusDistance = 0;
    scene.camera.lookAt = {0, 0, -3};
    CHECK(prepareWorld(scene).camera.focusDistance == 3);
}
