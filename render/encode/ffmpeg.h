/// The child process that makes the films: one running ffmpeg, which is sent raw pictures.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/encode/descriptor.h"

namespace render {

/// One running ffmpeg. Frames go through a socket instead of a pipe: send() can avoid SIGPIPE for a
/// single call, and the closing of the other end shows that the child has ended. The child's output
/// goes to files in memory, which cannot fill up and block it.
class Ffmpeg {
public:
    /// Starts `arguments` (the program's name first, looked up in PATH). `patience`: a child that
    /// neither reads nor uses processor time for this long counts as hanging. `shared` becomes the
    /// child's descriptor kSharedFile, which the arguments may refer to.
    Ffmpeg(const std::vector<std::string>& arguments, std::chrono::milliseconds patience,
           const Descriptor* shared = nullptr);
    static constexpr int kSharedFile = 3;  // its number in the child
    ~Ffmpeg() { end(); }
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    /// False if the child does not accept the bytes; call finish() and complaint() for the reason.
    bool send(std::span<const std::uint8_t> bytes);

    /// Sends no more frames and waits for the end. True if the child succeeded. `giveUp` is called
    /// ten times a second; if it returns true, the child is killed.
    bool finish(const std::function<bool()>& giveUp = {});

    /// The reason why finish() returned false.
    std::string complaint() const;

    int framesWritten() const;  // as ffmpeg counts them

    /// Its standard output.
    std::string output() const;

    /// Kills the child if it is still running.
    void end() noexcept;

private:
    struct Sockets {
        int ours, theirs;
    };
    static Sockets makeSockets();
    Ffmpeg(const std::vector<std::string>& arguments, std::chrono::milliseconds patience,
           const Descriptor* shared, Sockets sockets);
    void spawn(const std::vector<std::string>& arguments, const Descriptor* shared);

    Descriptor frames_;
    std::unique_ptr<Descriptor> theirs_;  // the child's end, until the child has started
    Descriptor progress_, errors_;
    std::chrono::milliseconds patience_;
    pid_t child_ = -1;
    bool running_ = false, hung_ = false;
    int status_ = 0;
};

/// Whether an ffmpeg can be run from PATH.
bool haveFfmpeg();

/// "5.1.6-0+deb12u1", as ffmpeg reports it; empty if ffmpeg does not run.
std::string ffmpegVersion();

/// 60 s, or the milliseconds of IMPULSE_FFMPEG_PATIENCE_MS, which tests of hanging programs set.
std::chrono::milliseconds ffmpegPatience();

}  // namespace render
