/// Files that are either whole or absent: temporary name, write, close, rename.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace render {

/// What becomes of a file that has the name already, even if only since a moment ago.
enum class Existing { replaced, kept };

/// Gives `path` this content in one step; a reader, or a run killed half way, sees the old file or
/// the new one. The folder must exist; what killed runs have left of this file is removed.
/// Throws AlreadyThere where a file is there that is to be kept, and Error (path and reason) when
/// the target is a symlink, a directory or a device, or when the disk is full; then neither a
/// temporary file nor a half-written one is left.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                         Existing existing = Existing::replaced);

/// The same for one of many in a folder, which is not searched for leavings every time.
void writeFrameFile(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// A file to be, and what it is to hold.
struct NamedBytes {
    std::filesystem::path path;           ///< replaced where it is there
    std::span<const std::uint8_t> bytes;  ///< all of it
};

/// Several such files: all of them are complete under their temporary names before the first one is
/// renamed, so that a full disk leaves none.
void writeFilesTogether(std::span<const NamedBytes> files, Existing existing = Existing::replaced);

/// The same for a text.
inline void writeFileAtomically(const std::filesystem::path& path, std::string_view text,
                                Existing existing = Existing::replaced) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    writeFileAtomically(path, std::span(bytes, text.size()), existing);
}

/// The folder and its parents; what is there stays. Throws Error.
void makeFolder(const std::filesystem::path& folder);

/// Throws Error unless `path` is free or an ordinary file that may be replaced.
void checkReplaceable(const std::filesystem::path& path);

/// The name a file carries until it is whole: beside the target (rename does not cross disks),
/// with the numbers of this machine and process.
std::filesystem::path temporaryNameFor(const std::filesystem::path& path);

/// Creates a new `temporary` and opens it, never through a symlink. A file left there by a killed
/// run of the same process number is removed first. `target` is for the message. As long as the
/// file is open, sweepTemporaries() of other runs leave it alone, where the disk has locks.
int createTemporary(const std::filesystem::path& temporary, const std::filesystem::path& target);

/// A file without a name on the disk of `target`: it is gone with its last descriptor, however a
/// run ends. Open for reading and writing.
int createUnnamed(const std::filesystem::path& target);

/// From a temporary name to the one it was meant for. Throws AlreadyThere, Error; the temporary
/// file stays then.
void publish(const std::filesystem::path& temporary, const std::filesystem::path& target,
             Existing existing);

/// Removes the temporaries of `path` that killed runs have left. True when another run holds one.
bool sweepTemporaries(const std::filesystem::path& path);

/// One line for an errno: "disk full", "file too large: ...", otherwise the system's text.
std::string describeError(int error);

}  // namespace render
