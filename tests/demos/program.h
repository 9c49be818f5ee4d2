/// The real program, run as a user's shell would.
#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace demos::test {

namespace fs = std::filesystem;

using support::TemporaryFolder;

struct Ended {
    int code = -1;  // -1: ended by a signal
    int signal = 0;
    std::string out, err;
    long peakKiB = 0;  // the largest of the program and the children that it has waited for

    long errorLines() const { return std::count(err.begin(), err.end(), '\n'); }
};

struct Launch {
    fs::path folder;  // where it runs
    std::vector<std::string> arguments;
    std::string awaited;                          // text of standard output at which ...
    int signal = 0;                               // ... this is sent, once
    std::function<void()> beforeExec = {};        // in the child
    std::function<void(pid_t)> awaitedCall = {};  // then, in the parent, with the child's number
};

inline void becomeProgram(const Launch& launch, int out, int err) {
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    if (chdir(launch.folder.c_str()) != 0) _exit(126);
    std::vector<char*> words{const_cast<char*>("impulse")};
    for (const std::string& word : launch.arguments)
        words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    if (launch.beforeExec) launch.beforeExec();
    execv(IMPULSE_BINARY, words.data());
    _exit(127);
}

/// Reads both streams to their ends, and sends the signal when the awaited text has come.
inline void listen(const Launch& launch, pid_t child, int out, int err, Ended& ended) {
    pollfd streams[] = {{out, POLLIN, 0}, {err, POLLIN, 0}};
    std::string* texts[] = {&ended.out, &ended.err};
    bool sent = launch.awaited.empty();
    while (streams[0].fd >= 0 || streams[1].fd >= 0) {
        poll(streams, 2, -1);
        for (int i = 0; i < 2; ++i) {
            if (streams[i].fd < 0 || streams[i].revents == 0) continue;
            char block[65536];
            const ssize_t got = read(streams[i].fd, block, sizeof block);
            if (got > 0)
                texts[i]->append(block, static_cast<std::size_t>(got));
            else
                streams[i].fd = -1;
        }
        if (!sent && ended.out.find(launch.awaited) != std::string::npos) {
            if (launch.signal != 0) kill(child, launch.signal);
            if (launch.awaitedCall) launch.awaitedCall(child);
            sent = true;
        }
    }
}

inline Ended run(const Launch& launch) {
    int out[2], err[2];
    if (pipe2(out, O_CLOEXEC) != 0 || pipe2(err, O_CLOEXEC) != 0) return {};
    const pid_t child = fork();
    if (child == 0) becomeProgram(launch, out[1], err[1]);
    close(out[1]);
    close(err[1]);
    Ended ended;
    listen(launch, child, out[0], err[0], ended);
    close(out[0]);
    close(err[0]);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    ended.peakKiB = used.ru_maxrss;
    if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
    return ended;
}

inline Ended run(const fs::path& folder, std::vector<std::string> arguments) {
    Launch launch;
    launch.folder = folder;
    launch.arguments = std::move(arguments);
    return run(launch);
}

/// For Launch::beforeExec: whoever read this stream has gone away.
inline std::function<void()> withoutReader(int stream) {
    return [stream] {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) _exit(125);
        dup2(ends[1], stream);
        close(ends[0]);
    };
}

inline std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

inline void write(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// A ball that falls on a floor: the smallest film.
const std::string kBall = R"(format = 1
title = "a ball"
seconds = 1.0
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0, 3, 0]
)";

/// The ball is too fast after its first step.
const std::string kFastBall =
    kBall + "velocity = [0, 9999, 0]\n[world]\ngravity = [0, 100, 0]\n";

/// A stack with 1320 rows, too many for the direct solver: the first step fails.
const std::string kTooTall =
    kBall +
    "[[repeat]]\ncount = 110\nstep = [0, 1, 0]\n"
    "body = { name = 'box{i}', shape = { box = [1, 1, 1] }, at = [9, 0.5, 0] }\n"
    "[solver]\ntype = 'direct'\n";

}  // namespace demos::test
