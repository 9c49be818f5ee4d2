#include "demos/film/simulator.h"

#include <algorithm>
#include <exception>

#include "demos/film/composite.h"
#include "demos/film/resume_states.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

void simulate(const FilmPlan& plan, Channel& orders, std::vector<Channel>& feeds) {
    Message wanted;
    if (!orders.receive(wanted)) return;
    const int earlier = plan.shutter.moments > 1 ? 1 : 0;  // the shutter opens before the frame
    const int last = plan.frames - 1;
    Composite composite(plan);
    Message state;
    state.kind = MessageKind::state;
    std::size_t ordinal = 0;
    ResumeStates resume(plan);
    for (int frame = 0; frame < static_cast<int>(wanted.first.size()); ++frame) {
        if (!wanted.first[frame]) continue;
        if (ordinal == 0) {
            state.frame = composite.startBefore(frame);
            if (state.frame == 0 && wanted.first[last]) composite.watchRun();
        }
        for (; state.frame < frame - earlier; ++state.frame) {
            resume.begin();
            composite.advance(false);
            resume.end(composite);
        }
        composite.saveState(state.first);
        if (frame == last) {
            state.incident = composite.incidentAtEnd();
            state.notes = composite.notesAtEnd();
        }
        if (!feeds[ordinal++ % feeds.size()].send(state)) return;
    }
}

}  // namespace

bool canDrawFromStates(const FilmPlan& plan) {
    const auto needsMore = [](Pass pass) {
        return pass == Pass::contacts || pass == Pass::events || pass == Pass::flow;
    };
    return plan.panels.size() == 1 && std::ranges::none_of(plan.passes, needsMore);
}

void runSimulator(const FilmPlan& plan, Channel& orders, std::vector<Channel>& feeds) noexcept {
    const auto tellAll = [&feeds](MessageKind kind, const char* what) {
        for (Channel& feed : feeds) feed.send(Message::ofText(kind, what));
    };
    try {
        simulate(plan, orders, feeds);
    } catch (const Stop& stop) {
        tellAll(MessageKind::diverged, stop.what());
    } catch (const std::exception& error) {
        tellAll(MessageKind::failed, error.what());
    }
}

}  // namespace demos
