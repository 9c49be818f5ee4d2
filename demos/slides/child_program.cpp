#include "demos/slides/child_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "demos/film/signals.h"
#include "demos/stop.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/error.h"

extern char** environ;

namespace demos {
namespace {

using Clock = std::chrono::steady_clock;

/// posix_spawn's two structures, freed on every way out.
struct ChildPlan {
    posix_spawn_file_actions_t files;
    posix_spawnattr_t attributes;

    explicit ChildPlan(const std::string& words) {
        posix_spawn_file_actions_init(&files);
        posix_spawnattr_init(&attributes);
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, words.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
        sigset_t none, defaults;
        sigemptyset(&none);
        sigemptyset(&defaults);
        for (const int number : {SIGPIPE, SIGINT, SIGTERM, SIGXFSZ}) sigaddset(&defaults, number);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setsigdefault(&attributes, &defaults);
        posix_spawnattr_setpgroup(&attributes, 0);  // ended as a group
        posix_spawnattr_setflags(
            &attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~ChildPlan() {
        posix_spawn_file_actions_destroy(&files);
        posix_spawnattr_destroy(&attributes);
    }
    ChildPlan(const ChildPlan&) = delete;
    ChildPlan& operator=(const ChildPlan&) = delete;
};

/// Ended, and everything of its group, when this goes.
class Child {
public:
    Child(const std::vector<std::string>& arguments, const std::string& words) {
        std::vector<char*> argv;
        for (const std::string& argument : arguments)
            argv.push_back(const_cast<char*>(argument.c_str()));  // the C interface; not written to
        argv.push_back(nullptr);
        const ChildPlan plan(words);
        const int error =
            posix_spawnp(&number_, argv[0], &plan.files, &plan.attributes, argv.data(), environ);
        if (error != 0)
            throw render::Error(arguments.front() +
                                " does not start: " + render::describeError(error));
    }
    ~Child() {
        kill(-number_, SIGKILL);
        while (!reaped_ && waitpid(number_, &status_, 0) < 0 && errno == EINTR) {
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Whether it has ended within the time.
    bool endsWithin(std::chrono::milliseconds patience) {
        const render::Descriptor end(static_cast<int>(syscall(SYS_pidfd_open, number_, 0)));
        const Clock::time_point limit = Clock::now() + patience;
        while (true) {
            if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(limit - Clock::now());
            if (left.count() <= 0) return false;
            pollfd wait = {end.number(), POLLIN, 0};
            if (poll(&wait, 1, static_cast<int>(left.count())) > 0) break;
        }
        while (waitpid(number_, &status_, 0) < 0 && errno == EINTR) {
        }
        reaped_ = true;
        return true;
    }
    int status() const { return status_; }

private:
    pid_t number_ = -1;
    int status_ = 0;
    bool reaped_ = false;
};

}  // namespace

std::string runChild(const std::vector<std::string>& arguments, const std::filesystem::path& words,
                     std::chrono::milliseconds patience) {
    watchSignals();
    Child child(arguments, words.string());
    if (!child.endsWithin(patience))
        return fmt::format("took more than {} s and was ended",
                           static_cast<double>(patience.count()) / 1000.0);
    if (WIFSIGNALED(child.status()))
        return fmt::format("was ended by signal {}", WTERMSIG(child.status()));
    if (WEXITSTATUS(child.status()) == 0) return {};
    return fmt::format("stopped with status {}", WEXITSTATUS(child.status()));
}

}  // namespace demos
