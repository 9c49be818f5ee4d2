/// Reads the archives that the program writes.
#pragma once
#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace support {

using Bytes = std::vector<std::uint8_t>;

/// The least byte comes first.
inline std::uint32_t numberAt(const Bytes& bytes, std::size_t at, int size) {
    std::uint32_t value = 0;
    for (int i = 0; i < size; ++i) value |= static_cast<std::uint32_t>(bytes[at + i]) << (8 * i);
    return value;
}

/// Unpacks from the directory at the end, as unzip does; checks checksums and entry headers.
inline std::map<std::string, Bytes> unzipped(const Bytes& zip) {
    std::map<std::string, Bytes> entries;
    const std::size_t end = zip.size() - 22;
    EXPECT_EQ(numberAt(zip, end, 4), 0x06054b50u);
    std::size_t at = numberAt(zip, end + 16, 4);
    EXPECT_EQ(at + numberAt(zip, end + 12, 4), end);
    libdeflate_decompressor* unpacker = libdeflate_alloc_decompressor();
    for (std::uint32_t i = 0; i < numberAt(zip, end + 10, 2); ++i) {
        EXPECT_EQ(numberAt(zip, at, 4), 0x02014b50u);
        const std::size_t name = numberAt(zip, at + 28, 2), local = numberAt(zip, at + 42, 4);
        EXPECT_EQ(numberAt(zip, local, 4), 0x04034b50u);
        EXPECT_TRUE(std::equal(zip.begin() + static_cast<std::ptrdiff_t>(at) + 6,
                               zip.begin() + static_cast<std::ptrdiff_t>(at) + 32,
                               zip.begin() + static_cast<std::ptrdiff_t>(local) + 4));
        Bytes content(numberAt(zip, at + 24, 4));
        EXPECT_EQ(libdeflate_deflate_decompress(unpacker, &zip[local + 30 + name],
                                                numberAt(zip, at + 20, 4), content.data(),
                                                content.size(), nullptr),
                  LIBDEFLATE_SUCCESS);
        EXPECT_EQ(libdeflate_crc32(0, content.data(), content.size()), numberAt(zip, at + 16, 4));
        entries[std::string(&zip[at + 46], &zip[at + 46] + name)] = content;
        at += 46 + name;
    }
    libdeflate_free_decompressor(unpacker);
    EXPECT_EQ(at, end);
    return entries;
}

}  // namespace support
