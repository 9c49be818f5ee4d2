/// Encodes a stored film in the best quality that fits into a number of bytes.
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

/// Thrown when the caller cancels the encoding.
class Cancelled : public Error {
public:
    using Error::Error;
};

/// Frames that ffmpeg has written with storeArguments().
struct StoredFilm {
    const Descriptor& file;              // open for reading
    VideoSource source;
    int frames = 0;                      // in the file
    std::chrono::milliseconds patience;  // with ffmpeg, as in VideoWriter
};

/// The size limit of a film, and callbacks during encoding.
struct Fit {
    std::uint64_t largestFile = 0;                      // bytes; 0: no limit, best quality
    std::function<bool()> cancelled = {};               // called ten times a second
    std::function<void(const std::string&)> tell = {};  // called for encodings that do not fit
};

/// How a film was encoded.
struct Fitted {
    Encoding encoding;
    std::uint64_t bytes = 0;  // of the file
};

/// Fills `output`, an empty file. Tries the best encoding first; if it is too large, finds the best
/// one of ladderOf() that fits by bisection.
/// Throws Cancelled; throws Error if even the last one is too large or ffmpeg fails.
Fitted encodeToFit(const StoredFilm& film, const VideoFormat& format, const Fit& fit,
                   const std::filesystem::path& output);

/// "7.6 MB", "830 kB", "12 bytes": 1 kB = 1000 bytes.
std::string bytesText(std::uint64_t bytes);

}  // namespace render
