/// The kinds of film files by their extension, and the arguments with which ffmpeg writes them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "render/encode/chapters.h"

namespace render {

/// The encodings: h264 and vp9 of films; gif, webp and apng of animated pictures.
enum class Codec { h264, vp9, gif, webp, apng };

/// One kind of film file.
struct VideoFormat {
    const char* ending;     // ".mp4"
    Codec codec;
    const char* evenSides;  // the codec that needs even sides, or null
    int largestFps;         // frames per second
    bool holdsAlpha;        // straight alpha; for a GIF on or off
};

/// Found by the extension, in upper or lower case; null: not a film this program can write.
const VideoFormat* videoFormatOf(const std::filesystem::path& path);

/// The pictures of a film, as they come in.
struct VideoSource {
    int width = 0, height = 0;  // pixels
    int fps = 30;               // frames per second
    bool alpha = false;         // the film has transparency
    int keyEvery = 0;  // largest distance of key frames, for mp4 and webm: the smaller, the better
                       // players can step backwards; 0: the codec's default
    std::vector<Chapter> chapters = {};  // for mp4 and webm
};

/// How they are encoded: unchanged, or reduced for a smaller file.
struct Encoding {
    int width = 0, height = 0;  // pixels
    int everyNth = 1;           // of this many frames, one is kept
    double fps = 30.0;          // frames per second
    int quality = 0;  // gif: colours; mp4, webm: crf, less is better; webp: 0..100; apng: none

    bool operator==(const Encoding&) const = default;
    int framesOf(int frames) const { return (frames + everyNth - 1) / everyNth; }  // kept ones
};

/// From the best to the smallest. Each step gives up what viewers miss least: first exactness, then
/// every other frame, then size.
std::vector<Encoding> ladderOf(const VideoFormat& format, const VideoSource& source);

/// "640x360, 15 frames/s, 128 colours"
std::string describe(const VideoFormat& format, const Encoding& encoding);

using Arguments = std::vector<std::string>;  // of a child process, without its name

/// Whether encodeArguments() takes frames as toYuv420() makes them, and not as RGBA: the encoder
/// needs them so, and no alpha is lost. ffmpeg's own conversion takes four times as long.
bool takesYuv(const VideoFormat& format, const VideoSource& source);

/// To write frames from standard input as a film: `encoding` is the first of ladderOf().
Arguments encodeArguments(const VideoFormat& format, const VideoSource& source,
                          const Encoding& encoding, const std::filesystem::path& output);

/// To store frames from standard input in the descriptor `file` without loss: a tenth to a
/// hundredth of their size in memory.
Arguments storeArguments(const VideoSource& source, int file);

/// To encode stored frames as a film.
Arguments restoreArguments(const VideoFormat& format, const VideoSource& source,
                           const Encoding& encoding, int file, const std::filesystem::path& output);

}  // namespace render
