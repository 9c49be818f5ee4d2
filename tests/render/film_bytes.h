/// Reads films back: with ffmpeg, and byte by byte where ffmpeg cannot.
#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "render/encode/ffmpeg.h"
#include "render/image.h"

#define NEED_FFMPEG() \
    if (!render::haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed (apt install ffmpeg)"

namespace film_bytes {

namespace fs = std::filesystem;

inline std::string contentOf(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Every frame, as RGBA.
inline std::vector<render::Image> decoded(const fs::path& film, int width, int height) {
    const bool vp9 = film.extension() == ".webm";  // ffmpeg's own decoder of VP9 drops alpha
    const std::string command = std::string("ffmpeg -nostdin -v error ") +
                                (vp9 ? "-c:v libvpx-vp9 " : "") + "-i 'file:" + film.string() +
                                "' -vsync passthrough -f rawvideo -pix_fmt rgba -";
    FILE* pipe = ::popen(command.c_str(), "r");
    std::vector<render::Image> frames;
    const std::size_t bytes = std::size_t{4} * width * height;
    while (true) {
        render::Image image{width, height, std::vector<std::uint8_t>(bytes)};
        if (std::fread(image.pixels.data(), 1, bytes, pipe) != bytes) break;
        frames.push_back(std::move(image));
    }
    EXPECT_EQ(::pclose(pipe), 0) << film;
    return frames;
}

inline unsigned byteAt(const std::string& bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0u;
}

/// The position of `mark`; if it is missing, a failure and the file's end.
inline std::size_t find(const std::string& bytes, const std::string& mark) {
    const std::size_t at = bytes.find(mark);
    EXPECT_NE(at, std::string::npos) << mark;
    return std::min(at, bytes.size());
}

/// The delay of each frame of a GIF in hundredths of a second: graphic control extensions,
/// 21 F9 04 flags delay(2) transparent 00.
inline std::vector<unsigned> gifDelays(const std::string& gif) {
    std::vector<unsigned> delays;
    const std::string mark("\x21\xf9\x04", 3);
    for (std::size_t at = gif.find(mark); at != std::string::npos; at = gif.find(mark, at + 1))
        if (byteAt(gif, at + 7) == 0)
            delays.push_back(byteAt(gif, at + 4) + 256 * byteAt(gif, at + 5));
    return delays;
}

}  // namespace film_bytes
