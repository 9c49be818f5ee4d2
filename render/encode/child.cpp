#include "render/encode/child.h"

#include <csignal>
#include <cstdlib>

namespace render {

SpawnPlan::SpawnPlan() {
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
}

SpawnPlan::~SpawnPlan() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
}

void SpawnPlan::standAlone() {
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

std::chrono::milliseconds patienceOf(const char* variable, std::chrono::milliseconds unlessSet) {
    constexpr int kMost = 86'400'000;
    const char* text = std::getenv(variable);
    const int asked = text ? std::atoi(text) : 0;
    return asked >= 1 && asked <= kMost ? std::chrono::milliseconds(asked) : unlessSet;
}

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

}  // namespace render
