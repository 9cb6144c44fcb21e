// A picture from the device against the reference's.
#pragma once

#include "image/image_io.h"
#include "image/metrics.h"
#include "render/integrators/registry.h"
#include "render/renderer.h"
#include "support/gpu_fixture.h"

#include <catch2/catch_test_macros.hpp>
#include <string>

namespace hyalite::testing {

inline Image onDevice(const Scene& scene) {
    return render::render(Gpu::shared().context(), Gpu::shared().compiler(), scene, {}).image.picture;
}

// At least `share` of the pixels agree within 1 %. Where fewer do, both pictures are left in the working folder.
inline void comparePictures(const std::string& name, const Scene& scene, double share) {
    const Image device = onDevice(scene);
    const Image expected = render::renderByReference(scene).picture;
    const Crop all = wholeOf(expected);
    REQUIRE(countNotFinite(device) == 0);
    const double within = shareWithin(device, expected, 0.01, all);
    if (within < share) {
        writeImage(name + "-device.exr", device, {});
        writeImage(name + "-reference.exr", expected, {});
    }
    INFO(name << ": share within 1 % " << within << ", relMSE " << relMse(device, expected, all));
    CHECK(within >= share);
    CHECK(relMse(device, expected, all) < 1e-3);
}

} // namespace hyalite::testing
