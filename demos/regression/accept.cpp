#include "demos/regression/accept.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/outputs.h"
#include "demos/regression/baseline.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/shell_word.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

/// A symbolic link in a checkout, or in a folder of results, may point anywhere.
void checkFolder(const fs::path& folder) {
    std::error_code ignored;
    if (fs::is_symlink(folder, ignored))
        throw BaselineError(printable(folder.string()) +
                            " is a symbolic link, and baselines are kept in folders only; "
                            "remove it");
}

Baseline baselineIn(const fs::path& folder, const char* otherwise) {
    std::optional<Baseline> baseline = readBaseline(folder);
    if (!baseline) throw BaselineError(printable(folder.string()) + otherwise);
    return std::move(*baseline);
}

Baseline shownIn(const fs::path& folder) {
    checkFolder(folder);
    return baselineIn(folder, " holds nothing to accept; run impulse test again");
}

void writeBaselineFile(const Baseline& baseline, const fs::path& folder) {
    // The trajectory is already encoded, so no tolerance is needed.
    render::writeFileAtomically(folder / kBaselineFile, jsonOf(baseline, {}));
}

void checkLike(const Baseline& shown, const Baseline& kept) {
    if (shown.width != kept.width || shown.height != kept.height ||
        shown.trajectory.hz != kept.trajectory.hz)
        throw BaselineError(fmt::format("{}: the size of the pictures or the steps a second have "
                                        "changed; accept the whole scene: impulse approve {}",
                                        printable(shown.scene), printable(shellWord(shown.scene))));
}

}  // namespace

void acceptAll(const fs::path& shown, const fs::path& baseline) {
    checkFolder(baseline);
    const Baseline now = shownIn(shown);
    // All are checked before one is written. They are read twice, as all may not fit into memory.
    for (const BaselinePicture& picture : now.pictures) readPicture(shown, picture);
    const std::vector<std::uint8_t> json = contentOf(shown / kBaselineFile);
    render::makeFolder(baseline);
    for (const BaselinePicture& picture : now.pictures)
        render::writeFileAtomically(baseline / pictureFile(picture.time),
                                    readPicture(shown, picture));
    render::writeFileAtomically(baseline / kBaselineFile, json);
}

void acceptPicture(const fs::path& shown, const fs::path& baseline, double time) {
    checkFolder(baseline);
    Baseline now = shownIn(shown);
    Baseline kept = baselineIn(baseline, " holds no baseline yet; accept the whole scene");
    checkLike(now, kept);
    const BaselinePicture* picture = pictureAt(now, time);
    if (!picture)
        throw BaselineError(fmt::format("{} has no picture at {} s", printable(now.scene),
                                        numberText(time)));
    const std::vector<std::uint8_t> file = readPicture(shown, *picture);
    if (BaselinePicture* old = pictureAt(kept, time))
        *old = *picture;
    else
        kept.pictures.push_back(*picture);
    std::sort(kept.pictures.begin(), kept.pictures.end(),
              [](const BaselinePicture& a, const BaselinePicture& b) { return a.time < b.time; });
    render::writeFileAtomically(baseline / pictureFile(time), file);
    writeBaselineFile(kept, baseline);
}

void acceptPhysics(const fs::path& shown, const fs::path& baseline) {
    checkFolder(baseline);
    Baseline now = shownIn(shown);
    Baseline kept = baselineIn(baseline, " holds no baseline yet; accept the whole scene");
    checkLike(now, kept);
    for (BaselinePicture& picture : kept.pictures)
        if (const BaselinePicture* own = pictureAt(now, picture.time)) picture.state = own->state;
    now.pictures = kept.pictures;
    writeBaselineFile(now, baseline);
}

}  // namespace demos
