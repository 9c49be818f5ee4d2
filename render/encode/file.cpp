#include "render/encode/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "render/error.h"

namespace render {
namespace {

namespace fs = std::filesystem;

/// ENOENT of a folder that is there: it makes no files, as /proc does not.
std::string reasonOf(const fs::path& path, int error) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code ignored;
    if (error == ENOENT && fs::is_directory(folder, ignored)) return "its folder takes no files";
    return describeError(error);
}

[[noreturn]] void fail(const fs::path& path, int error) {
    throw Error("cannot write '" + path.string() + "': " + reasonOf(path, error));
}

/// Zero or an errno. A short count is no error: the next call tells why it was short.
int writeAll(int file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        if (written == 0) return EIO;  // no progress and no reason: do not spin
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Zero or an errno. Network disks tell only here that they were full. Not repeated on EINTR:
/// Linux has released the number by then, and another thread may own it.
int closeFile(int file) { return ::close(file) == 0 || errno == EINTR ? 0 : errno; }

/// Under the name that it carries until it is whole.
void writeTemporary(const NamedBytes& content) {
    const fs::path temporary = temporaryNameFor(content.path);
    const int file = createTemporary(temporary, content.path);
    int error = writeAll(file, content.bytes);
    const int closeError = closeFile(file);
    if (error == 0) error = closeError;
    if (error == 0) return;
    ::unlink(temporary.c_str());
    fail(content.path, error);
}

}  // namespace

std::string describeError(int error) {
    switch (error) {
        case ENOSPC:
            return "disk full";
        case EDQUOT:
            return "disk quota used up";
        case EFBIG:
            return "file larger than this disk or process may write (see ulimit -f)";
        default:
            return std::generic_category().message(error);
    }
}

void makeFolder(const fs::path& folder) {
    std::error_code error;
    if (folder.empty() || fs::is_directory(folder, error)) return;
    if (fs::exists(folder, error))
        throw Error("cannot write into '" + folder.string() + "': it is not a folder");
    fs::create_directories(folder, error);
    if (error)
        throw Error("cannot make the folder '" + folder.string() +
                    "': " + describeError(error.value()));
}

void checkReplaceable(const fs::path& path) {
    struct stat found = {};
    if (::lstat(path.c_str(), &found) != 0) {
        if (errno == ENOENT) return;
        fail(path, errno);
    }
    if (S_ISREG(found.st_mode)) return;
    const std::string what = S_ISLNK(found.st_mode)   ? "a symbolic link"
                             : S_ISDIR(found.st_mode) ? "a directory"
                                                      : "not an ordinary file";
    throw Error("cannot write '" + path.string() + "': it is " + what +
                "; remove it or give another name");
}

fs::path temporaryNameFor(const fs::path& path) {
    fs::path temporary = path;
    temporary += ".tmp" + std::to_string(::getpid());
    return temporary;
}

int createTemporary(const fs::path& temporary, const fs::path& target) {
    constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    int file = ::open(temporary.c_str(), kFlags, 0666);
    if (file < 0 && errno == EEXIST) {
        ::unlink(temporary.c_str());  // removes a symlink itself, never what it points to
        file = ::open(temporary.c_str(), kFlags, 0666);
    }
    if (file < 0) fail(target, errno);
    return file;
}

int createUnnamed(const fs::path& target) {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) return file;
    // not every file system has them
    std::string name = temporaryNameFor(target).string() + ".XXXXXX";
    const int named = ::mkostemp(name.data(), O_CLOEXEC);
    if (named < 0) fail(target, errno);
    ::unlink(name.c_str());
    return named;
}

void holdTemporary(int file) { ::flock(file, LOCK_EX | LOCK_NB); }

bool sweepTemporaries(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
    const std::string start = path.filename().string() + ".tmp";
    bool held = false;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with(start) || name.size() == start.size() ||
            name.find_first_not_of("0123456789", start.size()) != std::string::npos)
            continue;
        const int file =
            ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (file < 0) continue;
        if (::flock(file, LOCK_EX | LOCK_NB) == 0)
            ::unlink(entry.path().c_str());
        else
            held = true;
        ::close(file);
    }
    return held;
}

void writeFilesTogether(std::span<const NamedBytes> files) {
    for (const NamedBytes& file : files) checkReplaceable(file.path);
    std::size_t ready = 0;
    try {
        for (; ready < files.size(); ++ready) writeTemporary(files[ready]);
        for (const NamedBytes& file : files)
            // rename replaces a symlink that appeared meanwhile; it does not follow it
            if (::rename(temporaryNameFor(file.path).c_str(), file.path.c_str()) != 0)
                fail(file.path, errno);
    } catch (const Error&) {
        for (const NamedBytes& file : files.first(ready))
            ::unlink(temporaryNameFor(file.path).c_str());
        throw;
    }
}

void writeFileAtomically(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const NamedBytes file{path, bytes};
    writeFilesTogether({&file, 1});
}

}  // namespace render
