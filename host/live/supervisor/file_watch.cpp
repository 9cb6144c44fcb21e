#include "live/supervisor/file_watch.h"

#include <system_error>

namespace hyalite::live {

namespace fs = std::filesystem;

FileWatch::FileWatch(fs::path folder) : folder_(std::move(folder)), stamps_(look()) {}

FileWatch::FileWatch(const std::map<std::string, FileStamp>& files) : stamps_(files.begin(), files.end()) {}

void FileWatch::watch(const std::map<std::string, FileStamp>& files) {
    std::map<std::string, std::optional<FileStamp>> stamps(files.begin(), files.end());
    for (auto& [path, stamp] : stamps) {
        if (const auto known = stamps_.find(path); known != stamps_.end()) {
            stamp = known->second;
        }
    }
    stamps_ = std::move(stamps);
}

std::map<std::string, std::optional<FileStamp>> FileWatch::look() const {
    std::map<std::string, std::optional<FileStamp>> now;
    if (folder_.empty()) {
        for (const auto& [path, stamp] : stamps_) {
            now[path] = stampOf(path);
        }
        return now;
    }
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder_, error); !error && entry != fs::recursive_directory_iterator();
         entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored)) {
            now[entry->path().string()] = stampOf(entry->path());
        }
    }
    return now;
}

bool FileWatch::hasChanged() {
    auto now = look();
    const bool changed = now != stamps_;
    stamps_ = std::move(now);
    return changed;
}

} // namespace hyalite::live
