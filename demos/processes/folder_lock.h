/// A lock that allows one run per folder.
#pragma once
#include <filesystem>

namespace demos {

/// The lock is on the folder itself, so that no file is left; the destructor releases it. On a file
/// system without locks nothing is locked.
class FolderLock {
public:
    /// The folder must exist. Throws Stop (wouldOverwrite) if another run holds the lock,
    /// render::Error if the folder cannot be opened.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    int file_;
};

}  // namespace demos
