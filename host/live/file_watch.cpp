#include "live/file_watch.h"

#include <system_error>

namespace hyalite::live {

bool FileWatch::hasChanged() {
    namespace fs = std::filesystem;
    std::map<std::string, Stamp> now;
    const auto look = [&](const fs::path& file) {
        std::error_code error;
        const Stamp stamp{fs::last_write_time(file, error), fs::file_size(file, error)};
        if (!error) {
            now[file.string()] = stamp;
        }
    };
    std::error_code error;
    if (!folder_.empty()) {
        for (fs::recursive_directory_iterator entry(folder_, error);
             !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
            std::error_code ignored;
            if (entry->is_regular_file(ignored)) {
                look(entry->path());
            }
        }
    }
    for (const std::string& file : files_) {
        look(file);
    }
    const bool changed = looked_ && now != stamps_;
    stamps_ = std::move(now);
    looked_ = true;
    return changed;
}

} // namespace hyalite::live
