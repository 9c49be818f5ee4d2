/// SIGINT, SIGTERM and SIGHUP as a flag that a loop checks between two frames.
#pragma once
#include <poll.h>
#include <signal.h>

#include <chrono>
#include <optional>
#include <span>

namespace demos {

/// From now on the first of these signals sets a flag; a second one ends the program at once.
/// Another call clears the flag.
void watchSignals();
bool interrupted();

/// While it exists, these signals are delivered during wait() only: none is missed between the
/// check and the wait.
class SignalsHeld {
public:
    SignalsHeld();
    ~SignalsHeld();
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

    /// Whether one of the files is ready, as poll() fills in; false after a signal or after
    /// `longest`. Without `longest` it waits until one of these happens.
    bool wait(std::span<pollfd> files, std::optional<std::chrono::nanoseconds> longest = {}) const;
    bool isReadable(int file, std::optional<std::chrono::nanoseconds> longest = {}) const;

private:
    sigset_t before_;
};

}  // namespace demos
