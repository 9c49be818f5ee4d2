/// Waits until files are written, through inotify.
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace demos {

/// The folders of the files are watched, not the files: an editor that writes another file and
/// renames it is noticed, and so is a file that is not there yet.
class FileWatch {
public:
    /// Throws render::Error where the system has no more watches to give.
    FileWatch();
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    /// These from now on, and what they are links to. True: one of them was not watched before.
    /// Throws render::Error for a folder that is not there.
    bool watch(const std::vector<std::filesystem::path>& files);

    enum class Which { files, anyBeside };  // anyBeside: any file of their folders counts
    /// Until one is whole again after it was written: true. False: SIGINT or SIGTERM came
    /// (demos/film/signals.h). What has happened since the last wait counts.
    bool wait(Which which);
    /// Whether wait() would come back at once.
    bool hasNews(Which which);

private:
    bool addFolderOf(const std::filesystem::path& file);
    void readEvents(Which which);

    int queue_;
    std::map<int, std::filesystem::path> folders_;  // by number of the watch
    std::set<std::filesystem::path> files_;         // absolute
    bool news_ = false;
};

}  // namespace demos
