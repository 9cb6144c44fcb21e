// Tells when files change, by looking at their times and sizes: simple, and right on every file system.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace hyalite::live {

class FileWatch {
public:
    // Every file below a folder, those that appear later too.
    void watchFolder(const std::filesystem::path& folder) { folder_ = folder; }
    void watchFiles(const std::vector<std::string>& files) { files_ = {files.begin(), files.end()}; }

    // Whether any has changed, appeared or gone since the last call; the first call says no.
    [[nodiscard]] bool hasChanged();

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };

    std::filesystem::path folder_;
    std::set<std::string> files_;
    std::map<std::string, Stamp> stamps_;
    bool looked_ = false;
};

} // namespace hyalite::live
