/// A stored film made as good as a number of bytes allows.
#pragma once
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "render/encode/ffmpeg.h"
#include "render/encode/video_format.h"
#include "render/error.h"

namespace render {

/// Thrown where the caller did not want to wait any longer.
class Cancelled : public Error {
public:
    using Error::Error;
};

/// Frames that ffmpeg has written as storeArguments() says.
struct StoredFilm {
    const Descriptor& file;
    VideoSource source;
    int frames = 0;
    std::chrono::milliseconds patience;
};

struct Fit {
    std::uint64_t largestFile = 0;                      // bytes; 0: no limit, the best there is
    std::function<bool()> cancelled = {};               // asked ten times a second
    std::function<void(const std::string&)> tell = {};  // what did not fit
};

struct Fitted {
    Encoding encoding;
    std::uint64_t bytes = 0;
};

/// Fills `output`, an empty file. Tries the best encoding and then, by halving what
/// is left of ladderOf(), the best of those that fit.
/// Throws Cancelled, and Error when even the last one is too large or ffmpeg fails.
Fitted encodeToFit(const StoredFilm& film, const VideoFormat& format, const Fit& fit,
                   const std::filesystem::path& output);

/// "7.6 MB", "830 kB", "12 bytes": 1 kB = 1000 bytes.
std::string bytesText(std::uint64_t bytes);

}  // namespace render
