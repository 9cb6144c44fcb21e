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

enum class WarningKind : std::uint8_t { BlackPicture };

struct WarningRow {
    WarningKind kind;
    std::string_view name; // in messages and in the scene file's `accept`
    std::string_view text; // Markdown, for the documentation
};

// One row per kind, in their order.
inline constexpr std::array kWarningRows{
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

// Adds the warning to the scene's, unless the scene accepts its kind.
void warn(Scene& scene, Warning warning);

} // namespace hyalite
