/// Files that are either whole or absent: temporary name, write, close, rename.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace render {

/// Replaces `path` by a file with this content in one step; a reader, or a run killed half way,
/// sees the old file or the new one. The folder must exist.
/// Throws Error (path and reason) when the target is a symlink, a directory or a device, or when
/// the disk is full; then neither a temporary file nor a half-written one is left.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// A file to be, and what it is to hold.
struct NamedBytes {
    std::filesystem::path path;           ///< replaced where it is there
    std::span<const std::uint8_t> bytes;  ///< all of it
};

/// Several such files: all of them are complete under their temporary names before the first one is
/// renamed, so that a full disk leaves none.
void writeFilesTogether(std::span<const NamedBytes> files);

/// The same for a text.
inline void writeFileAtomically(const std::filesystem::path& path, std::string_view text) {
    writeFileAtomically(path,
                        std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

/// The folder and its parents; what is there stays. Throws Error.
void makeFolder(const std::filesystem::path& folder);

/// Throws Error unless `path` is free or an ordinary file that may be replaced.
void checkReplaceable(const std::filesystem::path& path);

/// The name a file carries until it is whole: beside the target (rename does not cross disks),
/// with the number of this process.
std::filesystem::path temporaryNameFor(const std::filesystem::path& path);

/// Creates a new `temporary` and opens it for writing, never through a symlink. A file left there
/// by a killed run of the same process number is removed first. `target` is for the message.
int createTemporary(const std::filesystem::path& temporary, const std::filesystem::path& target);

/// A file without a name on the disk of `target`: it is gone with its last descriptor, however a
/// run ends. Open for reading and writing.
int createUnnamed(const std::filesystem::path& target);

/// Marks a temporary file as being written for as long as `file` is open; see sweepTemporaries().
void holdTemporary(int file);

/// Removes the temporaries of `path` that killed runs have left. True when another run holds one.
bool sweepTemporaries(const std::filesystem::path& path);

/// One line for an errno: "disk full", "file too large: ...", otherwise the system's text.
std::string describeError(int error);

}  // namespace render
