/// Draws a film in several processes with one context each (two contexts in one process would wait
/// for each other). Every worker draws every n-th of the wanted frames. One more process
/// simulates for all of them (simulator.h) where a state of the simulation is enough; else every worker
/// runs all of it, with the same bits. The parent reads from the workers in turn, so that the frames
/// arrive in order.
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/processes/channel.h"

namespace demos {

struct DrawnFrame {
    int frame = 0;
    std::uint64_t stateHash = 0;
    std::vector<std::uint8_t> png;  // empty if not requested
    render::Image image;            // empty if not requested
    std::vector<std::vector<std::uint8_t>> data;  // a file for each of the plan's passes
    std::string incident;  // of the simulation until then; "": none
    std::string notes;     // of the last frame: what else to know of the run, a line each
};

class FrameSource {
public:
    /// Forks the workers: call before any OpenGL, and before opening files that a child should not
    /// inherit. `png`, `raw`: what to make of each frame. Throws render::Error when a worker fails.
    FrameSource(const FilmPlan& plan, int jobs, bool png, bool raw);
    ~FrameSource();
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    /// The renderer's name.
    const std::string& renderer() const { return renderer_; }

    /// Sets the frames to draw; call once, before next().
    void order(const std::vector<bool>& wanted);

    /// The next wanted frame; false: there are no more. Throws render::Error when a worker failed
    /// or died, Stop (diverged) when a step failed.
    bool next(DrawnFrame& frame);

private:
    struct Worker {
        pid_t process = 0;
        Channel channel{-1};
    };
    std::vector<Channel> startSimulator(const FilmPlan& plan, int jobs);
    void meet();
    void receive(Worker& worker, Message& message);

    std::vector<Worker> workers_;
    Worker simulator_;  // no process: the workers simulate
    std::string renderer_;
    std::vector<int> wanted_;
    std::size_t taken_ = 0;
    int width_, height_;
};

/// `jobs`, or one per core if that is 0; at least 1, at most `frames`.
int workerCount(int jobs, int frames);

}  // namespace demos
