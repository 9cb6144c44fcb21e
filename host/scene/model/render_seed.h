// The seed from which both backends derive the random numbers of a picture.
#pragma once

#include "scene/model/scene.h"

#include "shaders/shared/random.h"

namespace hyalite {

[[nodiscard]] inline shared::RenderSeed renderSeed(const RenderSettings& render) {
    return shared::renderSeed(render.seed, render.sampler == RandomNumbers::Independent ? shared::kIndependentNumbers
                                                                                        : shared::kSobolNumbers);
}

} // namespace hyalite
