/// One run a folder.
#pragma once
#include <filesystem>

namespace demos {

/// On the folder itself, so that no file is left over; ends with its owner. On a file system
/// without locks nothing is locked.
class FolderLock {
public:
    /// The folder has to be there. Throws Stop (wouldOverwrite) when another run holds it,
    /// render::Error when it cannot be opened.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int file_;
};

}  // namespace demos
