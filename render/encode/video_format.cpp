#include "render/encode/video_format.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace render {
namespace {

constexpr bool kNoAlpha = false, kAlpha = true;

// GIF counts hundredths of a second, and browsers show frames shorter than two for ten
constexpr VideoFormat kFormats[] = {
    {".mp4", Codec::h264, "H.264", 240, kNoAlpha}, {".webm", Codec::vp9, "VP9", 240, kAlpha},
    {".gif", Codec::gif, nullptr, 50, kAlpha},     {".webp", Codec::webp, nullptr, 240, kAlpha},
    {".apng", Codec::apng, nullptr, 240, kAlpha},
};

/// A step of the ladder: the scale of the picture's sides, the lowest rate that leaving out frames
/// may give (0: none is left out), and the quality as in Encoding.
struct Rung {
    double side;
    int leastFps;
    int quality;
};

constexpr Rung kH264[] = {{1, 0, 18},     {1, 0, 23},    {1, 0, 28},    {1, 0, 33},
                          {0.75, 30, 33}, {0.5, 30, 33}, {0.5, 15, 36}, {0.25, 15, 40}};
constexpr Rung kVp9[] = {{1, 0, 24},     {1, 0, 32},    {1, 0, 40},    {1, 0, 48},
                         {0.75, 30, 48}, {0.5, 30, 50}, {0.5, 15, 55}, {0.25, 15, 60}};
constexpr Rung kGif[] = {{1, 0, 256},       {1, 0, 128},    {1, 15, 128},
                         {0.75, 15, 128},   {0.5, 15, 128}, {0.5, 10, 64},
                         {1.0 / 3, 10, 64}, {0.25, 10, 32}, {0.25, 5, 16}};
constexpr Rung kWebp[] = {{1, 0, 90},     {1, 0, 75},    {1, 0, 50},    {1, 15, 50},
                          {0.75, 15, 50}, {0.5, 15, 50}, {0.5, 10, 25}, {0.25, 10, 25}};
constexpr Rung kApng[] = {{1, 0, 0},    {1, 15, 0},   {0.75, 15, 0},
                          {0.5, 15, 0}, {0.5, 10, 0}, {0.25, 10, 0}};

std::span<const Rung> rungsOf(Codec codec) {
    switch (codec) {
        case Codec::h264:
            return kH264;
        case Codec::vp9:
            return kVp9;
        case Codec::gif:
            return kGif;
        case Codec::webp:
            return kWebp;
        case Codec::apng:
            break;
    }
    return kApng;
}

int scaled(int pixels, double share, bool even) {
    const double unit = even ? 2.0 : 1.0;
    return static_cast<int>(std::max(std::round(pixels * share / unit), 1.0) * unit);
}

Encoding encodingOf(const Rung& rung, const VideoFormat& format, const VideoSource& source) {
    Encoding encoding;
    const bool whole = rung.side == 1.0;
    const bool even = format.evenSides != nullptr;
    encoding.width = whole ? source.width : scaled(source.width, rung.side, even);
    encoding.height = whole ? source.height : scaled(source.height, rung.side, even);
    encoding.everyNth = rung.leastFps == 0 ? 1 : std::max(source.fps / rung.leastFps, 1);
    encoding.fps = static_cast<double>(source.fps) / encoding.everyNth;
    encoding.quality = rung.quality;
    return encoding;
}

std::string sizeText(int width, int height, const char* between) {
    return std::to_string(width) + between + std::to_string(height);
}

void append(Arguments& all, const Arguments& more) {
    all.insert(all.end(), more.begin(), more.end());
}

Arguments start() {
    return {"ffmpeg", "-nostdin", "-hide_banner", "-xerror", "-loglevel",
            "error",  "-y",       "-progress",    "pipe:1"};
}

Arguments rawInput(const VideoSource& source, const char* format) {
    return {"-f",
            "rawvideo",
            "-pixel_format",
            format,
            "-video_size",
            sizeText(source.width, source.height, "x"),
            "-framerate",
            std::to_string(source.fps),
            "-i",
            "-"};
}

/// rgb0 is RGBA whose fourth byte is ignored: the picture is sent as it is in memory.
const char* inMemory(const VideoSource& source) { return source.alpha ? "rgba" : "rgb0"; }

/// Leaves out frames and scales pictures down; ends with a comma unless it is empty. Scaling is
/// premultiplied, so that the colours of transparent pixels do not bleed into their neighbours.
std::string reduction(const VideoSource& source, const Encoding& encoding) {
    std::string chain;
    if (encoding.everyNth > 1) chain += "framestep=" + std::to_string(encoding.everyNth) + ",";
    if (encoding.width == source.width && encoding.height == source.height) return chain;
    const std::string scale = "scale=" + sizeText(encoding.width, encoding.height, ":") +
                              ":flags=area+accurate_rnd+full_chroma_int+bitexact,";
    if (!source.alpha) return chain + scale;
    return chain + "format=gbrap,premultiply=inplace=1," + scale + "unpremultiply=inplace=1,";
}

/// Without these players guess another matrix. toYuv420() and ffmpeg average four pixels.
Arguments colours() {
    return {"-colorspace",  "bt709", "-color_primaries",        "bt709",  "-color_trc", "bt709",
            "-color_range", "tv",    "-chroma_sample_location", "center"};
}

/// Without the matrix ffmpeg converts with that of standard definition. The flags make the
/// conversion the same on every CPU.
Arguments yuv(const VideoSource& source, const std::string& before, const Arguments& codec) {
    const std::string convert =
        "scale=in_range=full:out_range=tv:out_color_matrix=bt709:"
        "flags=bicubic+accurate_rnd+full_chroma_int+bitexact,format=";
    Arguments all = {"-vf", before + convert + (source.alpha ? "yuva420p" : "yuv420p")};
    append(all, colours());
    append(all, codec);
    return all;
}

/// The requested distance of key frames, counted in frames that are kept.
Arguments keyed(const VideoSource& source, const Encoding& encoding, const Arguments& codec) {
    if (source.keyEvery == 0) return codec;
    Arguments all = {"-g", std::to_string(encoding.framesOf(source.keyEvery))};
    append(all, codec);
    return all;
}

/// One palette for the whole film. Dithered, or from the moving parts alone, films of the built-in scenes have a lower PSNR
/// and larger files.
/// The frames are read twice, since a filter that splits them would keep all of them in memory.
std::string paletteGraph(const std::string& before, int colours) {
    return "[0:v]" + before + "palettegen=max_colors=" + std::to_string(colours) +
           "[p];[1:v]" + before +
           "null[v];[v][p]paletteuse=dither=none:diff_mode=rectangle";
}

Arguments rgb(const std::string& before, const char* format, const Arguments& codec) {
    Arguments all = {"-vf", before + "format=" + format};
    append(all, codec);
    return all;
}

/// x264 for pictures of which most stands still: what is spent on a still part serves until it
/// moves, so that a long look ahead and low qcomp pay most, then many B-frames without a search for
/// their number. Compared with the preset "fast": tests/benchmark/README.md.
constexpr const char* kStandingStill =
    "rc-lookahead=40:qcomp=0.5:bframes=7:b-adapt=0:weightp=0:chroma-qp-offset=-3";

/// Of a codec that takes YUV.
Arguments filmArguments(const VideoFormat& format, const VideoSource& source,
                        const Encoding& encoding) {
    const std::string quality = std::to_string(encoding.quality);
    if (format.codec == Codec::h264)
        return keyed(source, encoding,
                     {"-c:v", "libx264", "-preset", "veryfast", "-x264-params", kStandingStill,
                      "-crf", quality, "-movflags", "+faststart", "-f", "mp4"});
    return keyed(source, encoding,
                 {"-c:v", "libvpx-vp9", "-crf", quality, "-b:v", "0", "-deadline", "good",
                  "-cpu-used", "5", "-auto-alt-ref",  // no alternative frames with alpha
                  source.alpha ? "0" : "1", "-f", "webm"});
}

Arguments codecArguments(const VideoFormat& format, const VideoSource& source,
                         const Encoding& encoding) {
    const std::string before = reduction(source, encoding);
    switch (format.codec) {
        case Codec::h264:
        case Codec::vp9:
            return yuv(source, before, filmArguments(format, source, encoding));
        case Codec::gif:
            return {"-filter_complex",
                    paletteGraph(before, encoding.quality),
                    "-loop",
                    "0",
                    "-f",
                    "gif"};
        case Codec::webp:
            return rgb(before, "bgra",
                       {"-c:v", "libwebp_anim", "-quality", std::to_string(encoding.quality),
                        "-loop", "0", "-f", "webp"});
        case Codec::apng:
            break;
    }
    return rgb(before, source.alpha ? "rgba" : "rgb24",
               {"-c:v", "apng", "-plays", "0", "-f", "apng"});
}

/// Only containers of films list chapters.
std::span<const Chapter> chaptersOf(const VideoFormat& format, const VideoSource& source) {
    if (format.codec == Codec::h264 || format.codec == Codec::vp9) return source.chapters;
    return {};
}

/// The encoders' output depends on the number of threads, which by default is that of the machine.
void finish(Arguments& all, std::span<const Chapter> chapters, const Arguments& codec,
            const std::string& output) {
    append(all, {"-an", "-threads", "4"});
    append(all, chapterOutput(chapters, 1));
    append(all, {"-fflags", "+bitexact", "-flags:v", "+bitexact"});
    append(all, codec);
    all.push_back("file:" + output);  // for names that begin with '-' or contain ':'
}

std::string nameOf(int file) { return "/proc/self/fd/" + std::to_string(file); }

std::string numberText(double value) {
    std::string text = std::to_string(std::round(value * 100.0) / 100.0);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace

const VideoFormat* videoFormatOf(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    for (const VideoFormat& format : kFormats) {
        if (ending == format.ending) return &format;
    }
    return nullptr;
}

std::vector<Encoding> ladderOf(const VideoFormat& format, const VideoSource& source) {
    std::vector<Encoding> ladder;
    for (const Rung& rung : rungsOf(format.codec)) {
        const Encoding encoding = encodingOf(rung, format, source);
        if (ladder.empty() || encoding != ladder.back()) ladder.push_back(encoding);
    }
    return ladder;
}

std::string describe(const VideoFormat& format, const Encoding& encoding) {
    std::string text = sizeText(encoding.width, encoding.height, "x") + ", " +
                       numberText(encoding.fps) + " frames/s";
    const std::string quality = std::to_string(encoding.quality);
    if (format.codec == Codec::gif) return text + ", " + quality + " colours";
    if (format.codec == Codec::webp) return text + ", quality " + quality;
    if (format.codec == Codec::apng) return text;
    return text + ", crf " + quality;
}

bool takesYuv(const VideoFormat& format, const VideoSource& source) {
    return !source.alpha && (format.codec == Codec::h264 || format.codec == Codec::vp9);
}

Arguments encodeArguments(const VideoFormat& format, const VideoSource& source,
                          const Encoding& encoding, const std::filesystem::path& output) {
    Arguments all = start();
    const bool planes = takesYuv(format, source);
    append(all, rawInput(source, planes ? "yuv420p" : inMemory(source)));
    const std::span<const Chapter> chapters = chaptersOf(format, source);
    append(all, chapterInput(chapters, source.fps));
    Arguments codec = colours();
    append(codec, filmArguments(format, source, encoding));
    finish(all, chapters, planes ? codec : codecArguments(format, source, encoding),
           output.string());
    return all;
}

Arguments storeArguments(const VideoSource& source, int file) {
    Arguments all = start();
    append(all, rawInput(source, inMemory(source)));
    finish(all, {},
           {"-c:v", "ffv1", "-level", "3", "-slices", "4", "-g", "1", "-pix_fmt",
            source.alpha ? "bgra" : "bgr0", "-f", "nut"},
           nameOf(file));
    return all;
}

Arguments restoreArguments(const VideoFormat& format, const VideoSource& source,
                           const Encoding& encoding, int file,
                           const std::filesystem::path& output) {
    Arguments all = start();
    const Arguments input = {"-i", "file:" + nameOf(file)};
    append(all, input);
    if (format.codec == Codec::gif) append(all, input);  // for the palette, and for the pictures
    const std::span<const Chapter> chapters = chaptersOf(format, source);
    append(all, chapterInput(chapters, source.fps));
    finish(all, chapters, codecArguments(format, source, encoding), output.string());
    return all;
}

}  // namespace render
