// See input_file.h.
#include "base/input_file.h"

#include "base/spelling.h"

#include <fstream>
#include <system_error>

namespace hyalite {

std::string readInputFile(const std::filesystem::path& path, std::size_t mostBytes, const std::string& kind,
                          const SourceLocation& where) {
    const auto fail = [&](const std::string& why, const std::string& hint = {}) {
        throw Error(ExitCode::BadInput, where, "cannot read " + kind + ' ' + inQuotes(path.string()) + ": " + why,
                    hint);
    };

    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) {
        fail("no such file");
    }
    if (error) {
        fail(error.message());
    }
    if (status.type() == std::filesystem::file_type::directory) {
        fail("it is a folder", "name a file in it");
    }
    if (status.type() != std::filesystem::file_type::regular) {
        fail("it is not a regular file"); // a pipe or device could block or never end
    }
    const auto size = std::filesystem::file_size(path, error);
    if (error) {
        fail(error.message());
    }
    if (size == 0) {
        fail("the file is empty");
    }
    if (size > mostBytes) {
        fail("the file is too large: " + std::to_string(size) + " bytes", "the limit is " + std::to_string(mostBytes));
    }

    std::string bytes(static_cast<std::size_t>(size), '\0');
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        fail("it cannot be opened", "check its permissions");
    }
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!stream) {
        fail("unexpected end of file");
    }
    return bytes;
}

} // namespace hyalite
