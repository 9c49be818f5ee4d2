/// The child that makes the films: one running ffmpeg, fed with raw pictures.
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

/// One running ffmpeg. Frames go through a socket instead of a pipe: send() can be told not to
/// raise SIGPIPE, for this call alone, and the other end closing tells when the child has ended.
/// Its words go to files in memory, which cannot fill up and block it.
class Ffmpeg {
public:
    /// Starts `arguments` (the program's name first, looked up in PATH). `patience`: a child that
    /// neither reads nor uses processor time for so long is taken for hanging. `shared` is the
    /// child's file number kSharedFile, where its arguments name that.
    Ffmpeg(const std::vector<std::string>& arguments, std::chrono::milliseconds patience,
           const Descriptor* shared = nullptr);
    static constexpr int kSharedFile = 3;  // its number in the child
    ~Ffmpeg() { end(); }
    Ffmpeg(const Ffmpeg&) = delete;
    Ffmpeg& operator=(const Ffmpeg&) = delete;

    /// False when the child does not take the bytes; finish() and complaint() tell why.
    bool send(std::span<const std::uint8_t> bytes);

    /// No more frames: waits for the end. True when the child ended well. `giveUp` is asked ten
    /// times a second whether it is worth waiting on; if not, the child is ended.
    bool finish(const std::function<bool()>& giveUp = {});

    /// Why finish() was false.
    std::string complaint() const;

    int framesWritten() const;  // as ffmpeg counts them

    /// All that it has written to its standard output.
    std::string output() const;

    /// Ends the child now, if it still runs.
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
    std::unique_ptr<Descriptor> theirs_;  // the child's end; open here until it has started
    Descriptor progress_, errors_;
    std::chrono::milliseconds patience_;
    pid_t child_ = -1;
    bool running_ = false, hung_ = false;
    int status_ = 0;
};

/// Whether an ffmpeg can be run from PATH.
bool haveFfmpeg();

/// "5.1.6-0+deb12u1", as ffmpeg names itself; empty where it does not run.
std::string ffmpegVersion();

/// 60 s, or the milliseconds of IMPULSE_FFMPEG_PATIENCE_MS, which tests of hanging ones set.
std::chrono::milliseconds ffmpegPatience();

}  // namespace render
