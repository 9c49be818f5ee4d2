#include "render/encode/join_films.h"

#include <unistd.h>

#include <string>
#include <vector>

#include "render/encode/descriptor.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/film_file.h"
#include "render/error.h"

namespace render {
namespace {

namespace fs = std::filesystem;

/// One line of ffmpeg's list of files, with the name in single quotes.
std::string quotedName(const fs::path& file) {
    std::string text = "file 'file:";
    for (const char c : fs::absolute(file).string()) {
        if (c == '\n')
            throw Error("cannot join '" + file.string() + "': its name contains a line break");
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return text + "'\n";
}

/// With chapters there are two inputs, and ffmpeg sleeps for 10 ms whenever the shorter queue of packets is empty.
std::vector<std::string> arguments(Codec codec, std::span<const Chapter> chapters, int fps,
                                   const fs::path& output) {
    std::vector<std::string> all = {
        "ffmpeg",    "-nostdin", "-hide_banner", "-xerror",  "-loglevel",
        "error",     "-y",       "-progress",    "pipe:1",   "-protocol_whitelist",
        "file,pipe", "-thread_queue_size", "4096", "-f", "concat", "-safe", "0",
        "-i",        "-"};
    const auto append = [&all](const std::vector<std::string>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    append(chapterInput(chapters, fps));
    append({"-c", "copy"});
    append(chapterOutput(chapters, 1));
    append({"-fflags", "+bitexact", "-flags:v", "+bitexact"});
    if (codec == Codec::h264) append({"-movflags", "+faststart", "-f", "mp4"});
    if (codec == Codec::vp9) append({"-f", "webm"});
    all.push_back("file:" + output.string());
    return all;
}

}  // namespace

void joinFilms(std::span<const fs::path> parts, int frames, const fs::path& target,
               Existing existing, std::span<const Chapter> chapters, int fps) {
    const VideoFormat* format = videoFormatOf(target);
    if (!format || (format->codec != Codec::h264 && format->codec != Codec::vp9))
        throw Error("film '" + target.string() + "': parts can only be joined into .mp4 or .webm");
    checkReplaceable(target);
    std::string list;
    for (const fs::path& part : parts) list += quotedName(part);
    const fs::path temporary = temporaryNameFor(target);
    const Descriptor held(createTemporary(temporary, target), "write a film");
    try {
        Ffmpeg ffmpeg(arguments(format->codec, chapters, fps, temporary), ffmpegPatience());
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(list.data());
        const bool took = ffmpeg.send({bytes, list.size()});
        const bool ended = ffmpeg.finish();
        if (!took || !ended) throw Error("film '" + target.string() + "': " + ffmpeg.complaint());
        if (ffmpeg.framesWritten() != frames || !filmIsWhole(*format, held.number()))
            throw Error("film '" + target.string() + "': of " + std::to_string(frames) +
                        " frames of its parts " + std::to_string(ffmpeg.framesWritten()) +
                        " were joined; are the parts of one kind?");
        publish(temporary, target, existing);
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
}

}  // namespace render
