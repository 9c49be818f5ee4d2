/// One watcher per folder.
#pragma once
#include <filesystem>

#include "demos/watch/draft_film.h"
#include "render/encode/ffmpeg.h"

namespace demos {

/// A file next to the drafts, not a FolderLock: `impulse render` may write frames into the folder
/// at the same time.
class DraftLock {
public:
    /// The folder must exist. Throws Stop (wouldOverwrite) while another watcher writes there,
    /// render::Error if no file can be created.
    explicit DraftLock(const DraftPlaces& places);
    ~DraftLock();
    DraftLock(const DraftLock&) = delete;
    DraftLock& operator=(const DraftLock&) = delete;

private:
    std::filesystem::path mark_;
    render::Descriptor file_;
};

}  // namespace demos
