// Output files: complete or untouched, whatever fails.
#include "base/output_file.h"

#include "base/error.h"
#include "unit/image/temporary_folder.h"

#include <catch2/catch_test_macros.hpp>
#include <csignal>
#include <functional>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace hyalite;
using test::get;
using test::put;
using test::TemporaryFolder;

namespace {

constexpr ::uid_t kNobody = 65534;

std::span<const std::byte> bytesOf(const std::string& text) {
    return std::as_bytes(std::span(text));
}

// The hint of the Error that both functions must throw.
std::string hintOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::OutputNotWritten);
        CHECK_FALSE(error.where().file.empty());
        return error.hint();
    }
    FAIL("nothing was thrown");
    return {};
}

void requireNotWritten(const std::filesystem::path& path, const std::string& hintPart) {
    CHECK(hintOf([&] { writeFileAtomically(path, bytesOf("new")); }).find(hintPart) != std::string::npos);
    CHECK(hintOf([&] { checkWritable(path); }).find(hintPart) != std::string::npos);
}

// Permissions do not bind root: while this lives, the process acts as nobody.
class WithoutRoot {
public:
    WithoutRoot() : wasRoot_(::geteuid() == 0) {
        if (wasRoot_ && ::seteuid(kNobody) != 0) {
            FAIL("root without the right to become another user: permissions cannot be tested");
        }
    }
    WithoutRoot(const WithoutRoot&) = delete;
    WithoutRoot& operator=(const WithoutRoot&) = delete;
    ~WithoutRoot() {
        if (wasRoot_ && ::seteuid(0) != 0) {
            std::abort();
        }
    }

private:
    bool wasRoot_;
};

// While this lives, files can grow to `limit` bytes and write() fails beyond: a full disk in every respect but the
// name.
class FileSizeLimit {
public:
    explicit FileSizeLimit(::rlim_t limit) : oldHandler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        const ::rlimit tight{limit, old_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &tight);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        static_cast<void>(std::signal(SIGXFSZ, oldHandler_));
    }

private:
    ::rlimit old_{};
    void (*oldHandler_)(int);
};

} // namespace

TEST_CASE("a file is written whole, replaces the old one and leaves nothing else") {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "a", bytesOf("first"));
    CHECK(get(folder / "a") == "first");
    writeFileAtomically(folder / "a", bytesOf("second"));
    CHECK(get(folder / "a") == "second");
    writeFileAtomically(folder / "empty", std::span<const std::byte>());
    CHECK(get(folder / "empty").empty());
    CHECK(folder.entries() == 2);
}

TEST_CASE("a replaced file keeps its permissions, a new one follows the umask") {
    const TemporaryFolder folder;
    put(folder / "private", "x");
    ::chmod((folder / "private").c_str(), 0600);
    const ::mode_t umaskBefore = ::umask(0027);
    writeFileAtomically(folder / "private", bytesOf("y"));
    writeFileAtomically(folder / "new", bytesOf("y"));
    ::umask(umaskBefore);
    struct ::stat status{};
    ::stat((folder / "private").c_str(), &status);
    CHECK((status.st_mode & 0777U) == 0600U);
    ::stat((folder / "new").c_str(), &status);
    CHECK((status.st_mode & 0777U) == 0640U); // 0666 without the bits of 0027
}

TEST_CASE("a symbolic link is followed, not replaced") {
    const TemporaryFolder folder;
    put(folder / "real", "old");
    std::filesystem::create_symlink(folder / "real", folder / "link");
    writeFileAtomically(folder / "link", bytesOf("new"));
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(get(folder / "real") == "new");
}

TEST_CASE("a name as long as the file system allows can be written, a longer one is an error") {
    const TemporaryFolder folder;
    writeFileAtomically(folder / std::string(255, 'a'), bytesOf("x")); // NAME_MAX of Linux file systems
    CHECK(get(folder / std::string(255, 'a')) == "x");
    requireNotWritten(folder / std::string(256, 'a'), "too long");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a missing folder is an error with a hint") {
    const TemporaryFolder folder;
    requireNotWritten(folder / "missing/a.png", "folder does not exist");
    put(folder / "file", "x");
    requireNotWritten(folder / "file/a.png", "folder does not exist");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a folder, a device and an empty name are not written over") {
    const TemporaryFolder folder;
    requireNotWritten(folder.path(), "inside the folder");
    requireNotWritten(folder.path() / "", "file name");
    CHECK_THROWS_AS(writeFileAtomically("", bytesOf("new")), Error);
    CHECK_THROWS_AS(checkWritable(""), Error);
    requireNotWritten("/dev/null", "ordinary file");
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a folder without write permission is an error with a hint") {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    ::chmod(folder.path().c_str(), 0555);
    {
        const WithoutRoot nobody;
        requireNotWritten(folder / "b", "no permission");
    }
    CHECK(folder.entries() == 1);
}

TEST_CASE("a write-protected file is left alone even if its folder is writable") {
    const TemporaryFolder folder;
    ::chmod(folder.path().c_str(), 0777);
    put(folder / "a", "old");
    ::chmod((folder / "a").c_str(), 0444);
    {
        const WithoutRoot nobody;
        requireNotWritten(folder / "a", "permissions");
    }
    CHECK(get(folder / "a") == "old");
}

TEST_CASE("a write that fails halfway leaves the old file and no temporary file") {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    const std::string large(100000, 'x');
    {
        const FileSizeLimit limit(4096);
        CHECK(hintOf([&] { writeFileAtomically(folder / "a", bytesOf(large)); }).find("ulimit") != std::string::npos);
        CHECK_THROWS_AS(writeFileAtomically(folder / "b", bytesOf(large)), Error);
    }
    CHECK(get(folder / "a") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("asking whether a file can be written changes nothing") {
    const TemporaryFolder folder;
    put(folder / "a", "old");
    checkWritable(folder / "a");
    checkWritable(folder / "b");
    CHECK(get(folder / "a") == "old");
    CHECK(folder.entries() == 1);
}
