#include "demos/watch/draft_lock.h"

#include <fmt/format.h>

#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"

namespace demos {
namespace {

/// Removes what a killed watcher has left.
std::filesystem::path freeMark(const DraftPlaces& places) {
    const std::filesystem::path mark = places.folder / "draft";
    if (render::sweepTemporaries(mark))
        throw Stop(Exit::wouldOverwrite,
                   fmt::format("drafts in '{}' are being written by another watch; end it, or name "
                               "another folder",
                               printable(places.folder.string())));
    return render::temporaryNameFor(mark);
}

}  // namespace

DraftLock::DraftLock(const DraftPlaces& places)
    : mark_(freeMark(places)), file_(render::createTemporary(mark_, mark_), "mark a folder of drafts") {}

DraftLock::~DraftLock() {
    std::error_code ignored;
    std::filesystem::remove(mark_, ignored);
}

}  // namespace demos
