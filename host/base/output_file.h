// Output files that are either complete or untouched: written under a temporary name beside the final one, then
// renamed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>

namespace hyalite {

// Puts `content` into the file at `path`, replacing what was there in one step; a symbolic link is followed. On any
// failure throws Error(OutputNotWritten) and leaves the old file as it was and no temporary behind.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content);

// The same for content that is made piece by piece: `produce` hands each piece to the function that it is given.
using WriteBytes = std::function<void(std::span<const std::byte>)>;
void writeFileAtomically(const std::filesystem::path& path, const std::function<void(const WriteBytes&)>& produce);

// Throws the error that writing `path` would throw now, as far as that can be known before the content is. Called
// before a long computation, so that its result is not lost; leaves no file behind.
void checkWritable(const std::filesystem::path& path);

} // namespace hyalite
