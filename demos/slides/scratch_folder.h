/// A temporary folder for incomplete files. It is removed with its owner or, if the process was
/// killed, by the next run.
#pragma once
#include <filesystem>

namespace demos {

class ScratchFolder {
public:
    /// Made in the system's folder for temporary files. Throws render::Error.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int held_ = -1;  // the folder, locked
};

}  // namespace demos
