// The keys `clip` and `caps` that all quadrics share: an optional box that cuts the shape, and whether its faces close
// it.
#pragma once

#include "kinds/shapes/shape_kind.h"
#include "scene/model/scene.h"
#include "scene/yaml/read_placement.h"

namespace hyalite::kinds {

inline constexpr KeyDoc kClip{.name = "clip",
                              .type = KeyType::Other,
                              .defaultText = "none",
                              .text = "box that cuts the shape, in object space: see [clip and caps](#clip-and-caps)",
                              .schema = R"({"$ref": "#/$defs/clip"})",
                              .typeText = "map"};
inline constexpr KeyDoc kCaps{.name = "caps",
                              .type = KeyType::Flag,
                              .defaultText = "true",
                              .text = "whether the clip box's faces close the shape; only with `clip`"};
inline constexpr std::string_view kCapsNeedClip = R"({"dependentRequired": {"caps": ["clip"]}})";

// Reads these two keys and applies them to the quadric; `written` is the place of its form. Throws Error(BadInput).
[[nodiscard]] Shape clipped(Reader& reader, const Value& written, Quadric quadric);

} // namespace hyalite::kinds
