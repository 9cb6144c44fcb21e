// Warnings about a scene or its picture: what is probably not meant, though it renders. docs/scene-format.md explains
// every kind.
#pragma once

#include "base/error.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace hyalite {

struct Scene;

enum class WarningKind : std::uint8_t {
    RepeatedFaces,
    RepeatedObject,
    BackToBack,
    OpenGlass,
    TurnedFaces,
    UnseenLight,
    UnseenCaustic,
    BlackPicture
};

struct WarningRow {
    WarningKind kind;
    std::string_view name; // in messages and in the scene file's `accept`
    std::string_view text; // Markdown, for the documentation
};

// One row per kind, in their order.
inline constexpr std::array kWarningRows{
    WarningRow{WarningKind::RepeatedFaces, "repeated-faces",
               "a mesh file lists a face twice with the same orientation; the second is left out"},
    WarningRow{WarningKind::RepeatedObject, "repeated-object",
               "an object has the shape and the place of an earlier one; it is left out if all else is equal too"},
    WarningRow{
        WarningKind::BackToBack, "back-to-back",
        "two faces that emit light, or of glass, lie back to back in one place: rounding decides which of them a "
        "ray meets"},
    WarningRow{WarningKind::OpenGlass, "open-glass",
               "a dielectric has no inside: a quad, a disk, an open shape or an open mesh"},
    WarningRow{WarningKind::TurnedFaces, "turned-faces",
               "faces of a closed mesh of glass are wound inward; they are turned where that is certain"},
    WarningRow{WarningKind::UnseenLight, "unseen-light",
               "of 1024 paths from a light none reaches what the camera sees, or an `emission` is 0"},
    WarningRow{
        WarningKind::UnseenCaustic, "unseen-caustic",
        "mirrors or glass send light to diffuse surfaces in a way that the integrator leaves out: `whitted` all, "
        "`path` that of lights without a surface (point, spot, directional)"},
    WarningRow{WarningKind::BlackPicture, "black-picture", "all pixels of the picture are 0"},
};

[[nodiscard]] constexpr std::string_view nameOf(WarningKind kind) {
    return kWarningRows[static_cast<std::size_t>(kind)].name;
}

struct Warning {
    WarningKind kind;
    SourceLocation where;
    std::string what;
    std::string hint = {};

    // The error that it becomes with --strict.
    [[nodiscard]] Error asError() const {
        return {ExitCode::BadInput, where, what + " [" + std::string(nameOf(kind)) + ']', hint};
    }
    // "file:line:column: what [kind] (hint)"
    [[nodiscard]] std::string text() const { return asError().what(); }
};

// Adds the warning to the scene's, unless the scene accepts its kind or the last one is of this kind and place.
void warn(Scene& scene, Warning warning);

} // namespace hyalite
