#include "demos/watch/file_watch.h"

#include <fmt/format.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <utility>

#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// A file is complete when its writer closes it or when it is renamed to its name. The file and its
/// folder may also be removed or moved.
constexpr std::uint32_t kEvents =
    IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_DELETE_SELF | IN_MOVE_SELF;

/// A missing folder has no events, and its parents may be missing too: it is polled.
constexpr std::chrono::milliseconds kLook(250);

/// Several files of one save, or of one `git checkout`, are written within this time.
constexpr std::chrono::milliseconds kTogether(20);

[[noreturn]] void fail(const std::string& what) {
    throw render::Error(fmt::format("cannot watch {}: {}", what, render::describeError(errno)));
}

fs::path absoluteOf(const fs::path& file) { return fs::absolute(file).lexically_normal(); }

}  // namespace

FileWatch::FileWatch(std::vector<std::string> ownNames)
    : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)), ownNames_(std::move(ownNames)) {
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
        if (files_.count(file) == 0) {
            addFolder(file.parent_path());
            added = true;
        }
    files_ = std::move(now);
    return added;
}

void FileWatch::addFolder(const fs::path& folder) {
    const int number = inotify_add_watch(queue_, folder.c_str(), kEvents | IN_ONLYDIR);
    if (number >= 0)
        folders_[number] = folder;
    else if (errno == ENOENT || errno == ENOTDIR)
        lost_.insert(folder);
    else
        fail("'" + printable(folder.string()) + "'");
}

void FileWatch::lookForLost() {
    std::set<fs::path> lost;
    lost.swap(lost_);
    for (const fs::path& folder : lost) addFolder(folder);
    if (lost_.size() < lost.size()) news_ = true;  // files that came with the folder have no event
}

bool FileWatch::isOwn(const std::string& name) const {
    return std::any_of(ownNames_.begin(), ownNames_.end(),
                       [&name](const std::string& own) { return name.starts_with(own); });
}

void FileWatch::take(const inotify_event& event, Which which) {
    if (event.mask & IN_Q_OVERFLOW) news_ = true;  // events were lost
    const auto folder = folders_.find(event.wd);
    if (folder == folders_.end()) return;
    if (event.mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT)) {
        inotify_rm_watch(queue_, event.wd);  // a moved folder would be watched at its new place
        lost_.insert(folder->second);
        folders_.erase(folder);
        news_ = true;
        return;
    }
    const std::string name = event.len > 0 ? event.name : "";
    const bool named = !name.empty() && files_.count(folder->second / name) > 0;
    news_ = news_ || named || (which == Which::anyBeside && !isOwn(name));
}

void FileWatch::readEvents(Which which) {
    alignas(inotify_event) char block[16384];
    for (ssize_t got; (got = read(queue_, block, sizeof block)) > 0;)
        for (ssize_t at = 0; at < got;) {
            const auto* event = reinterpret_cast<const inotify_event*>(block + at);
            at += static_cast<ssize_t>(sizeof *event + event->len);
            take(*event, which);
        }
    lookForLost();
}

bool FileWatch::hasNews(Which which) {
    readEvents(which);
    return news_;
}

bool FileWatch::wait(Which which) {
    const SignalsHeld signals;
    using Time = std::optional<std::chrono::nanoseconds>;
    while (!hasNews(which) && !interrupted())
        signals.isReadable(queue_, lost_.empty() ? Time() : Time(kLook));
    while (!interrupted() && signals.isReadable(queue_, kTogether)) readEvents(which);
    news_ = false;
    return !interrupted();
}

}  // namespace demos
