#include "demos/slides/slide_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "demos/film/film_needs.h"
#include "demos/film/frame_source.h"
#include "demos/film/strip_plan.h"
#include "demos/processes/signals.h"
#include "demos/text/stop.h"
#include "render/encode/png.h"
#include "render/encode/video.h"

namespace demos {
namespace {

/// One per third of a second: to step back, browsers decode from the previous key frame.
constexpr int kKeyFramesASecond = 3;

/// The drawing processes start before `begin` opens files that they should not inherit.
void drawFrames(const SlidePlan& plan, const Studio& studio, const std::function<void()>& begin,
                const std::function<void(const DrawnFrame&)>& take) {
    const int workers = workerCount(studio.jobs, static_cast<int>(plan.frames.size()));
    checkNeeds(needsOf(plan.film, workers, {}), plan.film);
    FrameSource source(plan.film, workers, false, true);
    begin();
    std::vector<bool> wanted(static_cast<std::size_t>(plan.frames.back() + 1));
    for (const int frame : plan.frames) wanted[frame] = true;
    source.order(wanted);
    DrawnFrame drawn;
    while (source.next(drawn)) {
        studio.incident = drawn.incident;
        take(drawn);
        studio.progress.advance();
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
    }
}

MadePicture pictureOf(const render::Image& image, const std::string& says) {
    return {render::encodePng(image), {}, {image.width, image.height}, says};
}

std::string namesOf(const FilmPlan& film) {
    if (film.panels.size() == 1) return film.name;
    std::vector<std::string> labels;
    for (const Panel& panel : film.panels) labels.push_back(panel.scene.title);
    return fmt::format("{} side by side: {}", film.name, fmt::join(labels, "; "));
}

/// The strip's layout with letters that are readable on a slide.
StripLayout stripOf(const SlidePlan& plan) {
    const PictureSize size{plan.film.layout.width, plan.film.layout.height};
    StripLayout layout =
        stripLayout(static_cast<int>(plan.frames.size()), plan.columns, size, true);
    const int room = layout.labelRoom();
    layout.label = std::max(layout.label, plan.letters);
    layout.height += layout.rows * (layout.labelRoom() - room);
    return layout;
}

std::string saysAt(const SlidePlan& plan, int frame) {
    return fmt::format("{}, at {:.6g} s", namesOf(plan.film), plan.timeOf(frame));
}

}  // namespace

MadeFilm madeFilm(const SlidePlan& plan, const std::filesystem::path& file, const Studio& studio) {
    MadeFilm film;
    film.frames = plan.last - plan.first + 1;
    film.fps = plan.rate.shown;
    film.first = plan.timeOf(plan.first);
    film.secondsAFrame = 1.0 / plan.rate.drawn;
    const bool moving = !file.empty();
    std::optional<render::VideoWriter> writer;
    const auto begin = [&] {
        if (moving)
            writer.emplace(
                file, render::VideoSource{plan.film.layout.width, plan.film.layout.height, film.fps,
                                          false, std::max(film.fps / kKeyFramesASecond, 1)});
    };
    drawFrames(plan, studio, begin, [&](const DrawnFrame& drawn) {
        if (moving) writer->add(drawn.image);
        if (drawn.frame == plan.poster)
            film.poster = pictureOf(drawn.image, saysAt(plan, drawn.frame));
    });
    if (!moving) return film;
    writer->close();
    film.file = file;
    return film;
}

MadePicture madeStill(const SlidePlan& plan, const Studio& studio) {
    MadePicture picture;
    drawFrames(
        plan, studio, [] {},
        [&](const DrawnFrame& drawn) {
            picture = pictureOf(drawn.image, saysAt(plan, drawn.frame));
        });
    return picture;
}

MadePicture madeStrip(const SlidePlan& plan, const Studio& studio) {
    const FilmPlan& film = plan.film;
    const StripLayout layout = stripOf(plan);
    render::Image paper = stripPaper(layout, film);
    int moment = 0;
    drawFrames(
        plan, studio, [] {},
        [&](const DrawnFrame& drawn) {
            placeMoment(layout, moment++, drawn.image, plan.timeOf(drawn.frame), film, paper);
        });
    return pictureOf(
        paper, fmt::format("{}, {} moments from {:.6g} s to {:.6g} s", namesOf(film), moment,
                           plan.timeOf(plan.frames.front()), plan.timeOf(plan.frames.back())));
}

}  // namespace demos
