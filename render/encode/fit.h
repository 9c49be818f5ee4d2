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
    const Descriptor& file;              // open for reading
    VideoSource source;
    int frames = 0;                      // in the file
    std::chrono::milliseconds patience;  // with ffmpeg, as a VideoWriter's
};

/// How large a film may be, and who is asked and told on the way.
struct Fit {
    std::uint64_t largestFile = 0;                      // bytes; 0: no limit, the best there is
    std::function<bool()> cancelled = {};               // asked ten times a second
    std::function<void(const std::string&)> tell = {};  // what did not fit
};

/// What a film became.
struct Fitted {
    Encoding encoding;
    std::uint64_t bytes = 0;  // of the file
};

/// Fills `output`, an empty file. Tries the best encoding and then, by halving what
/// is left of ladderOf(), the best of those that fit.
/// Throws Cancelled, and Error when even the last one is too large or ffmpeg fails.
Fitted encodeToFit(const StoredFilm& film, const VideoFormat& format, const Fit& fit,
                   const std::filesystem::path& output);

/// "7.6 MB", "830 kB", "12 bytes": 1 kB = 1000 bytes.
std::string bytesText(std::uint64_t bytes);

}  // namespace render
