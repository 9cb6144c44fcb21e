// The C++ compiler's layout of the structs of shaders/shared, for comparison with the SPIR-V's.
#pragma once

#include "gpu/kernel.h"

namespace hyalite::testing {

struct HostLayout {
    std::size_t size = 0;
    std::vector<gpu::StructMember> members; // those of an inner struct as "grid.bucketMask"
};

// By the struct's name. A struct or member that a kernel uses and that is missing here fails the layout test.
[[nodiscard]] std::map<std::string, HostLayout> hostLayouts();

} // namespace hyalite::testing
