#include "demos/film/worker.h"

#include <exception>

#include "demos/film/screen.h"
#include "demos/stop.h"
#include "render/encode/png.h"
#include "render/renderer.h"

namespace demos {
namespace {

Message drawnMessage(Screen& screen, int frame, const WorkerTask& task,
                     render::Renderer& renderer) {
    render::Image image = screen.draw(frame, renderer);
    Message message;
    message.kind = MessageKind::frame;
    message.frame = frame;
    message.stateHash = screen.hash();
    if (task.png) message.first = render::encodePng(image);
    if (task.raw) message.second = std::move(image.pixels);
    return message;
}

void work(const FilmPlan& plan, const WorkerTask& task, Channel& channel) {
    render::RendererSettings settings = plan.picture;
    settings.threads = 0;  // this process is the thread
    render::Renderer renderer(settings);
    Screen screen(plan);
    Message orders;
    if (!channel.send(Message::ofText(MessageKind::ready, renderer.describe())) ||
        !channel.receive(orders))
        return;
    int ordinal = 0;
    for (int frame = 0; frame < static_cast<int>(orders.first.size()); ++frame) {
        const bool mine = orders.first[frame] && ordinal++ % task.count == task.index;
        if (frame > 0) screen.advance(mine);
        if (!mine) continue;
        if (!channel.send(drawnMessage(screen, frame, task, renderer))) return;
    }
}

}  // namespace

void runWorker(const FilmPlan& plan, const WorkerTask& task, Channel& channel) noexcept {
    try {
        work(plan, task, channel);
    } catch (const Stop& stop) {
        channel.send(Message::ofText(MessageKind::diverged, stop.what()));
    } catch (const std::exception& error) {
        channel.send(Message::ofText(MessageKind::failed, error.what()));
    }
}

}  // namespace demos
