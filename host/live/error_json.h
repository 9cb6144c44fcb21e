// An error as the page shows it, with the lines of the source about it.
#pragma once

#include "base/error.h"
#include "live/channel.h"

namespace hyalite::live {

// `source`: scene, setting, kernel or worker.
[[nodiscard]] Json describe(const Error& error, const std::string& source);

} // namespace hyalite::live
