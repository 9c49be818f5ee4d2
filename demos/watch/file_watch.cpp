#include "demos/watch/file_watch.h"

#include <fmt/format.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>

#include "demos/film/signals.h"
#include "demos/scene/complaints.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// A file is whole when its writer closes it, or when it comes under its name. Its folder may go.
constexpr std::uint32_t kEvents = IN_CLOSE_WRITE | IN_MOVED_TO | IN_DELETE_SELF | IN_MOVE_SELF;

/// Several files of one save, or of one `git checkout`, come closer together than this.
constexpr std::chrono::milliseconds kTogether(20);

[[noreturn]] void fail(const std::string& what) {
    throw render::Error(fmt::format("cannot watch {}: {}", what, render::describeError(errno)));
}

fs::path absoluteOf(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

}  // namespace

FileWatch::FileWatch() : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
    if (queue_ < 0) fail("files");
}

FileWatch::~FileWatch() { close(queue_); }

bool FileWatch::watch(const std::vector<fs::path>& files) {
    std::set<fs::path> now;
    for (const fs::path& file : files) {
        now.insert(absoluteOf(file));
        std::error_code missing;
        if (const fs::path real = fs::canonical(file, missing); !missing) now.insert(real);
    }
    bool added = false;
    for (const fs::path& file : now)
        if (files_.count(file) == 0) added = addFolderOf(file) || added;
    files_ = std::move(now);
    return added;
}

bool FileWatch::addFolderOf(const fs::path& file) {
    const fs::path folder = file.parent_path();
    const int number = inotify_add_watch(queue_, folder.c_str(), kEvents | IN_ONLYDIR);
    if (number < 0) fail("'" + printable(folder.string()) + "'");
    folders_[number] = folder;
    return true;
}

void FileWatch::readEvents(Which which) {
    alignas(inotify_event) char block[16384];
    for (ssize_t got; (got = read(queue_, block, sizeof block)) > 0;)
        for (ssize_t at = 0; at < got;) {
            const auto* event = reinterpret_cast<const inotify_event*>(block + at);
            at += static_cast<ssize_t>(sizeof *event + event->len);
            const auto folder = folders_.find(event->wd);
            if (event->mask & IN_Q_OVERFLOW) news_ = true;  // some were lost
            if (folder == folders_.end()) continue;
            if (event->mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT))
                throw render::Error(
                    fmt::format("the folder '{}' is gone; what was watched is not "
                                "there any more",
                                printable(folder->second.string())));
            const bool named = event->len > 0 && files_.count(folder->second / event->name) > 0;
            news_ = news_ || named || which == Which::anyBeside;
        }
}

bool FileWatch::hasNews(Which which) {
    readEvents(which);
    return news_;
}

bool FileWatch::wait(Which which) {
    const SignalsHeld signals;
    while (!hasNews(which) && !interrupted()) signals.isReadable(queue_);
    while (!interrupted() && signals.isReadable(queue_, kTogether)) readEvents(which);
    news_ = false;
    return !interrupted();
}

}  // namespace demos
