/// A ZIP archive in memory, such as a .npz.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace demos {

struct ZipEntry {
    std::string name;  // UTF-8
    std::vector<std::uint8_t> bytes;
};

/// The same entries give the same bytes: they have no times. Throws render::Error if an archive
/// without the 64-bit extensions cannot hold them.
std::vector<std::uint8_t> zipOf(std::span<const ZipEntry> entries);

}  // namespace demos
