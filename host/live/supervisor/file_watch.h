// Reports when files change, by polling their times and sizes: simple, and right on every file system. To be used from
// one thread.
#pragma once

#include "live/messages/file_stamp.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace hyalite::live {

class FileWatch {
public:
    // Watches every file below the folder, present and future.
    explicit FileWatch(std::filesystem::path folder);

    // Watches these files, by path.
    explicit FileWatch(const std::map<std::string, FileStamp>& files);

    // Watches these files from now on, instead of those before. A file that was watched before is compared with what
    // hasChanged() last saw of it, a new one with the stamp given here: so no save is lost between the time when
    // somebody read the files and this call.
    void watch(const std::map<std::string, FileStamp>& files);

    // Whether any file has changed, appeared or vanished since the last call that said so, or since it is watched.
    [[nodiscard]] bool hasChanged();

private:
    [[nodiscard]] std::map<std::string, std::optional<FileStamp>> look() const;

    std::filesystem::path folder_;                           // empty: single files are watched
    std::map<std::string, std::optional<FileStamp>> stamps_; // by path; nothing: the file does not exist
};

} // namespace hyalite::live
