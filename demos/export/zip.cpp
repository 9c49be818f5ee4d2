// APPNOTE.TXT of PKWARE, 4.3: every entry is a header and its deflated bytes; a directory repeats
// the headers with their offsets, and a record at the end says where it is. libdeflate, which also
// packs the pictures, does the hard part; libzip would be one more dependency and as many lines.
#include "demos/export/zip.h"

#include <libdeflate.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <new>

#include "demos/text/little_endian.h"
#include "render/error.h"

namespace demos {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t sizeInZip(std::size_t value) {
    if (value > std::numeric_limits<std::uint32_t>::max())
        throw render::Error("an archive cannot exceed 4 GiB; use fewer frames (--fps, --seconds)");
    return static_cast<std::uint32_t>(value);
}

Bytes deflated(const Bytes& bytes) {
    constexpr int kLevel = 6;  // of 12, the library's default
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kLevel), &libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    Bytes out(libdeflate_deflate_compress_bound(compressor.get(), bytes.size()));
    out.resize(libdeflate_deflate_compress(compressor.get(), bytes.data(), bytes.size(), out.data(),
                                           out.size()));
    return out;
}

/// The common part of an entry's header and its directory record.
Bytes describe(const ZipEntry& entry, std::size_t packedSize) {
    constexpr std::uint32_t kVersion20 = 20, kUtf8 = 0x800, kDeflate = 8, kFirstOf1980 = 0x21;
    Bytes out;
    for (const std::uint32_t word : {kVersion20, kUtf8, kDeflate, 0u, kFirstOf1980})
        putBytes(out, word, 2);
    putBytes(out, libdeflate_crc32(0, entry.bytes.data(), entry.bytes.size()), 4);
    putBytes(out, sizeInZip(packedSize), 4);
    putBytes(out, sizeInZip(entry.bytes.size()), 4);
    putBytes(out, static_cast<std::uint32_t>(entry.name.size()), 2);
    putBytes(out, 0, 2);  // no extra fields
    return out;
}

void append(Bytes& out, const auto& bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

}  // namespace

std::vector<std::uint8_t> zipOf(std::span<const ZipEntry> entries) {
    Bytes out, directory;
    for (const ZipEntry& entry : entries) {
        const Bytes packed = deflated(entry.bytes), description = describe(entry, packed.size());
        putBytes(directory, 0x02014b50, 4);
        putBytes(directory, 20, 2);  // made by version 2.0, on DOS
        append(directory, description);
        for (const int size : {2, 2, 2, 4}) putBytes(directory, 0, size);  // comment, disk, attributes
        putBytes(directory, sizeInZip(out.size()), 4);
        append(directory, entry.name);
        putBytes(out, 0x04034b50, 4);
        append(out, description);
        append(out, entry.name);
        append(out, packed);
    }
    const std::size_t start = out.size(), count = entries.size();
    append(out, directory);
    putBytes(out, 0x06054b50, 4);
    for (const std::size_t word : {std::size_t{0}, std::size_t{0}, count, count})
        putBytes(out, static_cast<std::uint32_t>(word), 2);
    putBytes(out, sizeInZip(directory.size()), 4);
    putBytes(out, sizeInZip(start), 4);
    putBytes(out, 0, 2);  // no comment
    return out;
}

}  // namespace demos
