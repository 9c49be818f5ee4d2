/// Makes the results of a test the new baseline: files are copied, nothing is drawn again.
#pragma once
#include <filesystem>

namespace demos {

/// Copies all of `shown` (NAME.snapshots as a test left it) over `baseline`; pictures that only
/// `baseline` has are orphans, and stay. Throws BaselineError where `shown` is incomplete or was
/// changed since; render::Error where a file cannot be written.
void acceptAll(const std::filesystem::path& shown, const std::filesystem::path& baseline);

/// Copies only the picture at `time` (s). Both folders must have the same picture size and step
/// rate. Throws as above.
void acceptPicture(const std::filesystem::path& shown, const std::filesystem::path& baseline,
                   double time);

/// Copies all but the pictures: how the bodies move, and the settings.
void acceptPhysics(const std::filesystem::path& shown, const std::filesystem::path& baseline);

}  // namespace demos
