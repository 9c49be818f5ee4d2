#include "demos/film/signals.h"

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
}

bool interrupted() { return flag != 0; }

}  // namespace demos
