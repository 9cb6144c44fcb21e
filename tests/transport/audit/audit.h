// Asks a renderer for the balance of a random scene, and makes failing scenes smaller.
#pragma once

#include "transport/audit/draft.h"
#include "transport/rendering.h"

#include <optional>

namespace hyalite::testing {

struct Judgement {
    bool exceeds = false;
    Estimate ratio;            // mean of the balances
    std::uint32_t renders = 0; // of all views
};

// A balance is what a scene must not exceed, over its bound: on average at most 1 for a correct program.
//   Lit: flux that the walls absorb over the flux that the lights send. A wall of albedo a and area A shows the mean
//     radiance a E / pi, so that it absorbs (1 - a) E A; six pictures of whole walls give all of it.
//   Furnace, Nested: mean radiance of the picture. Walls emit 1 - a and reflect a; every line that ends at a wall
//     carries 1 if all do that arrive there, and objects only absorb. So 1 is the solution without objects and a bound
//     with them.
//   Sealed: mean radiance of the picture over 1e-30: 0.
//
// Is the expected balance above 1, plus `bias`? Two renders below the bound suffice to say no; otherwise fresh renders
// decide: Student's test that gives a false alarm with probability `level`.
[[nodiscard]] Judgement judgeBalance(const Draft& draft, const Renderer& renderer, double level);

// Do ppm and path show the same of this scene's wall? By independent renders of both; a difference below `kBias` of
// the radiance is ppm's radius.
[[nodiscard]] Judgement judgeAgreement(const Draft& draft, Backend backend, double level);

// Removes objects and lights and replaces materials by plain ones, as long as `fails`.
[[nodiscard]] Draft minimised(Draft draft, const std::function<bool(const Draft&)>& fails);

} // namespace hyalite::testing
