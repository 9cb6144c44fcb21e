// Output files that are either complete or untouched: temporary file, fsync, rename.
#include "base/output_file.h"

#include "base/error.h"

#include <cerrno>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace hyalite {
namespace {

std::string hintFor(int errorNumber) {
    switch (errorNumber) {
    case ENOENT:
    case ENOTDIR:
        return "the folder does not exist: create it first or choose another";
    case EACCES:
    case EPERM:
        return "no permission to write there: choose another folder or change its permissions";
    case EROFS:
        return "the file system is mounted read-only: choose another folder";
    case ENOSPC:
    case EDQUOT:
        return "the disk is full: free some space or choose another folder";
    case EFBIG:
        return "the file is larger than the system allows: see `ulimit -f`";
    case ENAMETOOLONG:
        return "the file name is too long";
    default:
        return "check that the folder exists and is writable";
    }
}

[[noreturn]] void throwNotWritten(const std::filesystem::path& path, int errorNumber) {
    throw Error(ExitCode::OutputNotWritten, SourceLocation{path.string()},
                "cannot write the file: " + std::generic_category().message(errorNumber), hintFor(errorNumber));
}

[[noreturn]] void throwNotWritten(const std::filesystem::path& path, const std::string& what, const std::string& hint) {
    throw Error(ExitCode::OutputNotWritten, SourceLocation{path.string()}, "cannot write the file: " + what, hint);
}

// The kernel follows as many symbolic links.
constexpr int kMostLinks = 40;

// Where the bytes really go: the end of a chain of symbolic links, which need not exist yet. Throws where a rename
// would destroy something that is not a file of the user's to replace: a folder, a device, a write-protected file.
std::filesystem::path resolveTarget(const std::filesystem::path& path) {
    if (!path.has_filename()) {
        throwNotWritten(path, "the path names no file", "give a file name, such as picture.png");
    }
    std::error_code failure;
    std::filesystem::path target = path;
    // Link by link: the library's canonical paths stop at a link whose target is not there yet
    for (int links = 0; std::filesystem::is_symlink(std::filesystem::symlink_status(target, failure)); ++links) {
        if (links == kMostLinks) {
            throwNotWritten(path, ELOOP);
        }
        const std::filesystem::path next = std::filesystem::read_symlink(target, failure);
        if (failure) {
            throwNotWritten(path, failure.value());
        }
        target = target.parent_path() / next; // an absolute one replaces it all
    }
    const std::filesystem::file_status status = std::filesystem::status(target, failure);
    if (std::filesystem::is_directory(status)) {
        throwNotWritten(path, "it is a folder", "give a file name inside the folder");
    }
    if (std::filesystem::exists(status)) {
        if (!std::filesystem::is_regular_file(status)) {
            throwNotWritten(path, "it is a device, a pipe or a socket", "give the name of an ordinary file");
        }
        if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
            throwNotWritten(path, "the existing file is write-protected",
                            "choose another name or change its permissions");
        }
    }
    return target;
}

// A new file beside `target`, gone again unless renamed to it; errors name `asked`, the path that led there. Where the
// system can, it has no name until it is whole: then nothing stays behind, even of a process that is killed.
class TemporaryFile {
public:
    TemporaryFile(const std::filesystem::path& target, const std::filesystem::path& asked)
        : folder_(target.parent_path().empty() ? "." : target.parent_path()) {
        if (::access("/proc/self/fd", X_OK) == 0) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the only way to ask for a file without a name
            descriptor_ = ::open(folder_.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
        }
        if (descriptor_ >= 0) {
            return;
        }
        const int failure = findName([this](const char* name) {
            // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): nor for an exclusive, umask-honouring one
            descriptor_ = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            return descriptor_ >= 0;
        });
        if (failure != 0) {
            throwNotWritten(asked, failure);
        }
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
        if (!path_.empty()) {
            ::unlink(path_.c_str());
        }
    }

    // Each step returns 0 or the error number, so that the caller names the file that the user asked for.
    [[nodiscard]] int write(std::span<const std::byte> content) const {
        while (!content.empty()) {
            const ::ssize_t written = ::write(descriptor_, content.data(), content.size());
            if (written > 0) {
                content = content.subspan(static_cast<std::size_t>(written));
            } else if (written == 0 || errno != EINTR) {
                return written == 0 ? EIO : errno;
            }
        }
        return 0;
    }

    [[nodiscard]] int sync() const { return ::fsync(descriptor_) == 0 ? 0 : errno; }

    // Takes over the permissions of the file that is being replaced, if there is one.
    [[nodiscard]] int copyModeOf(const std::filesystem::path& target) const {
        struct ::stat old{};
        if (::stat(target.c_str(), &old) != 0) {
            return errno == ENOENT ? 0 : errno;
        }
        return ::fchmod(descriptor_, old.st_mode & 07777U) == 0 ? 0 : errno;
    }

    [[nodiscard]] int renameTo(const std::filesystem::path& target) {
        if (path_.empty()) {
            const std::string self = "/proc/self/fd/" + std::to_string(descriptor_);
            const int failure = findName([&](const char* name) {
                return ::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW) == 0;
            });
            if (failure != 0) {
                return failure;
            }
        }
        // close() reports what network file systems found out late.
        if (::close(std::exchange(descriptor_, -1)) != 0 || ::rename(path_.c_str(), target.c_str()) != 0) {
            return errno;
        }
        path_.clear();
        return 0;
    }

private:
    // Sets path_ to a name with which `make` succeeds; returns 0 or the error number. It is short and of its own: the
    // target's may already be as long as the file system allows. The process number keeps programs apart, the counter
    // threads and leftovers of a killed process.
    template <class Make>
    [[nodiscard]] int findName(const Make& make) {
        constexpr int kMaxAttempts = 1000;
        for (int attempt = 0; attempt <= kMaxAttempts; ++attempt) {
            std::filesystem::path name =
                folder_ / (".hyalite-" + std::to_string(::getpid()) + '-' + std::to_string(attempt) + ".tmp");
            const int failure = make(name.c_str()) ? 0 : errno;
            if (failure == 0) {
                path_ = std::move(name);
            }
            if (failure != EEXIST) {
                return failure;
            }
        }
        return EEXIST;
    }

    std::filesystem::path folder_;
    std::filesystem::path path_; // empty: it has no name
    int descriptor_ = -1;
};

} // namespace

void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content) {
    writeFileAtomically(path, [&](const WriteBytes& write) { write(content); });
}

void writeFileAtomically(const std::filesystem::path& path, const std::function<void(const WriteBytes&)>& produce) {
    const std::filesystem::path target = resolveTarget(path);
    TemporaryFile temporary(target, path);
    produce([&](std::span<const std::byte> content) {
        if (const int failure = temporary.write(content); failure != 0) {
            throwNotWritten(path, failure);
        }
    });
    int failure = temporary.sync();
    if (failure == 0) {
        failure = temporary.copyModeOf(target);
    }
    if (failure == 0) {
        failure = temporary.renameTo(target);
    }
    if (failure != 0) {
        throwNotWritten(path, failure);
    }
}

void checkWritable(const std::filesystem::path& path) {
    const std::filesystem::path target = resolveTarget(path);
    // rename() would fail on a name too long only at the end; ask for its status now.
    struct ::stat unused{};
    if (::stat(target.c_str(), &unused) != 0 && errno != ENOENT) {
        throwNotWritten(path, errno);
    }
    const TemporaryFile temporary(target, path);
}

} // namespace hyalite
