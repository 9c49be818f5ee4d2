#include "demos/film/frame_source.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <thread>

#include "demos/film/worker.h"
#include "demos/processes/child_process.h"
#include "demos/text/stop.h"
#include "render/context.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

/// Ends with _exit, so that a worker runs none of the parent's exit handlers.
[[noreturn]] void beWorker(const FilmPlan& plan, const WorkerTask& task, Channel channel,
                           pid_t parent) {
    becomeChildOf(parent);  // the parent handles SIGINT: it finishes the frame
    runWorker(plan, task, channel);
    _exit(0);
}

/// How a process ended whose socket is closed; it may be ending still.
std::string deathOf(pid_t process) {
    kill(process, SIGKILL);  // no effect on a process that has ended
    return deathText(waitFor(process));
}

}  // namespace

int workerCount(int jobs, int frames) {
    const int cores = std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
    return std::clamp(jobs > 0 ? jobs : cores, 1, std::max(frames, 1));
}

FrameSource::FrameSource(const FilmPlan& plan, int jobs, bool png, bool raw)
    : width_(plan.layout.width), height_(plan.layout.height) {
    workers_.reserve(static_cast<std::size_t>(jobs));
    render::preloadContext(plan.picture.context);
    for (int i = 0; i < jobs; ++i) {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw render::Error("cannot start a worker: " + render::describeError(errno));
        Channel mine(ends[0]), theirs(ends[1]);
        const pid_t parent = getpid();
        const pid_t process = fork();
        if (process < 0)
            throw render::Error("cannot start a worker: " + render::describeError(errno));
        if (process == 0) {
            mine.close();
            for (Worker& worker : workers_) worker.channel.close();
            beWorker(plan, {i, jobs, png, raw}, std::move(theirs), parent);
        }
        workers_.push_back({process, std::move(mine)});
    }
    meet();
}

FrameSource::~FrameSource() {
    for (Worker& worker : workers_) {
        worker.channel.close();
        if (worker.process > 0) kill(worker.process, SIGKILL);
    }
    for (Worker& worker : workers_)
        if (worker.process > 0) waitFor(worker.process);
}

void FrameSource::meet() {
    for (Worker& worker : workers_) {
        Message message;
        receive(worker, message);
        renderer_ = message.text();
    }
}

void FrameSource::receive(Worker& worker, Message& message) {
    if (!worker.channel.receive(message)) {
        const std::string death = deathOf(worker.process);
        worker.process = 0;
        throw render::Error("a drawing process " + death);
    }
    if (message.kind == MessageKind::failed) throw render::Error(message.text());
    if (message.kind == MessageKind::diverged) throw Stop(Exit::diverged, message.text());
}

void FrameSource::order(const std::vector<bool>& wanted) {
    Message orders;
    orders.kind = MessageKind::orders;
    for (std::size_t frame = 0; frame < wanted.size(); ++frame) {
        orders.first.push_back(wanted[frame] ? 1 : 0);
        if (wanted[frame]) wanted_.push_back(static_cast<int>(frame));
    }
    // A worker that has ended already is reported, with the reason, when its frame is due.
    for (Worker& worker : workers_) worker.channel.send(orders);
}

bool FrameSource::next(DrawnFrame& frame) {
    if (taken_ == wanted_.size()) return false;
    Message message;
    receive(workers_[taken_ % workers_.size()], message);
    if (message.kind != MessageKind::frame || message.frame != wanted_[taken_])
        throw render::Error(
            fmt::format("frame {} is missing; the drawing process sent another", wanted_[taken_]));
    ++taken_;
    frame.frame = message.frame;
    frame.stateHash = message.stateHash;
    frame.png = std::move(message.first);
    frame.data = std::move(message.data);
    frame.incident = std::move(message.incident);
    frame.notes = std::move(message.notes);
    frame.image = {};
    if (!message.second.empty()) frame.image = {width_, height_, std::move(message.second)};
    return true;
}

}  // namespace demos
