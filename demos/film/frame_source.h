/// Draws a film in several processes, a context each (two contexts in one process would wait for
/// each other). Every worker plays the whole simulation, which is the same to the bit in all of
/// them, and draws every n-th of the wanted frames; the parent takes them in turn, so their order
/// is given.
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
    std::vector<std::uint8_t> png;  // empty where not asked for
    render::Image image;            // empty where not asked for
    std::vector<std::vector<std::uint8_t>> data;  // a file for each of the plan's passes
};

class FrameSource {
public:
    /// Forks the workers: call before any OpenGL, and before files are opened that a child should
    /// not hold. `png`, `raw`: what is wanted of each frame.
    FrameSource(const FilmPlan& plan, int jobs, bool png, bool raw);
    ~FrameSource();
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    /// The renderer's name. Throws render::Error when a worker has none.
    const std::string& renderer() const { return renderer_; }

    /// Which frames are to be drawn; once, before next().
    void order(const std::vector<bool>& wanted);

    /// The next wanted frame; false: there are no more. Throws render::Error when a worker failed
    /// or died, Stop (diverged) when the simulation did.
    bool next(DrawnFrame& frame);

private:
    struct Worker {
        pid_t process;
        Channel channel;
    };
    void meet();
    void receive(Worker& worker, Message& message);

    std::vector<Worker> workers_;
    std::string renderer_;
    std::vector<int> wanted_;
    std::size_t taken_ = 0;
    int width_, height_;
};

/// One per core, at least 1; never more than there are frames.
int workerCount(int jobs, int frames);

}  // namespace demos
