#include "demos/processes/child_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "demos/processes/signals.h"
#include "demos/text/stop.h"
#include "render/encode/child.h"
#include "render/encode/descriptor.h"
#include "render/encode/file.h"
#include "render/error.h"

extern char** environ;

namespace demos {
namespace {

using Clock = std::chrono::steady_clock;

/// The child reads nothing and writes its output into the file `words`.
struct ChildPlan : render::SpawnPlan {
    explicit ChildPlan(const std::string& words) {
        posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, words.c_str(),
                                         O_WRONLY | O_CREAT | O_TRUNC, 0600);
        posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
        standAlone();
    }
};

/// A child that is killed with its process group by the destructor.
class Child {
public:
    Child(const std::vector<std::string>& arguments, const std::string& words) {
        std::vector<char*> argv;
        for (const std::string& argument : arguments)
            argv.push_back(const_cast<char*>(argument.c_str()));  // the C interface; not modified
        argv.push_back(nullptr);
        const ChildPlan plan(words);
        const int error =
            posix_spawnp(&number_, argv[0], &plan.files, &plan.attributes, argv.data(), environ);
        if (error != 0)
            throw render::Error(arguments.front() +
                                " cannot be started: " + render::describeError(error));
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
        const render::Descriptor end(static_cast<int>(syscall(SYS_pidfd_open, number_, 0)),
                                     "wait for another program");
        const Clock::time_point limit = Clock::now() + patience;
        const SignalsHeld signals;
        while (true) {
            if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
            const Clock::duration left = limit - Clock::now();
            if (left.count() <= 0) return false;
            if (signals.isReadable(end.number(), left)) break;
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
    Child child(arguments, words.string());
    if (!child.endsWithin(patience))
        return fmt::format("took more than {} s and was killed",
                           static_cast<double>(patience.count()) / 1000.0);
    if (WIFSIGNALED(child.status()))
        return fmt::format("was killed by signal {}", WTERMSIG(child.status()));
    if (WEXITSTATUS(child.status()) == 0) return {};
    return fmt::format("stopped with status {}", WEXITSTATUS(child.status()));
}

}  // namespace demos
