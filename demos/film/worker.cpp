#include "demos/film/worker.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

#include "demos/film/data_files.h"
#include "demos/film/resume_states.h"
#include "demos/text/stop.h"
#include "render/encode/png.h"
#include "render/renderer.h"

namespace demos {
namespace {

/// What a worker simulates and draws with.
struct Desk {
    render::Renderer renderer;
    Composite composite;
    DataFiles data;

    Desk(const FilmPlan& plan, const render::RendererSettings& settings)
        : renderer(settings), composite(plan), data(plan, composite) {}
};

Message drawnMessage(Desk& desk, int frame, const WorkerTask& task) {
    render::Image image = desk.composite.draw(frame, desk.renderer);
    Message message;
    message.kind = MessageKind::frame;
    message.frame = frame;
    message.stateHash = desk.composite.hash();
    message.incident = desk.composite.incident();
    if (task.png) message.first = render::encodePng(image);
    if (task.raw) message.second = std::move(image.pixels);
    message.data = desk.data.make(frame, desk.renderer);
    return message;
}

/// The wanted frames that this process draws.
std::vector<int> framesOf(const WorkerTask& task, const std::vector<std::uint8_t>& wanted) {
    std::vector<int> frames;
    int ordinal = 0;
    for (int frame = 0; frame < static_cast<int>(wanted.size()); ++frame)
        if (wanted[frame] && ordinal++ % task.count == task.index) frames.push_back(frame);
    return frames;
}

/// Simulates from the beginning, or from a state in a file.
void drawPlayed(Desk& desk, const std::vector<int>& own, const FilmPlan& plan,
                const WorkerTask& task, Channel& channel) {
    const int start = desk.composite.startBefore(own.front());
    const int last = plan.frames - 1;
    if (start == 0 && own.back() == last) desk.composite.watchRun();
    ResumeStates resume(plan);
    for (int frame = start; frame <= own.back(); ++frame) {
        const bool mine = std::ranges::binary_search(own, frame);
        if (task.index == 0) resume.begin();
        if (frame > start) desk.data.advance(mine);
        if (task.index == 0) resume.end(desk.composite);
        if (!mine) continue;
        Message message = drawnMessage(desk, frame, task);
        if (frame == last) {
            message.incident = desk.composite.incidentAtEnd();
            message.notes = desk.composite.notesAtEnd();
        }
        if (!channel.send(message)) return;
    }
}

void drawStates(Desk& desk, const std::vector<int>& own, const FilmPlan& plan,
                const WorkerTask& task, Channel& channel, Channel& states) {
    Message state;
    for (const int frame : own) {
        if (!states.receive(state)) state.kind = MessageKind::orphaned;
        if (state.kind != MessageKind::state) {  // why it ended
            channel.send(state);
            return;
        }
        desk.composite.restoreState(state.frame, state.first);
        if (state.frame < frame) desk.data.advance(true);
        Message message = drawnMessage(desk, frame, task);
        if (frame == plan.frames - 1) {
            message.incident = std::move(state.incident);
            message.notes = std::move(state.notes);
        }
        if (!channel.send(message)) return;
    }
}

void work(const FilmPlan& plan, const WorkerTask& task, Channel& channel, Channel* states) {
    render::RendererSettings settings = plan.picture;
    settings.threads = 0;  // this process is the thread
    Desk desk(plan, settings);
    Message orders;
    if (!channel.send(Message::ofText(MessageKind::ready, desk.renderer.describe())) ||
        !channel.receive(orders))
        return;
    const std::vector<int> own = framesOf(task, orders.first);
    if (own.empty()) return;
    if (states)
        drawStates(desk, own, plan, task, channel, *states);
    else
        drawPlayed(desk, own, plan, task, channel);
}

}  // namespace

void runWorker(const FilmPlan& plan, const WorkerTask& task, Channel& channel,
               Channel* states) noexcept {
    try {
        work(plan, task, channel, states);
    } catch (const Stop& stop) {
        channel.send(Message::ofText(MessageKind::diverged, stop.what()));
    } catch (const std::exception& error) {
        channel.send(Message::ofText(MessageKind::failed, error.what()));
    }
}

}  // namespace demos
