// A pixel's path on both sides, as the page shows it.
#pragma once

#include "live/channel.h"
#include "parity/path_comparison.h"

namespace hyalite::live {

[[nodiscard]] Json describe(const parity::RecordedPath& path, const Scene& scene);

} // namespace hyalite::live
