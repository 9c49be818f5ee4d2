#include "demos/processes/signals.h"

#include <csignal>

namespace demos {
namespace {

volatile std::sig_atomic_t flag = 0;

}  // namespace

void watchSignals() {
    flag = 0;
    struct sigaction action {};
    action.sa_handler = [](int) { flag = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    struct sigaction before {};
    sigaction(SIGHUP, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // ignored: by nohup
}

bool interrupted() { return flag != 0; }

SignalsHeld::SignalsHeld() {
    sigset_t ending;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    sigaddset(&ending, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
}

SignalsHeld::~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

bool SignalsHeld::wait(std::span<pollfd> files,
                       std::optional<std::chrono::nanoseconds> longest) const {
    constexpr long kSecond = 1'000'000'000;  // ns
    timespec limit{};
    if (longest) limit = {longest->count() / kSecond, longest->count() % kSecond};
    return ppoll(files.data(), files.size(), longest ? &limit : nullptr, &before_) > 0;
}

bool SignalsHeld::isReadable(int file, std::optional<std::chrono::nanoseconds> longest) const {
    pollfd one{file, POLLIN, 0};
    return wait({&one, 1}, longest);
}

}  // namespace demos
