#include "demos/slides/scratch_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <string>
#include <string_view>

#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kStart = "impulse_";

/// 123 for "impulse_123_Ab3dEf", made by process 123; -1: not a scratch folder's name.
pid_t makerOf(const std::string& name) {
    if (!name.starts_with(kStart)) return -1;
    const char* end = name.data() + name.size();
    pid_t maker = -1;
    const auto read = std::from_chars(name.data() + kStart.size(), end, maker);
    return read.ec == std::errc() && end - read.ptr == 7 && *read.ptr == '_' ? maker : -1;
}

/// Whether it belongs to this user and is unlocked. A maker in another container is not visible.
bool isAbandoned(const fs::path& folder) {
    const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) return false;
    struct stat status = {};
    const bool own = ::fstat(file, &status) == 0 && status.st_uid == ::geteuid();
    const bool free = own && ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file);
    return free;
}

/// Removes the folders of killed runs.
void sweepAbandoned(const fs::path& place) {
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(place, ignored)) {
        const pid_t maker = makerOf(entry.path().filename().string());
        const bool dead = maker > 0 && ::kill(maker, 0) != 0 && errno == ESRCH;
        if (dead && isAbandoned(entry.path())) fs::remove_all(entry.path(), ignored);
    }
}

}  // namespace

ScratchFolder::ScratchFolder() {
    const fs::path place = fs::temp_directory_path();
    sweepAbandoned(place);
    std::string name =
        (place / (std::string(kStart) + std::to_string(::getpid()) + "_XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr)
        throw render::Error("cannot make '" + name + "': " + render::describeError(errno));
    path_ = name;
    held_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (held_ >= 0) ::flock(held_, LOCK_EX | LOCK_NB);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    if (held_ >= 0) ::close(held_);
}

}  // namespace demos
