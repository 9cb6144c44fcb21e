// See private_folder.h.
#include "base/private_folder.h"

#include "base/error.h"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace hyalite {

PrivateFolder::PrivateFolder() {
    std::error_code failure;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(failure);
    std::string name = (parent / "hyalite-XXXXXX").string();
    // mkdtemp makes a folder that was not there, with a name that cannot be foretold, for its owner alone
    if (failure || ::mkdtemp(name.data()) == nullptr) {
        const std::string reason = failure ? failure.message() : std::generic_category().message(errno);
        throw Error(ExitCode::OutputNotWritten, SourceLocation{.file = parent.string()},
                    "cannot create a temporary folder: " + reason, "name a folder for temporary files with TMPDIR");
    }
    path_ = name;
}

PrivateFolder::~PrivateFolder() {
    std::error_code ignored; // it is the system's to clean
    std::filesystem::remove_all(path_, ignored);
}

} // namespace hyalite
