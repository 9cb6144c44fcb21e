// What surfaces of second degree share: the box that may cut them, whose faces may close them.
#pragma once

#include "kinds/shapes/shape_kind.h"
#include "scene/model/scene.h"
#include "scene/yaml/read_placement.h"

namespace hyalite::kinds {

inline constexpr KeyDoc kClip{
    .name = "clip",
    .type = KeyType::Other,
    .defaultText = "none",
    .text = "box that cuts the shape, in the shape's own space: see [clip and caps](#clip-and-caps)",
    .schema = R"({"$ref": "#/$defs/clip"})",
    .typeText = "map"};
inline constexpr KeyDoc kCaps{.name = "caps",
                              .type = KeyType::Flag,
                              .defaultText = "true",
                              .text = "whether the clip box's faces close the shape; only with `clip`"};
inline constexpr std::string_view kCapsNeedClip = R"({"dependentRequired": {"caps": ["clip"]}})";

// Reads these two keys around the form that is the shape's own; `written` is where the form stands. Throws
// Error(BadInput).
[[nodiscard]] Shape clipped(Reader& reader, const Value& written, Quadric quadric);

} // namespace hyalite::kinds
