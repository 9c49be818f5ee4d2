#include "demos/processes/folder_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    const std::string name = printable(folder.string());
    if (file_ < 0)
        throw render::Error(fmt::format("cannot open the folder '{}': {}", name,
                                        render::describeError(errno)));
    // A file system without locks gives another error: then nothing is locked.
    if (flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    close(file_);
    throw Stop(Exit::wouldOverwrite,
               fmt::format("'{}' is being written by another run; wait for it, or name another "
                           "folder",
                           name));
}

FolderLock::~FolderLock() { close(file_); }

}  // namespace demos
