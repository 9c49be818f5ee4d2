#include "render/encode/video.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/error.h"

extern char** environ;

namespace render {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;
using Arguments = std::vector<std::string>;

// ---- formats -------------------------------------------------------------------------------

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

// ---- what the operating system lends -------------------------------------------------------

/// A file descriptor that closes itself. Always above 2: a program started with its standard
/// output closed would else be given number 1, and dup2 in the child would tread on it.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {
        if (number < 0) throw Error("cannot talk to ffmpeg: " + describeError(errno));
        if (number > 2) return;
        number_ = ::fcntl(number, F_DUPFD_CLOEXEC, 3);
        const int error = errno;
        ::close(number);
        if (number_ < 0) throw Error("cannot talk to ffmpeg: " + describeError(error));
    }
    ~Descriptor() { ::close(number_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

private:
    int number_;
};

/// All of a file in memory that a child writes; the offset is shared, so read by position.
std::string contentOf(const Descriptor& file) {
    std::string text(std::size_t{1} << 16, '\0');
    const off_t end = ::lseek(file.number(), 0, SEEK_END);
    const off_t start = std::max<off_t>(0, end - static_cast<off_t>(text.size()));
    const ssize_t length = ::pread(file.number(), text.data(), text.size(), start);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    return text;
}

/// The last line that says something, without what could steer a terminal.
std::string lastLineOf(std::string_view text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.remove_suffix(1);
    const std::size_t lineEnd = text.find_last_of("\r\n");
    if (lineEnd != std::string_view::npos) text.remove_prefix(lineEnd + 1);
    std::string line(text.substr(0, 300));
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
    }
    return line;
}

/// Time runs out only while the child does nothing at all: the palette of a long GIF is slow
/// work, and a machine under load is no reason to end it.
class Patience {
public:
    Patience(pid_t child, std::chrono::milliseconds limit) : limit_(limit) {
        if (::clock_getcpuclockid(child, &clock_) == 0) hasClock_ = true;
        left();
    }
    bool left() {
        timespec used = {};
        if (hasClock_) ::clock_gettime(clock_, &used);
        const auto now = Clock::now();
        if (first_ || used.tv_sec != used_.tv_sec || used.tv_nsec != used_.tv_nsec) {
            end_ = now + limit_;
        }
        first_ = false;
        used_ = used;
        return now < end_;
    }

private:
    std::chrono::milliseconds limit_;
    clockid_t clock_ = 0;
    bool hasClock_ = false, first_ = true;
    timespec used_ = {};
    Clock::time_point end_;
};

struct Sockets {
    int ours, theirs;
};

Sockets makeSockets() {
    int pair[2] = {-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) {
        throw Error("cannot talk to ffmpeg: " + describeError(errno));
    }
    return {pair[0], pair[1]};
}

}  // namespace

// ---- the child -----------------------------------------------------------------------------

/// One running ffmpeg. Frames go through a socket instead of a pipe: send() can be told not to
/// raise SIGPIPE, for this call alone, and the other end closing tells when the child has ended.
/// Its words go to files in memory, which cannot fill up and block it.
class VideoWriter::Ffmpeg {
public:
    Ffmpeg(const Arguments& arguments, std::chrono::milliseconds patience)
        : Ffmpeg(arguments, patience, makeSockets()) {}
    ~Ffmpeg() { end(); }
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    /// False when the child does not take the bytes; finish() and complaint() tell why.
    bool send(std::span<const std::uint8_t> bytes);

    /// No more frames: waits for the end. True when the child ended well.
    bool finish();

    /// Why finish() was false.
    std::string complaint() const;

    int framesWritten() const;

    /// Ends the child now, if it still runs.
    void end() noexcept;

private:
    Ffmpeg(const Arguments& arguments, std::chrono::milliseconds patience, Sockets sockets)
        : frames_(sockets.ours),
          theirs_(std::make_unique<Descriptor>(sockets.theirs)),
          progress_(::memfd_create("progress", MFD_CLOEXEC)),
          errors_(::memfd_create("errors", MFD_CLOEXEC)),
          patience_(patience) {
        spawn(arguments);
        theirs_.reset();
    }
    void spawn(const Arguments& arguments);

    Descriptor frames_;
    std::unique_ptr<Descriptor> theirs_;  // the child's end; open here until it has started
    Descriptor progress_, errors_;
    std::chrono::milliseconds patience_;
    static constexpr int kUnknownStatus = 255 << 8;  // as if it had ended with exit(255)
    pid_t child_ = -1;
    bool running_ = false, hung_ = false;
    int status_ = 0;
};

