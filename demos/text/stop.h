/// How a run fails: a line for the user and an exit code for the shell.
#pragma once
#include <stdexcept>
#include <string>

namespace demos {

enum class Exit {
    ok = 0,
    failed = 1,          // an expectation or a snapshot
    usage = 2,           // the command line
    scene = 3,           // the scene file
    environment = 4,     // no OpenGL, no ffmpeg, disk full
    wouldOverwrite = 5,  // without --overwrite
    diverged = 6,        // an incident: a body that could not continue, or energy from nowhere;
                         // or a step that failed
    incomplete = 7,      // parts of a film are missing or do not belong together
    interrupted = 130    // SIGINT, SIGTERM, SIGHUP
};

/// One line with what is wrong, the value, and what would be right. Caught once, in run().
class Stop : public std::runtime_error {
public:
    Stop(Exit code, const std::string& line) : std::runtime_error(line), code_(code) {}
    Exit code() const { return code_; }

private:
    Exit code_;
};

/// Throws Stop (usage).
[[noreturn]] inline void refuse(const std::string& line) { throw Stop(Exit::usage, line); }

}  // namespace demos
