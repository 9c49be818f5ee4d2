/// Waits until files are written, through inotify.
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

struct inotify_event;

namespace demos {

/// The folders of the files are watched, not the files: an editor that writes another file and
/// renames it is noticed, and so is a file that is not there yet.
class FileWatch {
public:
    /// Files whose names begin with one of `ownNames` are never news beside what is watched: who
    /// watches writes them. Throws render::Error where the system has no more watches to give.
    explicit FileWatch(std::vector<std::string> ownNames);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// These from now on, and what they are links to; a folder that is not there is waited for.
    /// True: one of them was not watched before. Throws render::Error for a folder that may not be
    /// watched.
    bool watch(const std::vector<std::filesystem::path>& files);

    enum class Which { files, anyBeside };  // anyBeside: any file of their folders counts
    /// Until one is whole again after it was written, or is gone: true. False: SIGINT or SIGTERM
    /// came (demos/processes/signals.h). What has happened since the last wait counts.
    bool wait(Which which);
    /// Whether wait() would come back at once.
    bool hasNews(Which which);

private:
    void addFolder(const std::filesystem::path& folder);
    void readEvents(Which which);
    void take(const inotify_event& event, Which which);
    bool isOwn(const std::string& name) const;
    void lookForLost();

    int queue_;
    std::map<int, std::filesystem::path> folders_;  // by number of the watch
    std::set<std::filesystem::path> files_;         // absolute
    std::set<std::filesystem::path> lost_;          // folders that are not there
    std::vector<std::string> ownNames_;
    bool news_ = false;
};

}  // namespace demos
