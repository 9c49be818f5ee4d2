/// Pictures to a film: raw frames through a pipe to a child ffmpeg, no PNG in between.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>

#include "render/image.h"

namespace render {

class Ffmpeg;

/// Whether the ending names a film this program writes: .mp4 .webm .gif .webp .apng
bool isVideoName(const std::filesystem::path& path);

/// A film that is whole after close() and absent otherwise: written beside the target under a
/// temporary name, renamed at the end. Every member may throw Error with ffmpeg's own last words;
/// nothing is left behind then.
class VideoWriter {
public:
    /// width, height: pixels; fps: 1..240, of a GIF 1..50. `patience`: a child that neither takes
    /// frames nor uses processor time for so long is taken for hanging, and ended.
    VideoWriter(const std::filesystem::path& path, int width, int height, int fps,
                std::chrono::milliseconds patience = std::chrono::seconds(60));
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Appends one frame of the size given above; alpha is ignored.
    void add(const Image& image);

    /// Waits for ffmpeg, checks its exit status and its count of frames, renames.
    void close();

    /// Ends ffmpeg and removes the unfinished file; also what the destructor does without close().
    void abandon() noexcept;

    int frames() const { return frames_; }  // taken so far

private:
    [[noreturn]] void fail();

    std::filesystem::path target_, temporary_;
    int width_, height_;
    int frames_ = 0;
    std::unique_ptr<Ffmpeg> ffmpeg_;  // empty after close() and abandon()
};

}  // namespace render
