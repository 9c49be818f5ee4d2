#include "demos/gallery/gallery_film.h"

#include <memory>

#include "demos/export/replay_page.h"
#include "demos/film/composite.h"
#include "demos/film/poster.h"
#include "demos/text/file_content.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/encode/video.h"
#include "render/renderer.h"

namespace demos {
namespace {

/// A frame without motion blur: where the film averages moments, all of its moments are the same.
render::Image posterOf(const Composite& composite, const FilmPlan& plan, int frame,
                       render::Renderer& renderer) {
    Overlays overlays = plan.panels.front().overlays;
    overlays.text = overlays.stats = false;
    const render::Frame shown = composite.frameWith(overlays, frame);
    const auto moments = static_cast<std::size_t>(plan.shutter.moments);
    render::Image image = moments <= 1 ? renderer.draw(shown)
                                       : renderer.draw(std::vector<render::Frame>(moments, shown));
    return withStrip(std::move(image), plan, plan.timeOf(frame));
}

render::RendererSettings ownThread(const FilmPlan& plan) {
    render::RendererSettings settings = plan.picture;
    settings.threads = 0;  // the processes share the cores
    return settings;
}

std::unique_ptr<render::VideoWriter> openFilm(const FilmPlan& plan,
                                              const std::filesystem::path& film) {
    if (film.empty()) return nullptr;
    const render::VideoSource source{plan.layout.width, plan.layout.height, plan.fps, false};
    return std::make_unique<render::VideoWriter>(film, source);
}

}  // namespace

DrawnPoster drawPoster(const FilmPlan& plan) {
    const int poster = posterFrame(plan);
    Composite composite(plan);
    render::Renderer renderer(ownThread(plan));
    for (int frame = 0; frame < poster; ++frame) composite.advance(false);
    return {posterOf(composite, plan, poster, renderer), composite.incident()};
}

GalleryEntry drawScene(const FilmPlan& plan, const GalleryFiles& files) {
    const std::unique_ptr<render::VideoWriter> writer = openFilm(plan, files.film);
    const int posterAt = posterFrame(plan);
    const int last = writer ? plan.frames - 1 : posterAt;
    Composite composite(plan);
    render::Renderer renderer(ownThread(plan));
    std::vector<std::uint8_t> png;
    for (int frame = 0; frame <= last; ++frame) {
        if (frame > 0) composite.advance(writer != nullptr);
        if (frame == posterAt) png = render::encodePng(posterOf(composite, plan, frame, renderer));
        if (writer) writer->add(composite.draw(frame, renderer));
    }
    if (writer) writer->close();
    render::writeFileAtomically(files.poster, png);
    if (!files.replay.empty())
        render::writeFileAtomically(files.replay, replayPage(recordingOf(plan)).html);
    return {0, hashOfFile(files.poster), hashOfFile(files.film), hashOfFile(files.replay),
            writer ? composite.incidentAtEnd() : composite.incident()};
}

}  // namespace demos
