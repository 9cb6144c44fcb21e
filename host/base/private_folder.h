// A folder for the life of an object, that no other user of the machine can read, write or have put there beforehand.
#pragma once

#include <filesystem>

namespace hyalite {

class PrivateFolder {
public:
    PrivateFolder(); // in the system's folder for temporary files; throws Error(OutputNotWritten)
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

} // namespace hyalite
