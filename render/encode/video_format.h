/// What a film file can hold, by its ending, and how ffmpeg is told to write it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace render {

/// How pictures are encoded: h264, vp9, and the three that hold pictures: gif, webp, apng.
enum class Codec { h264, vp9, gif, webp, apng };

/// One kind of film file.
struct VideoFormat {
    const char* ending;     // ".mp4"
    Codec codec;
    const char* evenSides;  // the codec that needs them, or null
    int largestFps;         // frames a second
    bool holdsAlpha;        // straight alpha, of a GIF yes or no
};

/// By the ending, in any case; null: no film this program writes.
const VideoFormat* videoFormatOf(const std::filesystem::path& path);

/// The pictures that come in.
struct VideoSource {
    int width = 0, height = 0;  // pixels
    int fps = 30;               // frames a second
    bool alpha = false;         // the film shows what is behind it
    int keyEvery = 0;  // frames from one that stands alone to the next, at most: mp4 and webm, in
                       // which players step backwards the better the fewer; 0: as the codec does
};

/// How they are encoded: as they are, or as less, so that the file gets smaller.
struct Encoding {
    int width = 0, height = 0;  // pixels
    int everyNth = 1;           // frame is kept
    double fps = 30.0;          // frames a second
    int quality = 0;  // gif: colours; mp4, webm: crf, less is better; webp: 0..100; apng: none

    bool operator==(const Encoding&) const = default;
    int framesOf(int frames) const { return (frames + everyNth - 1) / everyNth; }  // are kept
};

/// From the best to the smallest: each gives up what is missed least, first exactness, then every
/// other frame, then size.
std::vector<Encoding> ladderOf(const VideoFormat& format, const VideoSource& source);

/// "640x360, 15 frames/s, 128 colours"
std::string describe(const VideoFormat& format, const Encoding& encoding);

using Arguments = std::vector<std::string>;  // of a child process, without its name

/// Frames from standard input into a film.
Arguments encodeArguments(const VideoFormat& format, const VideoSource& source,
                          const Encoding& encoding, const std::filesystem::path& output);

/// Frames from standard input into the file number `file`, without loss: a tenth to a hundredth of
/// the pictures in memory.
Arguments storeArguments(const VideoSource& source, int file);

/// And from there into a film.
Arguments restoreArguments(const VideoFormat& format, const VideoSource& source,
                           const Encoding& encoding, int file, const std::filesystem::path& output);

}  // namespace render
