/// A folder for what is not whole yet; goes with its owner.
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
};

}  // namespace demos
