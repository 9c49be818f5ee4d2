#include "demos/processes/process_pool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <vector>

#include "demos/processes/child_process.h"
#include "demos/processes/signals.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

/// A running process. It has ended when its pipe ends.
struct Piece {
    int number = 0;
    pid_t process = 0;
    int pipe = -1;
    std::string text;
};

bool writeAll(int file, const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const ssize_t wrote = write(file, text.data() + at, text.size() - at);
        if (wrote < 0 && errno == EINTR) continue;
        if (wrote < 0) return false;
        at += static_cast<std::size_t>(wrote);
    }
    return true;
}

/// Ends with _exit, so that nothing of the parent is flushed or destroyed.
[[noreturn]] void bePiece(int number, int pipe, pid_t parent,
                          const std::function<std::string(int)>& work) {
    becomeChildOf(parent);
    const bool told = writeAll(pipe, work(number));
    _exit(told ? 0 : 1);
}

class Pool {
public:
    Pool(int count, int jobs, const std::function<std::string(int)>& work,
         const std::function<void(int, const PoolResult&)>& finished)
        : work_(work), finished_(finished), count_(count), jobs_(jobs),
          results_(static_cast<std::size_t>(count)),
          done_(static_cast<std::size_t>(count), false) {}
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    ~Pool() {
        for (Piece& piece : pieces_) {
            kill(piece.process, SIGKILL);
            close(piece.pipe);
            waitFor(piece.process);
        }
    }

    void run(const std::function<void(int, const PoolResult&)>& take) {
        int taken = 0;
        while (taken < count_) {
            while (next_ < count_ && static_cast<int>(pieces_.size()) < jobs_) start();
            readSome();
            if (interrupted())
                throw Stop(Exit::interrupted, fmt::format("interrupted after {} of {}", taken, count_));
            for (; taken < count_ && done_[taken]; ++taken) take(taken, results_[taken]);
        }
    }

private:
    void start() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw render::Error("cannot start a process: " + render::describeError(errno));
        std::fflush(nullptr);  // buffered output would be written by both
        const pid_t parent = getpid();
        const pid_t process = fork();
        if (process == 0) {
            for (const Piece& other : pieces_) close(other.pipe);
            close(ends[0]);
            bePiece(next_, ends[1], parent, work_);
        }
        close(ends[1]);
        if (process < 0) {
            close(ends[0]);
            throw render::Error("cannot start a process: " + render::describeError(errno));
        }
        pieces_.push_back({next_++, process, ends[0], {}});
    }

    void readSome() {
        std::vector<pollfd> waits;
        for (const Piece& piece : pieces_) waits.push_back({piece.pipe, POLLIN, 0});
        if (const SignalsHeld signals; interrupted() || !signals.wait(waits)) return;
        for (std::size_t i = pieces_.size(); i-- > 0;)
            if (waits[i].revents != 0) readFrom(i);
    }

    void readFrom(std::size_t place) {
        Piece& piece = pieces_[place];
        char block[65536];
        const ssize_t got = read(piece.pipe, block, sizeof block);
        if (got < 0 && errno == EINTR) return;
        if (got > 0) {
            piece.text.append(block, static_cast<std::size_t>(got));
            return;
        }
        finish(piece);
        pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(place));
    }

    void finish(Piece& piece) {
        close(piece.pipe);
        const int status = waitFor(piece.process);
        PoolResult& result = results_[piece.number];
        result.ended = WIFEXITED(status) && WEXITSTATUS(status) == 0;
        result.text = result.ended ? std::move(piece.text) : deathText(status);
        done_[piece.number] = true;
        if (finished_) finished_(piece.number, result);
    }

    const std::function<std::string(int)>& work_;
    const std::function<void(int, const PoolResult&)>& finished_;
    int count_, jobs_, next_ = 0;
    std::vector<Piece> pieces_;
    std::vector<PoolResult> results_;
    std::vector<bool> done_;
};

}  // namespace

void runInProcesses(int count, int jobs, const std::function<std::string(int)>& work,
                    const std::function<void(int, const PoolResult&)>& take,
                    const std::function<void(int, const PoolResult&)>& finished) {
    Pool(count, jobs, work, finished).run(take);
}

}  // namespace demos
