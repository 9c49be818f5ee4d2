#include "render/encode/video.h"

#include <unistd.h>

#include <cerrno>
#include <string>

#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/encode/film_file.h"
#include "render/encode/png.h"
#include "render/encode/yuv.h"
#include "render/error.h"

namespace render {
namespace {

namespace fs = std::filesystem;

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

void checkFilm(const fs::path& path, const VideoFormat* format, const VideoSource& source) {
    if (!format) {
        throw Error("film " + quoted(path) + ": unknown file extension; use .mp4 .webm .gif .webp .apng");
    }
    const int width = source.width, height = source.height, fps = source.fps;
    const std::string size = sizeText(width, height);
    if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide) {
        throw Error("film size " + size + ": each side must be within 1..16384 pixels");
    }
    if (format->evenSides && (width % 2 != 0 || height % 2 != 0)) {
        throw Error(size + " has an odd side; " + format->evenSides +
                    " with 4:2:0 needs even sizes, use " +
                    sizeText(width + width % 2, height + height % 2));
    }
    if (fps < 1 || fps > format->largestFps) {
        throw Error("film " + quoted(path) + ": " + std::to_string(fps) + " frames per second; a " +
                    format->ending + " takes 1.." + std::to_string(format->largestFps));
    }
    if (source.alpha && !format->holdsAlpha) {
        throw Error("film " + quoted(path) + ": a " + format->ending +
                    " holds no alpha; use .webm, .webp, .apng or .gif");
    }
}

}  // namespace

VideoWriter::VideoWriter(const fs::path& path, const VideoSource& source,
                         std::chrono::milliseconds patience)
    : VideoWriter(path, source, Fit{}, patience) {}

VideoWriter::VideoWriter(const fs::path& path, const VideoSource& source, const Fit& fit,
                         std::chrono::milliseconds patience)
    : target_(path),
      temporary_(temporaryNameFor(path)),
      source_(source),
      fit_(fit),
      patience_(patience),
      format_(videoFormatOf(path)) {
    checkFilm(path, format_, source);
    checkReplaceable(path);
    // Created here and not by ffmpeg, which would write through a symlink.
    held_ = std::make_unique<Descriptor>(createTemporary(temporary_, path), "write a film");
    try {
        start();
    } catch (...) {
        ::unlink(temporary_.c_str());
        throw;
    }
}

VideoWriter::~VideoWriter() { abandon(); }

void VideoWriter::start() {
    if (fit_.largestFile > 0 || format_->codec == Codec::gif) {
        store_ = std::make_unique<Descriptor>(createUnnamed(target_), "keep a film's frames");
        ffmpeg_ = std::make_unique<Ffmpeg>(storeArguments(source_, Ffmpeg::kSharedFile), patience_,
                                           store_.get());
    } else {
        yuv_ = takesYuv(*format_, source_);
        const Encoding best = ladderOf(*format_, source_).front();
        ffmpeg_ = std::make_unique<Ffmpeg>(encodeArguments(*format_, source_, best, temporary_),
                                           patience_);
    }
}

void VideoWriter::add(const Image& image) {
    if (!ffmpeg_) throw Error("film " + quoted(target_) + " is closed; add frames before close()");
    checkSize(image);
    if (image.width != source_.width || image.height != source_.height) {
        throw Error("film " + quoted(target_) + ": frame of " +
                    sizeText(image.width, image.height) + " in a film of " +
                    sizeText(source_.width, source_.height));
    }
    if (yuv_) toYuv420(image, planes_);
    if (!ffmpeg_->send(yuv_ ? planes_ : image.pixels)) {
        ffmpeg_->finish();
        failFeeding();
    }
    ++frames_;
}

void VideoWriter::close(Existing existing) {
    if (!ffmpeg_) return;
    if (frames_ == 0) fail("no frames; a film needs at least one");
    bool cancelled = false;
    if (!ffmpeg_->finish([&] { return cancelled = fit_.cancelled && fit_.cancelled(); })) {
        if (!cancelled) failFeeding();
        abandon();
        throw Cancelled("interrupted while ffmpeg finished film " + quoted(target_));
    }
    const int written = ffmpeg_->framesWritten();
    if (written != frames_) {
        fail("ffmpeg wrote " + std::to_string(written) + " of " + std::to_string(frames_) +
             " frames; draw it again");
    }
    if (store_) encodeStored();
    if (!filmIsWhole(*format_, held_->number()))
        fail("ffmpeg reported " + std::to_string(written) +
             " frames but left no complete film; check that 'ffmpeg' on the PATH is the real one");
    try {
        publish(temporary_, target_, existing);
    } catch (const Error&) {
        abandon();
        throw;
    }
    // An encoder whose parent was killed may have created its file after this run's first sweep.
    sweepTemporaries(target_);
    ffmpeg_.reset();
    store_.reset();
}

void VideoWriter::encodeStored() {
    Fit fit = fit_;
    if (fit_.tell)
        fit.tell = [this](const std::string& line) { fit_.tell(quoted(target_) + ": " + line); };
    try {
        fitted_ = encodeToFit({*store_, source_, frames_, patience_}, *format_, fit, temporary_);
    } catch (const Cancelled& cancelled) {
        abandon();
        throw Cancelled("film " + quoted(target_) + ": " + cancelled.what());
    } catch (const Error& error) {
        fail(error.what());
    }
}

void VideoWriter::abandon() noexcept {
    if (!ffmpeg_) return;
    ffmpeg_.reset();
    store_.reset();
    ::unlink(temporary_.c_str());
}

void VideoWriter::failFeeding() {
    fail((store_ ? "its frames cannot be stored next to it: " : "") + ffmpeg_->complaint());
}

void VideoWriter::fail(const std::string& why) {
    const std::string line = "film " + quoted(target_) + ": " + why;
    abandon();
    throw Error(line);
}

std::string VideoWriter::summary() const {
    if (!fitted_) return {};
    return bytesText(fitted_->bytes) + ": " + describe(*format_, fitted_->encoding);
}

bool isVideoName(const fs::path& path) { return videoFormatOf(path) != nullptr; }

}  // namespace render
