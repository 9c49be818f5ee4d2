/// One watcher a folder.
#pragma once
#include <filesystem>

#include "demos/watch/draft_film.h"
#include "render/encode/ffmpeg.h"

namespace demos {

/// By a file beside the drafts, not by FolderLock: `impulse render` may write its frames into the
/// folder meanwhile.
class DraftLock {
public:
    /// The folder has to be there. Throws Stop (wouldOverwrite) while another watcher writes there,
    /// render::Error where it takes no files.
    explicit DraftLock(const DraftPlaces& places);
    ~DraftLock();
    DraftLock(const DraftLock&) = delete;
    DraftLock& operator=(const DraftLock&) = delete;

private:
    std::filesystem::path mark_;
    render::Descriptor file_;
};

}  // namespace demos
