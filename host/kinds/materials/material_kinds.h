// The list of materials: a row for every model of shaders/shared/materials.h.
#pragma once

#include "kinds/materials/material_kind.h"

#include <array>

namespace hyalite::kinds {

#define ROW(Name, name) extern const MaterialKind k##Name##Material;
HYALITE_MODELS(ROW)
#undef ROW

#define ROW(Name, name) &k##Name##Material,
inline constexpr std::array kMaterialKinds{HYALITE_MODELS(ROW)};
#undef ROW

// The row of a kMaterial… type; nullptr for the absorber, which scene files cannot name.
[[nodiscard]] constexpr const MaterialKind* materialKind(std::uint32_t type) {
    switch (type) {
#define ROW(Name, name)                                                                                                \
    case shared::kMaterial##Name:                                                                                      \
        return &k##Name##Material;
        HYALITE_MODELS(ROW)
#undef ROW
    default:
        return nullptr;
    }
}

} // namespace hyalite::kinds
