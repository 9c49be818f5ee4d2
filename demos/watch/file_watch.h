/// Waits until files are written, through inotify.
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

struct inotify_event;

namespace demos {

/// Watches the files' folders, not the files, to notice editors that write another file and rename
/// it, and files that do not exist yet.
class FileWatch {
public:
    /// Other files in a watched folder whose names begin with one of `ownNames` are never news: the
    /// watcher itself writes them. Throws render::Error if the system has no more watches.
    explicit FileWatch(std::vector<std::string> ownNames);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// Watches these files from now on, and the targets of links; waits for missing folders. True:
    /// one of them was not watched before. Throws render::Error for a folder that cannot be
    /// watched.
    bool watch(const std::vector<std::filesystem::path>& files);

    enum class Which { files, anyBeside };  // anyBeside: also any other file in their folders
    /// Waits until a file is completely written or removed: true. False: SIGINT or SIGTERM came
    /// (demos/processes/signals.h). Changes since the last wait count.
    bool wait(Which which);
    /// Whether wait() would return at once.
    bool hasNews(Which which);

private:
    void addFolder(const std::filesystem::path& folder);
    void readEvents(Which which);
    void take(const inotify_event& event, Which which);
    bool isOwn(const std::string& name) const;
    void lookForLost();

    int queue_;
    std::map<int, std::filesystem::path> folders_;  // by watch descriptor
    std::set<std::filesystem::path> files_;         // absolute
    std::set<std::filesystem::path> lost_;          // missing folders
    std::vector<std::string> ownNames_;
    bool news_ = false;
};

}  // namespace demos
