/// A folder for what is not whole yet; goes with its owner, or, where that was killed, with the
/// next run.
#pragma once
#include <filesystem>

namespace demos {

class ScratchFolder {
public:
    /// Among the system's temporary files. Throws render::Error.
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
