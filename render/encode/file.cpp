#include "render/encode/file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "render/encode/files_together.h"
#include "render/error.h"

namespace render {
namespace {

namespace fs = std::filesystem;

/// 10000..99999, by host: machines that share a folder may have processes of the same number.
unsigned hostNumber() {
    char name[256] = {};
    ::gethostname(name, sizeof name - 1);
    unsigned hash = 2166136261u;  // FNV-1a
    for (const char* c = name; *c != 0; ++c) hash = (hash ^ static_cast<unsigned char>(*c)) * 16777619u;
    return hash % 90'000u + 10'000u;
}

/// ENOENT in an existing folder means that no files can be created there, as in /proc.
std::string reasonOf(const fs::path& path, int error) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code ignored;
    if (error == ENOENT && fs::is_directory(folder, ignored)) return "no file can be created in its folder";
    return describeError(error);
}

[[noreturn]] void fail(const fs::path& path, int error) {
    throw Error("cannot write '" + path.string() + "': " + reasonOf(path, error));
}

/// Zero or an errno. A short count is no error: the next call reports why it was short.
int writeAll(int file, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        if (written == 0) return EIO;  // no progress and no reason: do not loop forever
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Zero or an errno. Network disks report only here that they are full. Not repeated on EINTR:
/// Linux has already released the number, and another thread may own it.
int closeFile(int file) { return ::close(file) == 0 || errno == EINTR ? 0 : errno; }

/// A second descriptor of the same open file; its lock lasts until both are closed.
int duplicate(int file) { return ::fcntl(file, F_DUPFD_CLOEXEC, 3); }

/// Writes the file under its temporary name. The returned descriptor holds its lock.
int writeTemporary(const NamedBytes& content) {
    const fs::path temporary = temporaryNameFor(content.path);
    const int file = createTemporary(temporary, content.path);
    const int held = duplicate(file);
    int error = held < 0 ? errno : writeAll(file, content.bytes);
    const int closeError = closeFile(file);
    if (error == 0) error = closeError;
    if (error == 0) return held;
    if (held >= 0) ::close(held);
    ::unlink(temporary.c_str());
    fail(content.path, error);
}

/// Locks a file just opened; false if a sweep of another run has removed it in between.
bool lockNew(int file) {
    ::flock(file, LOCK_EX | LOCK_NB);  // not every disk supports locks
    struct stat status = {};
    return ::fstat(file, &status) != 0 || status.st_nlink > 0;
}

/// Zero or an errno. Not every file system can check and rename in one step.
int renameToFree(const fs::path& from, const fs::path& to) {
    if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    struct stat found = {};
    if (::lstat(to.c_str(), &found) == 0) return EEXIST;
    return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

void writeTogether(std::span<const NamedBytes> files, Existing existing) {
    for (const NamedBytes& file : files) checkReplaceable(file.path);
    FilesTogether together(existing);
    for (const NamedBytes& file : files) together.add(file);
    together.publish();
}

}  // namespace

std::string describeError(int error) {
    switch (error) {
        case ENOSPC:
            return "disk full";
        case EDQUOT:
            return "disk quota exceeded";
        case EFBIG:
            return "file larger than the disk or process allows (see ulimit -f)";
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
        throw Error("cannot create the folder '" + folder.string() +
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
    static const std::string host = std::to_string(hostNumber());
    temporary += ".tmp" + host + std::to_string(::getpid());
    return temporary;
}

int createTemporary(const fs::path& temporary, const fs::path& target) {
    constexpr int kFlags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    constexpr int kTries = 8;
    int error = EEXIST;
    for (int i = 0; i < kTries && error == EEXIST; ++i) {
        const int file = ::open(temporary.c_str(), kFlags, 0666);
        error = file < 0 ? errno : EEXIST;
        if (file >= 0 && lockNew(file)) return file;
        if (file >= 0) ::close(file);
        if (error == EEXIST) ::unlink(temporary.c_str());  // a symlink itself, not its target
    }
    fail(target, error);
}

int createUnnamed(const fs::path& target) {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0) return file;
    // not every file system has unnamed files
    std::string name = temporaryNameFor(target).string() + ".XXXXXX";
    const int named = ::mkostemp(name.data(), O_CLOEXEC);
    if (named < 0) fail(target, errno);
    ::unlink(name.c_str());
    return named;
}

void publish(const fs::path& temporary, const fs::path& target, Existing existing) {
    // rename replaces a symlink created in the meantime; it does not follow it
    const int error = existing == Existing::kept ? renameToFree(temporary, target)
                      : ::rename(temporary.c_str(), target.c_str()) == 0 ? 0
                                                                         : errno;
    if (error == EEXIST && existing == Existing::kept)
        throw AlreadyThere("'" + target.string() +
                           "' was created in the meantime, perhaps by another run; --overwrite "
                           "replaces it");
    if (error != 0) fail(target, error);
}

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
        else if (errno == EWOULDBLOCK)
            held = true;  // otherwise the disk has no locks: the owner is unknown
        ::close(file);
    }
    return held;
}

FilesTogether::~FilesTogether() {
    for (std::size_t i = published_; i < held_.size(); ++i)
        ::unlink(temporaryNameFor(held_[i].path).c_str());
}

void FilesTogether::add(const NamedBytes& file) {
    checkReplaceable(file.path);
    held_.emplace_back(file.path, writeTemporary(file));
}

void FilesTogether::publish() {
    try {
        for (; published_ < held_.size(); ++published_) {
            const fs::path& path = held_[published_].path;
            render::publish(temporaryNameFor(path), path, existing_);
        }
    } catch (const Error&) {
        if (existing_ == Existing::kept)
            for (std::size_t i = 0; i < published_; ++i) ::unlink(held_[i].path.c_str());
        throw;
    }
}

void writeFilesTogether(std::span<const NamedBytes> files, Existing existing) {
    for (const NamedBytes& file : files) sweepTemporaries(file.path);
    writeTogether(files, existing);
}

void writeFileAtomically(const fs::path& path, std::span<const std::uint8_t> bytes,
                         Existing existing) {
    const NamedBytes file{path, bytes};
    writeFilesTogether({&file, 1}, existing);
}

void writeFrameFile(const fs::path& path, std::span<const std::uint8_t> bytes) {
    const NamedBytes file{path, bytes};
    writeTogether({&file, 1}, Existing::replaced);
}

}  // namespace render