namespace {

/// posix_spawn's two structures, freed on every way out.
struct SpawnPlan {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;
    SpawnPlan() {
        ::posix_spawn_file_actions_init(&files);
        ::posix_spawnattr_init(&attributes);
    }
    ~SpawnPlan() {
        ::posix_spawn_file_actions_destroy(&files);
        ::posix_spawnattr_destroy(&attributes);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    /// Ctrl-C reaches a whole process group: in one of its own, ffmpeg lives to close the film.
    void standAlone() {
        sigset_t none, defaults;
        ::sigemptyset(&none);
        ::sigemptyset(&defaults);
        for (const int signal : {SIGPIPE, SIGINT, SIGTERM}) ::sigaddset(&defaults, signal);
        ::posix_spawnattr_setsigmask(&attributes, &none);
        ::posix_spawnattr_setsigdefault(&attributes, &defaults);
        ::posix_spawnattr_setpgroup(&attributes, 0);
        ::posix_spawnattr_setflags(
            &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
};

}  // namespace

void VideoWriter::Ffmpeg::spawn(const Arguments& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));  // the C interface; not written to
    }
    argv.push_back(nullptr);
    SpawnPlan plan;
    plan.standAlone();
    ::posix_spawn_file_actions_adddup2(&plan.files, theirs_->number(), 0);
    ::posix_spawn_file_actions_adddup2(&plan.files, progress_.number(), 1);
    ::posix_spawn_file_actions_adddup2(&plan.files, errors_.number(), 2);
    const int error =
        ::posix_spawnp(&child_, argv[0], &plan.files, &plan.attributes, argv.data(), environ);
    if (error == ENOENT) {
        throw Error(
            "ffmpeg was not found; install it (apt install ffmpeg); PNG frames need nothing else");
    }
    if (error != 0) throw Error("ffmpeg does not start: " + describeError(error));
    running_ = true;
}

bool VideoWriter::Ffmpeg::send(std::span<const std::uint8_t> bytes) {
    Patience patience(child_, patience_);
    while (!bytes.empty()) {
        const ssize_t sent =
            ::send(frames_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(sent));
            patience = Patience(child_, patience_);
            continue;
        }
        if (errno == EINTR) continue;
        if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
        if (!patience.left()) {
            hung_ = true;
            return false;
        }
        pollfd wait = {frames_.number(), POLLOUT, 0};
        ::poll(&wait, 1, 100);
    }
    return true;
}

bool VideoWriter::Ffmpeg::finish() {
    ::shutdown(frames_.number(), SHUT_WR);
    Patience patience(child_, patience_);
    while (running_) {
        const pid_t ended = ::waitpid(child_, &status_, WNOHANG);
        if (ended != 0) running_ = false;
        if (ended < 0) status_ = kUnknownStatus;  // our caller ignores SIGCHLD
        if (ended != 0) break;
        if (hung_ || !patience.left()) {
            hung_ = true;
            end();
            break;
        }
        pollfd wait = {frames_.number(), POLLIN, 0};
        if (::poll(&wait, 1, 100) > 0) std::this_thread::sleep_for(1ms);  // its end is near
    }
    return !hung_ && WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

void VideoWriter::Ffmpeg::end() noexcept {
    if (!running_) return;
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, &status_, 0) < 0 && errno == EINTR) {
    }
    running_ = false;
}

std::string VideoWriter::Ffmpeg::complaint() const {
    const std::string words = lastLineOf(contentOf(errors_));
    const std::string tail = words.empty() ? "" : ": " + words;
    if (hung_) {
        return "ffmpeg did nothing for " + std::to_string(patience_.count() / 1000) +
               " s and was ended" + tail;
    }
    if (WIFSIGNALED(status_)) {
        return "ffmpeg was killed by signal " + std::to_string(WTERMSIG(status_)) + tail;
    }
    return "ffmpeg stopped with status " + std::to_string(WEXITSTATUS(status_)) + tail;
}

/// -progress writes blocks of "key=value" lines; the last block tells the final count.
int VideoWriter::Ffmpeg::framesWritten() const {
    const std::string text = contentOf(progress_);
    const std::size_t key = text.rfind("frame=");
    int count = 0;
    if (key == std::string::npos) return count;
    std::from_chars(text.data() + key + 6, text.data() + text.size(), count);
    return count;
}

// ---- the film ------------------------------------------------------------------------------

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

bool haveFfmpeg() {
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable ? variable : "/bin:/usr/bin";
    while (true) {
        const std::size_t colon = folders.find(':');
        const fs::path folder = colon == 0 || folders.empty() ? "." : folders.substr(0, colon);
        const fs::path program = folder / "ffmpeg";
        std::error_code ignored;
        if (::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program, ignored)) {
            return true;
        }
        if (colon == std::string_view::npos) return false;
        folders.remove_prefix(colon + 1);
    }
}

}  // namespace render
