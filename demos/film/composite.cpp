#include "demos/film/composite.h"

#include <algorithm>
#include <cmath>

#include "demos/film/framing.h"
#include "demos/look/inks.h"
#include "demos/snapshot/camera.h"
#include "demos/text/stop.h"
#include "engine/base/hash.h"
#include "render/canvas.h"
#include "render/error.h"

namespace demos {
namespace {

constexpr std::uint8_t kWhite = 255, kHalf = 128;

void place(const render::Image& part, int x, int y, render::Image& whole) {
    for (int row = 0; row < part.height; ++row)
        std::copy_n(part.at(0, row), 4 * part.width, whole.at(x, y + row));
}

/// A white line on the right and below, where another panel follows; `grid`: the size of all panels together.
void drawBorder(const Area& at, const Area& grid, render::Image& whole) {
    const int width = std::max(whole.height / 360, 1);
    const int right = at.x + at.width, bottom = at.y + at.height;
    for (int y = at.y; y < bottom; ++y)
        if (right < grid.width) std::fill_n(whole.at(right - width, y), 4 * width, kWhite);
    for (int y = bottom - width; y < bottom; ++y)
        if (bottom < grid.height) std::fill_n(whole.at(at.x, y), 4 * at.width, kWhite);
}

/// Of all panels and the plot.
Area gridOf(const PanelLayout& layout) {
    Area grid;
    const auto add = [&](const Area& at) {
        grid.width = std::max(grid.width, at.x + at.width);
        grid.height = std::max(grid.height, at.y + at.height);
    };
    for (const Area& panel : layout.panels) add(panel);
    add(layout.strip);
    return grid;
}

/// Half transparent, so that what is below stays visible.
void drawCursor(int x, int top, int bottom, render::Image& whole) {
    const int width = std::max(whole.height / 360, 1);
    for (int column = std::max(x, 0); column < std::min(x + width, whole.width); ++column)
        for (int y = std::max(top, 0); y < std::min(bottom, whole.height); ++y) {
            std::uint8_t* pixel = whole.at(column, y);
            for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>((pixel[c] + 128) / 2);
            pixel[3] = std::max(pixel[3], kHalf);  // on a strip without a background
        }
}

/// A shutter that is open across a cut uses the camera after the cut for all its moments.
/// `seen`: the newest is at `time`, each one before it a step earlier.
void keepShot(const CameraDescription& camera, double time, double step,
              std::vector<render::Frame>& seen) {
    const int newest = static_cast<int>(seen.size()) - 1;
    for (int i = newest - 1; i >= 0; --i)
        if (shotAt(camera, time - (newest - i) * step) != shotAt(camera, time))
            seen[i].camera = seen[i + 1].camera;
}

/// In the theme's background colour, which stays where there is no panel.
render::Image emptyPicture(const FilmPlan& plan) {
    render::Image whole{plan.layout.width, plan.layout.height, {}};
    whole.pixels.resize(4 * static_cast<std::size_t>(whole.width) * whole.height);
    const render::Color ground = inksOf(plan.panels.front().overlays.theme).ground;
    render::fillRectangle(whole, {0.0f, 0.0f}, static_cast<float>(whole.width),
                          static_cast<float>(whole.height), ground);
    return whole;
}

void placeStrip(const FilmPlan& plan, double time, render::Image& whole) {
    const Area& strip = plan.layout.strip;
    place(plan.strip, strip.x, strip.y, whole);
    const auto& cursor = plan.cursor;
    const float share = static_cast<float>(std::min(time / plan.scene().seconds, 1.0));
    const int x = static_cast<int>(std::lround(cursor.start + share * (cursor.end - cursor.start)));
    drawCursor(strip.x + x, strip.y + static_cast<int>(cursor.top),
               strip.y + static_cast<int>(cursor.bottom), whole);
}

}  // namespace

render::Image withStrip(render::Image panel, const FilmPlan& plan, double time) {
    if (plan.strip.pixels.empty()) return panel;
    render::Image whole = emptyPicture(plan);
    const Area& at = plan.layout.panels.front();
    place(panel, at.x, at.y, whole);
    const bool onPaper = plan.panels.front().overlays.pixelsPerPoint > 0.0;  // one background
    if (!plan.alpha() && !onPaper) drawBorder(at, gridOf(plan.layout), whole);
    placeStrip(plan, time, whole);
    return whole;
}

Composite::Composite(const FilmPlan& plan) : plan_(plan) {
    for (const Panel& panel : plan.panels)
        shows_.push_back(std::unique_ptr<Show>(
            new Show{Player(panel.scene, panel.overlays), panel.scene.hz / plan.fps, {}, {}}));
}

bool needsOneState(const FilmPlan& plan) {
    const auto needsAll = [](Pass pass) { return pass == Pass::contacts || pass == Pass::events; };
    return plan.panels.size() == 1 && std::ranges::none_of(plan.passes, needsAll);
}

std::optional<ReadState> stateBefore(int frame, const FilmPlan& plan) {
    if (plan.states.empty() || !needsOneState(plan)) return std::nullopt;
    const int most = plan.shutter.moments > 1 ? frame - 1 : frame;  // it opens before the frame
    return nearestState(plan.states, plan.stateKind, plan.panels.front().overlays,
                        plan.stepOf(most));
}

int Composite::startBefore(int frame) {
    const std::optional<ReadState> state = stateBefore(frame, plan_);
    if (!state) return 0;
    Show& show = *shows_.front();
    const Panel& panel = plan_.panels.front();
    if (!show.player.restoreState(state->player())) {
        shows_.front().reset(new Show{Player(panel.scene, panel.overlays), show.steps, {}, {}});
        return 0;
    }
    const int step = static_cast<int>(state->step);
    while (plan_.stepOf(frame_) < step) ++frame_;
    show.player.step(plan_.stepOf(frame_) - step);
    return frame_;
}

void Composite::writeState(const std::filesystem::path& folder, std::vector<std::uint8_t>& memory) const {
    demos::writeState(folder, plan_.stateKind, plan_.panels.front().overlays, shows_.front()->player, memory);
}

void Composite::restoreState(int frame, std::span<const std::uint8_t> bytes) {
    if (!shows_.front()->player.restoreState(bytes))
        throw render::Error("the state of a frame cannot be read");
    frame_ = frame;
}

void Composite::advance(bool drawn) {
    ++frame_;
    for (const auto& show : shows_)
        if (show->trouble.empty()) advance(*show, drawn, plan_.timeOf(frame_));
}

void Composite::advance(Show& show, bool drawn, double time) try {
    if (!plan_.slowSteps.empty()) show.steps = plan_.stepOf(frame_) - plan_.stepOf(frame_ - 1);
    const Shutter shutter(plan_.shutter, show.steps);
    const double step = 1.0 / show.player.stage().scene.hz;
    show.seen.clear();
    for (int left = show.steps; left > 0; --left) {
        if (drawn && shutter.sees(left)) show.seen.push_back(frameOf(show, time - left * step));
        stepOnce(show);
        if (watcher_ && &show == shows_.front().get()) watcher_(show.player.stage());
    }
} catch (const Stop& stop) {
    if (shows_.size() == 1 || stop.code() != Exit::diverged) throw;
    show.trouble = stop.what();
    show.seen.clear();
}

render::Image Composite::drawPanel(Show& show, double time, render::Renderer& renderer) const {
    if (plan_.shutter.moments <= 1) return renderer.draw(frameOf(show, time));
    show.seen.push_back(frameOf(show, time));
    const SceneDescription& scene = show.player.stage().scene;
    keepShot(scene.camera, time, 1.0 / scene.hz, show.seen);
    return renderer.draw(Shutter(plan_.shutter, show.steps).moments(show.seen));
}

/// Arrows and colours of several panels have one scale, so that they can be compared, and each has its label.
render::Frame Composite::pictureOf(const Show& show, double time) const {
    if (shows_.size() == 1) return show.player.frame(time);
    History history = show.player.history();
    for (const auto& other : shows_) {
        const History& its = other->player.history();
        history.impulsePeak = std::max(history.impulsePeak, its.impulsePeak);
        history.nudgePeak = std::max(history.nudgePeak, its.nudgePeak);
        history.largestValue = std::max(history.largestValue, its.largestValue);
    }
    render::Frame frame = show.player.frame(time, history);
    for (render::Text& text : frame.texts) text.needed = true;
    return frame;
}

render::Frame Composite::frameOf(const Show& show, double time) const {
    render::Frame frame = pictureOf(show, time);
    fitCamera(plan_.picture.width, plan_.picture.height, frame);
    if (!show.trouble.empty())
        frame.texts.push_back(incidentMark("the last good state"));
    else if (shows_.size() > 1 && !show.player.incidents().empty())
        frame.texts.push_back(incidentMark(bodyAndStep(show.player.incidents().front())));
    return frame;
}

std::string Composite::incident() const {
    for (const auto& show : shows_) {
        const std::string& line =
            show->trouble.empty() ? show->player.incident() : show->trouble;
        if (line.empty()) continue;
        return shows_.size() == 1 ? line : show->player.stage().scene.title + ": " + line;
    }
    return {};
}

std::string Composite::incidentAtEnd() try {
    for (const auto& show : shows_) {
        const Stage& stage = show->player.stage();
        const long end = std::lround(stage.scene.seconds * stage.scene.hz);
        while (show->trouble.empty() && stage.world.report().step < end) stepOnce(*show);
    }
    return incident();
} catch (const Stop& stop) {  // a step failed; every frame has been drawn
    return stop.what();
}

void Composite::stepOnce(Show& show) {
    show.player.step();
    if (run_) run_->look(show.player.stage());
}

void Composite::watchRun() {
    if (shows_.size() == 1) run_.emplace(stage());
}

std::string Composite::notesAtEnd() const {
    std::string notes;
    if (!run_ || !shows_.front()->player.incidents().empty()) return notes;
    for (const std::string& line : run_->lines(stage())) notes += line + "\n";
    return notes;
}

render::Image Composite::draw(int frame, render::Renderer& renderer) {
    const double time = plan_.timeOf(frame);
    if (shows_.size() == 1)
        return withStrip(drawPanel(*shows_.front(), time, renderer), plan_, time);
    render::Image whole = emptyPicture(plan_);
    const Area grid = gridOf(plan_.layout);
    for (std::size_t i = 0; i < shows_.size(); ++i) {
        const Area& at = plan_.layout.panels[i];
        place(drawPanel(*shows_[i], time, renderer), at.x, at.y, whole);
        drawBorder(at, grid, whole);
    }
    if (!plan_.strip.pixels.empty()) placeStrip(plan_, time, whole);
    return whole;
}

render::Frame Composite::plainFrame(int frame) const {
    Overlays none;
    none.trails = none.text = false;
    const double time = plan_.timeOf(frame);
    render::Frame plain = snapshot(stage(), none, time, shows_.front()->player.history());
    plain.camera = frameOf(*shows_.front(), time).camera;  // fitted to the picture's texts
    return plain;
}

render::Frame Composite::frameWith(const Overlays& overlays, int frame) const {
    render::Frame shown =
        snapshot(stage(), overlays, plan_.timeOf(frame), shows_.front()->player.history());
    fitCamera(plan_.picture.width, plan_.picture.height, shown);
    return shown;
}

std::uint64_t Composite::hash() const {
    if (shows_.size() == 1) return shows_.front()->player.stage().world.hash();
    engine::StateHash hash;
    for (const auto& show : shows_) hash.add(show->player.stage().world.hash());
    return hash.value();
}

}  // namespace demos
