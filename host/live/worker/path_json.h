// A pixel's path on the device and in the reference, as the page shows it.
#pragma once

#include "live/messages/record.h"
#include "parity/path_comparison.h"

namespace hyalite::live {

[[nodiscard]] Json describe(const parity::RecordedPath& path, const Scene& scene);

} // namespace hyalite::live
