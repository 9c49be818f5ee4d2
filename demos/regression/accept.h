/// What a test has shown becomes the baseline: files are copied, nothing is drawn again.
#pragma once
#include <filesystem>

namespace demos {

/// All of `shown` (NAME.snapshots as a test left it) over `baseline`; pictures of it that `shown`
/// has not are orphans, and stay. Throws BaselineError where `shown` is not whole, or was changed
/// since; render::Error where a file cannot be written.
void acceptAll(const std::filesystem::path& shown, const std::filesystem::path& baseline);

/// Only the picture of `time` (s). Both have to be of one size and one rate of steps. Throws as
/// above.
void acceptPicture(const std::filesystem::path& shown, const std::filesystem::path& baseline,
                   double time);

/// All but the pictures: how the bodies move, and the settings.
void acceptPhysics(const std::filesystem::path& shown, const std::filesystem::path& baseline);

}  // namespace demos
