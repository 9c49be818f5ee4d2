/// The real program, with which a test exchanges messages while it runs.
#pragma once
#include "tests/demos/program.h"

namespace demos::test {

/// Both output streams come through one pipe. The program is killed with its owner.
class Conversation {
public:
    explicit Conversation(const Launch& launch) {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) return;
        child_ = fork();
        if (child_ == 0) becomeProgram(launch, ends[1], ends[1]);
        close(ends[1]);
        pipe_ = ends[0];
    }
    ~Conversation() {
        if (child_ > 0) {
            kill(child_, SIGKILL);
            wait();
        }
        close(pipe_);
    }
    Conversation(const Conversation&) = delete;
    Conversation& operator=(const Conversation&) = delete;

    /// The output since the last call, up to the end of the line with this text; a test failure if
    /// the program ends before, or prints nothing for a minute.
    std::string until(const std::string& text) {
        constexpr int kPatience = 60'000;  // ms
        for (;;) {
            const std::size_t at = heard_.find(text);
            const std::size_t end = at == heard_.npos ? at : heard_.find('\n', at);
            if (end != heard_.npos) {
                const std::string said = heard_.substr(0, end + 1);
                heard_.erase(0, end + 1);
                return said;
            }
            pollfd stream{pipe_, POLLIN, 0};
            char block[65536];
            const ssize_t got =
                poll(&stream, 1, kPatience) > 0 ? read(pipe_, block, sizeof block) : 0;
            if (got <= 0) {
                ADD_FAILURE() << "waited for '" << text << "', heard: " << heard_;
                return heard_;
            }
            heard_.append(block, static_cast<std::size_t>(got));
        }
    }

    /// Its exit code; -1: ended by a signal.
    int endBy(int signal) {
        kill(child_, signal);
        return wait();
    }

private:
    int wait() {
        int status = 0;
        waitpid(child_, &status, 0);
        child_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

    pid_t child_ = -1;
    int pipe_ = -1;
    std::string heard_;
};

}  // namespace demos::test
