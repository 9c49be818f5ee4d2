#include "render/encode/ffmpeg.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <ctime>
#include <string_view>
#include <system_error>
#include <thread>

#include "render/encode/child.h"
#include "render/encode/file.h"
#include "render/encode/program_path.h"
#include "render/error.h"

extern char** environ;

namespace render {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kTalk = "talk to ffmpeg";
constexpr int kUnknownStatus = 255 << 8;  // as after exit(255)

/// The end (at most 64 KiB) of a file in memory that a child writes. The offset is shared, so it is
/// read by position.
std::string contentOf(const Descriptor& file) {
    std::string text(std::size_t{1} << 16, '\0');
    const off_t end = ::lseek(file.number(), 0, SEEK_END);
    const off_t start = std::max<off_t>(0, end - static_cast<off_t>(text.size()));
    const ssize_t length = ::pread(file.number(), text.data(), text.size(), start);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    return text;
}

/// A time limit that counts only while the child uses no processor time: the palette of a long GIF
/// takes long, and so does everything on a machine under load.
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

}  // namespace

Ffmpeg::Sockets Ffmpeg::makeSockets() {
    int pair[2] = {-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) {
        throw Error("cannot talk to ffmpeg: " + describeError(errno));
    }
    return {pair[0], pair[1]};
}

Ffmpeg::Ffmpeg(const std::vector<std::string>& arguments, std::chrono::milliseconds patience,
               const Descriptor* shared)
    : Ffmpeg(arguments, patience, shared, makeSockets()) {}

Ffmpeg::Ffmpeg(const std::vector<std::string>& arguments, std::chrono::milliseconds patience,
               const Descriptor* shared, Sockets sockets)
    : frames_(sockets.ours, kTalk),
      theirs_(std::make_unique<Descriptor>(sockets.theirs, kTalk)),
      progress_(::memfd_create("progress", MFD_CLOEXEC), kTalk),
      errors_(::memfd_create("errors", MFD_CLOEXEC), kTalk),
      patience_(patience) {
    spawn(arguments, shared);
    theirs_.reset();
}

void Ffmpeg::spawn(const std::vector<std::string>& arguments, const Descriptor* shared) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str()));  // the C interface; not modified
    }
    argv.push_back(nullptr);
    SpawnPlan plan;
    plan.standAlone();  // after Ctrl-C it must still close the film
    ::posix_spawn_file_actions_adddup2(&plan.files, theirs_->number(), 0);
    ::posix_spawn_file_actions_adddup2(&plan.files, progress_.number(), 1);
    ::posix_spawn_file_actions_adddup2(&plan.files, errors_.number(), 2);
    if (shared)  // last, since one of the others may have this number
        ::posix_spawn_file_actions_adddup2(&plan.files, shared->number(), kSharedFile);
    const int error =
        ::posix_spawnp(&child_, argv[0], &plan.files, &plan.attributes, argv.data(), environ);
    if (error == ENOENT) {
        throw Error(
            "ffmpeg was not found; install it (apt install ffmpeg); PNG frames need nothing else");
    }
    if (error != 0) throw Error("ffmpeg cannot be started: " + describeError(error));
    running_ = true;
}

bool Ffmpeg::send(std::span<const std::uint8_t> bytes) {
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

bool Ffmpeg::finish(const std::function<bool()>& giveUp) {
    ::shutdown(frames_.number(), SHUT_WR);
    Patience patience(child_, patience_);
    while (running_) {
        const pid_t ended = ::waitpid(child_, &status_, WNOHANG);
        if (ended != 0) running_ = false;
        if (ended < 0) status_ = kUnknownStatus;  // the calling program ignores SIGCHLD
        if (ended != 0) break;
        if (!hung_ && giveUp && giveUp()) {
            end();
            break;
        }
        if (hung_ || !patience.left()) {
            hung_ = true;
            end();
            break;
        }
        pollfd wait = {frames_.number(), POLLIN, 0};
        if (::poll(&wait, 1, 100) > 0) std::this_thread::sleep_for(1ms);  // it is about to exit
    }
    return !hung_ && WIFEXITED(status_) && WEXITSTATUS(status_) == 0;
}

void Ffmpeg::end() noexcept {
    if (!running_) return;
    ::kill(-child_, SIGKILL);  // a script may have started others
    while (::waitpid(child_, &status_, 0) < 0 && errno == EINTR) {
    }
    running_ = false;
}

std::string Ffmpeg::complaint() const {
    const std::string words = lastLineOf(contentOf(errors_));
    const std::string tail = words.empty() ? "" : ": " + words;
    if (hung_) {
        return "ffmpeg did nothing for " + std::to_string(patience_.count() / 1000) +
               " s and was killed" + tail;
    }
    if (WIFSIGNALED(status_)) {
        return "ffmpeg was killed by signal " + std::to_string(WTERMSIG(status_)) + tail;
    }
    return "ffmpeg stopped with status " + std::to_string(WEXITSTATUS(status_)) + tail;
}

/// -progress writes blocks of "key=value" lines; the last block has the final count.
int Ffmpeg::framesWritten() const {
    const std::string text = contentOf(progress_);
    const std::size_t key = text.rfind("frame=");
    int count = 0;
    if (key == std::string::npos) return count;
    std::from_chars(text.data() + key + 6, text.data() + text.size(), count);
    return count;
}

std::string Ffmpeg::output() const { return contentOf(progress_); }

std::string ffmpegVersion() try {
    Ffmpeg asked({"ffmpeg", "-version"}, ffmpegPatience());
    if (!asked.finish()) return {};
    const std::string text = asked.output();
    const std::string before = "ffmpeg version ";
    if (!text.starts_with(before)) return {};
    return text.substr(before.size(), text.find(' ', before.size()) - before.size());
} catch (const Error&) {
    return {};
}

std::chrono::milliseconds ffmpegPatience() { return patienceOf("IMPULSE_FFMPEG_PATIENCE_MS", 60s); }

bool haveFfmpeg() { return programPath("ffmpeg").has_value(); }

}  // namespace render
