/// Pictures to a film: raw frames through a pipe to a child ffmpeg, no PNG in between.
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

/// Whether the ending names a film this program writes: .mp4 .webm .gif .webp .apng
bool isVideoName(const std::filesystem::path& path);

/// A film that is whole after close() and absent otherwise: written beside the target under a
/// temporary name, renamed at the end. Every member may throw Error with ffmpeg's own last words;
/// nothing is left behind then.
///
/// A GIF, whose palette comes from all its frames, and a film that has to fit into so many bytes
/// are stored without loss in a nameless file beside the target and encoded by close().
class VideoWriter {
public:
    /// `source.fps`: 1..240, of a GIF 1..50; `source.alpha`: the film shows what is behind it, in
    /// straight form, of which a GIF has yes or no and a .mp4 nothing (Error). `patience`: a child
    /// that neither takes frames nor uses processor time for so long is taken for hanging, and
    /// ended.
    VideoWriter(const std::filesystem::path& path, const VideoSource& source,
                std::chrono::milliseconds patience = ffmpegPatience());
    /// The same, with a limit.
    VideoWriter(const std::filesystem::path& path, const VideoSource& source, const Fit& fit,
                std::chrono::milliseconds patience = ffmpegPatience());
    ~VideoWriter();
    VideoWriter(const VideoWriter&) = delete;
    VideoWriter& operator=(const VideoWriter&) = delete;

    /// Appends one frame of the size given above.
    void add(const Image& image);

    /// Waits for ffmpeg, checks its exit status, its count of frames and its file, renames.
    void close(Existing existing = Existing::replaced);

    /// Ends ffmpeg and removes the unfinished file; also what the destructor does without close().
    void abandon() noexcept;

    int frames() const { return frames_; }  // taken so far

    /// After close(), of a film with a limit: "7.6 MB: 640x360, 15 frames/s, 128 colours".
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
    std::unique_ptr<Descriptor> held_;  // the temporary file, so that others leave it alone
    int frames_ = 0;
    std::unique_ptr<Descriptor> store_;  // empty: encoded as the frames come
    std::unique_ptr<Ffmpeg> ffmpeg_;     // empty after close() and abandon()
    std::optional<Fitted> fitted_;
};

}  // namespace render
