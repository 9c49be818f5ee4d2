/// A ZIP archive in memory: what a .npz is.
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

/// The same bytes for the same entries: they carry no times. Throws render::Error where an archive
/// without the 64-bit extensions cannot hold them.
std::vector<std::uint8_t> zipOf(std::span<const ZipEntry> entries);

}  // namespace demos
