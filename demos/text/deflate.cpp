#include "demos/text/deflate.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <new>

namespace demos {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) {
    constexpr int kSmall = 9;  // of 12: higher levels take ten times as long to save a hundredth
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(kSmall), &libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    std::vector<std::uint8_t> out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(),
                                        out.size()));
    return out;
}

std::optional<std::vector<std::uint8_t>> inflated(std::span<const std::uint8_t> bytes,
                                                  std::size_t most) {
    const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)>
        decompressor(libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
    if (!decompressor) throw std::bad_alloc();
    std::vector<std::uint8_t> out;
    // The stream does not store its length; one byte of it expands to at most 1032.
    for (std::size_t room = 8 * bytes.size() + 64;; room *= 4) {
        out.resize(std::min(room, most));
        std::size_t used = 0;
        const libdeflate_result result = libdeflate_zlib_decompress(
            decompressor.get(), bytes.data(), bytes.size(), out.data(), out.size(), &used);
        if (result == LIBDEFLATE_INSUFFICIENT_SPACE && room < most) continue;
        if (result != LIBDEFLATE_SUCCESS) return std::nullopt;
        out.resize(used);
        return out;
    }
}

}  // namespace demos
