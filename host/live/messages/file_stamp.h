// The state of a file on disk, as far as a watch needs it: when it was written last, and how long it is.
#pragma once

#include "live/messages/record.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace hyalite::live {

struct FileStamp {
    std::int64_t time = 0; // of the last write, in ticks of the file clock
    std::uint64_t size = 0;

    bool operator==(const FileStamp&) const = default;
    static void fields(auto& self, auto&& field) {
        field("time", self.time);
        field("size", self.size);
    }
};

// Nothing where the file does not exist.
[[nodiscard]] inline std::optional<FileStamp> stampOf(const std::filesystem::path& file) {
    std::error_code error;
    const auto time = std::filesystem::last_write_time(file, error);
    const auto size = error ? 0 : std::filesystem::file_size(file, error);
    return error ? std::nullopt : std::optional(FileStamp{time.time_since_epoch().count(), size});
}

} // namespace hyalite::live
