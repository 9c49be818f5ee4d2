/// Writes pictures as a film: raw frames go to a child ffmpeg, without PNGs in between.
#pragma once
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/encode/fit.h"
#include "render/encode/video_format.h"
#include "render/image.h"

namespace render {

/// Whether the path ends like a film this program can write: .mp4 .webm .gif .webp .apng
bool isVideoName(const std::filesystem::path& path);

/// A film that is complete after close() and absent otherwise: it is written next to the target
/// under a temporary name and renamed at the end. Every member may throw Error with ffmpeg's last
/// message; no file is left then.
///
/// A GIF, whose palette comes from all its frames, and a film with a size limit are first stored
/// without loss in an unnamed file next to the target, and encoded by close().
class VideoWriter {
public:
    /// `source.fps`: 1..240, for a GIF 1..50. `source.alpha`: the film has straight alpha; in a GIF
    /// it is only on or off, an .mp4 has none (Error). `patience`: a child that neither takes
    /// frames nor uses processor time for this long counts as hanging and is killed.
    VideoWriter(const std::filesystem::path& path, const VideoSource& source,
                std::chrono::milliseconds patience = ffmpegPatience());
    /// The same, with a size limit.
    VideoWriter(const std::filesystem::path& path, const VideoSource& source, const Fit& fit,
                std::chrono::milliseconds patience = ffmpegPatience());
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Appends one frame of the size given above.
    void add(const Image& image);

    /// Waits for ffmpeg, checks its exit status, its number of frames and its file, and renames it.
    void close(Existing existing = Existing::replaced);

    /// Kills ffmpeg and removes the unfinished file. The destructor does so without close().
    void abandon() noexcept;

    int frames() const { return frames_; }  // added so far

    /// After close(), for a film with a limit: "7.6 MB: 640x360, 15 frames/s, 128 colours".
    std::string summary() const;

private:
    void start();
    void encodeStored();
    [[noreturn]] void failFeeding();
    [[noreturn]] void fail(const std::string& why);

    std::filesystem::path target_, temporary_;
    VideoSource source_;
    Fit fit_;
    std::chrono::milliseconds patience_;
    const VideoFormat* format_;
    std::unique_ptr<Descriptor> held_;  // the temporary file, locked against other runs
    int frames_ = 0;
    std::unique_ptr<Descriptor> store_;  // null: frames are encoded as they come
    bool yuv_ = false;                   // frames are sent as planes, and not as RGBA
    std::vector<std::uint8_t> planes_;   // of the last frame
    std::unique_ptr<Ffmpeg> ffmpeg_;     // null after close() and abandon()
    std::optional<Fitted> fitted_;
};

}  // namespace render
