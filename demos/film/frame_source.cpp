#include "demos/film/frame_source.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>
#include <utility>

#include "demos/film/simulator.h"
#include "demos/film/worker.h"
#include "demos/processes/child_process.h"
#include "demos/text/stop.h"
#include "render/context.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

/// The two ends of a socket.
std::array<Channel, 2> connected() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        throw render::Error("cannot start a worker: " + render::describeError(errno));
    return {Channel(ends[0]), Channel(ends[1])};
}

/// Runs `work` in a process of its own. It ends with _exit, so that it runs none of the parent's exit
/// handlers.
template <class Work>
pid_t forked(Work work) {
    const pid_t parent = getpid(), process = fork();
    if (process < 0) throw render::Error("cannot start a worker: " + render::describeError(errno));
    if (process > 0) return process;
    becomeChildOf(parent);  // the parent handles SIGINT: it finishes the frame
    work();
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
    std::vector<Channel> states;  // by worker, its end; empty: it simulates itself
    if (jobs > 1 && canDrawFromStates(plan)) states = startSimulator(plan, jobs);
    for (int i = 0; i < jobs; ++i) {
        auto [mine, theirs] = connected();
        const pid_t process = forked([&, &mine = mine, &theirs = theirs] {
            mine.close();
            simulator_.channel.close();
            for (Worker& worker : workers_) worker.channel.close();
            for (int other = 0; other < static_cast<int>(states.size()); ++other)
                if (other != i) states[other].close();
            runWorker(plan, {i, jobs, png, raw}, theirs, states.empty() ? nullptr : &states[i]);
        });
        workers_.push_back({process, std::move(mine)});
    }
    meet();
}

/// The workers' ends of its channels.
std::vector<Channel> FrameSource::startSimulator(const FilmPlan& plan, int jobs) {
    std::vector<Channel> feeds, states;
    for (int i = 0; i < jobs; ++i) {
        auto [feed, state] = connected();
        feeds.push_back(std::move(feed));
        states.push_back(std::move(state));
    }
    auto [mine, theirs] = connected();
    simulator_.process = forked([&, &mine = mine, &theirs = theirs] {
        mine.close();
        states.clear();
        runSimulator(plan, theirs, feeds);
    });
    simulator_.channel = std::move(mine);
    return states;
}

FrameSource::~FrameSource() {
    if (simulator_.process > 0) workers_.push_back(std::move(simulator_));
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
    if (!worker.channel.receive(message))
        throw render::Error("a drawing process " + deathOf(std::exchange(worker.process, 0)));
    if (message.kind == MessageKind::orphaned)
        throw render::Error("the simulating process " + deathOf(std::exchange(simulator_.process, 0)));
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
    if (simulator_.process > 0) simulator_.channel.send(orders);
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
