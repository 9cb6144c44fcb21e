// The hint in every error about a driver.
#pragma once

namespace hyalite::gpu {

inline constexpr const char* kInstallDriverHint =
    "install Mesa 25 or newer (package mesa-vulkan-drivers; on Debian 12 from its backports suite); "
    "scripts/install-deps.sh does it";

} // namespace hyalite::gpu
