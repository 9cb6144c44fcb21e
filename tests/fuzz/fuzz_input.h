// Shared by the fuzzers. For any bytes, a reader must return or throw hyalite::Error of bad input.
#pragma once

#include "base/error.h"
#include "base/fnv.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace hyalite::fuzz {

// Any other exception ends the program and is thereby found.
template <class Read>
int expectAnswer(const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        if (error.code() != ExitCode::BadInput) {
            std::abort();
        }
    }
    return 0;
}

inline std::string_view text(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

// The bytes followed by their checksum, for files that end with one: otherwise no fuzzer would get past it.
inline std::vector<std::byte> withChecksum(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    std::vector<std::byte> file(bytes.begin(), bytes.end());
    const std::array checksum{fnv(bytes)};
    const auto end = std::as_bytes(std::span(checksum));
    file.insert(file.end(), end.begin(), end.end());
    return file;
}

// A file rewritten for each input, in a folder of this process.
class InputFile {
public:
    explicit InputFile(const std::string& name) {
        std::string folder = (std::filesystem::temp_directory_path() / "hyalite-fuzz-XXXXXX").string();
        if (::mkdtemp(folder.data()) == nullptr) {
            std::abort();
        }
        path_ = std::filesystem::path(folder) / name;
    }
    ~InputFile() {
        std::error_code ignored;
        std::filesystem::remove_all(path_.parent_path(), ignored);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    [[nodiscard]] const std::filesystem::path& write(std::string_view content) const {
        std::ofstream(path_, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
        return path_;
    }

private:
    std::filesystem::path path_;
};

} // namespace hyalite::fuzz
