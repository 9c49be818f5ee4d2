/// SIGINT, SIGTERM and SIGHUP as a question that a loop asks between two frames.
#pragma once
#include <poll.h>
#include <signal.h>

#include <chrono>
#include <optional>
#include <span>

namespace demos {

/// From now on the first of them sets a flag; a second one ends the program at once.
/// Called again, the count begins again.
void watchSignals();
bool interrupted();

/// While it lives they come while wait() does and at no other time: none is missed between the
/// question and the wait.
class SignalsHeld {
public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

    /// Whether one of the files is ready, as poll() fills in; false after a signal, and after
    /// `longest`: none is until something comes.
    bool wait(std::span<pollfd> files, std::optional<std::chrono::nanoseconds> longest = {}) const;
    bool isReadable(int file, std::optional<std::chrono::nanoseconds> longest = {}) const;

private:
    sigset_t before_;
};

}  // namespace demos
