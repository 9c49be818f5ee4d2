#include "render/encode/video.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <vector>

#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/error.h"

namespace render {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

struct Format {
    const char* ending;
    const char* evenSides;  // the codec that needs them, or null
    int largestFps;
    Arguments options;
};

// Without these ffmpeg converts by the matrix of standard definition, and players guess another.
// The flags make the conversion the same on every CPU.
const char* const kToYuv =
    "scale=in_range=full:out_range=tv:out_color_matrix=bt709:"
    "flags=bicubic+accurate_rnd+full_chroma_int+bitexact,format=yuv420p";

// One palette for the whole film, of what moves; ordered dither stays still between frames.
// split keeps all frames in memory until the palette is known: about 4 bytes a pixel and frame.
const char* const kPalette =
    "split[a][b];[a]palettegen=stats_mode=diff[p];"
    "[b][p]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle";

Arguments yuv(Arguments codec) {
    Arguments all = {"-vf",   kToYuv,       "-colorspace", "bt709",        "-color_primaries",
                     "bt709", "-color_trc", "bt709",       "-color_range", "tv"};
    all.insert(all.end(), codec.begin(), codec.end());
    return all;
}

const std::vector<Format>& formats() {
    // GIF counts hundredths of a second, and browsers slow a frame shorter than two to ten
    static const std::vector<Format> all = {
        {".mp4", "H.264", 240,
         yuv({"-c:v", "libx264", "-preset", "fast", "-crf", "18", "-movflags", "+faststart", "-f",
              "mp4"})},
        {".webm", "VP9", 240,
         yuv({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used",
              "5", "-f", "webm"})},
        {".gif", nullptr, 50, {"-vf", kPalette, "-loop", "0", "-f", "gif"}},
        {".webp",
         nullptr,
         240,
         {"-c:v", "libwebp_anim", "-pix_fmt", "bgra", "-quality", "90", "-loop", "0", "-f",
          "webp"}},
        {".apng", nullptr, 240, {"-c:v", "apng", "-plays", "0", "-f", "apng"}},
    };
    return all;
}

const Format* formatOf(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    for (const Format& format : formats()) {
        if (ending == format.ending) return &format;
    }
    return nullptr;
}

std::string sizeText(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

void checkFilm(const fs::path& path, const Format* format, int width, int height, int fps) {
    if (!format) {
        throw Error("film " + quoted(path) + ": unknown ending; use .mp4 .webm .gif .webp .apng");
    }
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
        throw Error("film " + quoted(path) + ": " + std::to_string(fps) + " frames a second; a " +
                    format->ending + " takes 1.." + std::to_string(format->largestFps));
    }
}

Arguments commandLine(const Format& format, const fs::path& output, int width, int height,
                      int fps) {
    // rgb0 is RGBA whose fourth byte is ignored: the picture goes out as it lies in memory.
    Arguments all = {"ffmpeg",
                     "-nostdin",
                     "-hide_banner",
                     "-xerror",
                     "-loglevel",
                     "error",
                     "-y",
                     "-progress",
                     "pipe:1",
                     "-f",
                     "rawvideo",
                     "-pixel_format",
                     "rgb0",
                     "-video_size",
                     sizeText(width, height),
                     "-framerate",
                     std::to_string(fps),
                     "-i",
                     "-",
                     "-an"};
    // The encoders' bits depend on the number of threads, by default that of the machine.
    const Arguments sameBits = {"-threads", "4",         "-map_metadata", "-1",
                                "-fflags",  "+bitexact", "-flags:v",      "+bitexact"};
    all.insert(all.end(), sameBits.begin(), sameBits.end());
    all.insert(all.end(), format.options.begin(), format.options.end());
    all.push_back("file:" + output.string());  // names that begin with '-' or hold ':'
    return all;
}

}  // namespace

VideoWriter::VideoWriter(const fs::path& path, int width, int height, int fps,
                         std::chrono::milliseconds patience)
    : target_(path), temporary_(temporaryNameFor(path)), width_(width), height_(height) {
    const Format* format = formatOf(path);
    checkFilm(path, format, width, height, fps);
    checkReplaceable(path);
    // Made here and not by ffmpeg, which would write through a symlink.
    ::close(createTemporary(temporary_, path));
    try {
        ffmpeg_ = std::make_unique<Ffmpeg>(commandLine(*format, temporary_, width, height, fps),
                                           patience);
    } catch (...) {
        ::unlink(temporary_.c_str());
        throw;
    }
}

VideoWriter::~VideoWriter() { abandon(); }

void VideoWriter::add(const Image& image) {
    if (!ffmpeg_) throw Error("film " + quoted(target_) + " is closed; add frames before close()");
    checkSize(image);
    if (image.width != width_ || image.height != height_) {
        throw Error("film " + quoted(target_) + ": frame of " +
                    sizeText(image.width, image.height) + " in a film of " +
                    sizeText(width_, height_));
    }
    if (!ffmpeg_->send(image.pixels)) {
        ffmpeg_->finish();
        fail();
    }
    ++frames_;
}

void VideoWriter::close() {
    if (!ffmpeg_) return;
    if (frames_ == 0) {
        abandon();
        throw Error("film " + quoted(target_) + ": no frames; a film needs at least one");
    }
    if (!ffmpeg_->finish()) fail();
    const int written = ffmpeg_->framesWritten();
    if (written != frames_) {
        abandon();
        throw Error("film " + quoted(target_) + ": ffmpeg wrote " + std::to_string(written) +
                    " of " + std::to_string(frames_) + " frames; draw it again");
    }
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
        const int error = errno;
        abandon();
        throw Error("cannot write " + quoted(target_) + ": " + describeError(error));
    }
    ffmpeg_.reset();
}

void VideoWriter::abandon() noexcept {
    if (!ffmpeg_) return;
    ffmpeg_.reset();
    ::unlink(temporary_.c_str());
}

void VideoWriter::fail() {
    const std::string why = ffmpeg_->complaint();
    abandon();
    throw Error("film " + quoted(target_) + ": " + why);
}

bool isVideoName(const fs::path& path) { return formatOf(path) != nullptr; }

}  // namespace render
