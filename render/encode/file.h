/// Files that are either complete or absent: they are written under a temporary name and renamed.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace render {

/// What happens to an existing file of the same name, even one created a moment ago.
enum class Existing { replaced, kept };

/// Gives `path` this content in one step: readers see the old file or the new one, even if the run
/// is killed. The folder must exist; temporary files of this path from killed runs are removed.
/// Throws AlreadyThere if there is a file that is to be kept, and Error (path and reason) if the
/// target is a symlink, a directory or a device, or if the disk is full; no temporary or
/// half-written file is left then.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                         Existing existing = Existing::replaced);

/// The same for one of many files in a folder: leftovers of killed runs are not searched for.
void writeFrameFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// A file to write, and its content.
struct NamedBytes {
    std::filesystem::path path;           ///< replaced if it exists
    std::span<const std::uint8_t> bytes;  ///< all of it
};

/// Writes several files. All of them are complete under their temporary names before the first one
/// is renamed, so that a full disk leaves none.
void writeFilesTogether(std::span<const NamedBytes> files, Existing existing = Existing::replaced);

/// The same for a text.
inline void writeFileAtomically(const std::filesystem::path& path, std::string_view text,
                                Existing existing = Existing::replaced) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    writeFileAtomically(path, std::span(bytes, text.size()), existing);
}

/// Creates the folder and its parents if they do not exist. Throws Error.
void makeFolder(const std::filesystem::path& folder);

/// Throws Error unless `path` does not exist or is an ordinary file.
void checkReplaceable(const std::filesystem::path& path);

/// The name of a file until it is complete: in the target's folder (rename does not cross disks),
/// with the numbers of this machine and process.
std::filesystem::path temporaryNameFor(const std::filesystem::path& path);

/// Creates a new `temporary` and opens it, never through a symlink. A file left there by a killed
/// run with the same process number is removed first. `target` is for the message. While the file
/// is open, sweepTemporaries() of other runs does not remove it, if the disk supports locks.
int createTemporary(const std::filesystem::path& temporary, const std::filesystem::path& target);

/// A file without a name on the disk of `target`, open for reading and writing. It disappears with
/// its last descriptor, however a run ends.
int createUnnamed(const std::filesystem::path& target);

/// Renames a temporary file to its target. Throws AlreadyThere or Error; the temporary file then
/// stays.
void publish(const std::filesystem::path& temporary, const std::filesystem::path& target,
             Existing existing);

/// Removes the temporary files of `path` left by killed runs. True if another run holds one.
bool sweepTemporaries(const std::filesystem::path& path);

/// One line for an errno: "disk full", "file larger than ...", otherwise the system's text.
std::string describeError(int error);

}  // namespace render
