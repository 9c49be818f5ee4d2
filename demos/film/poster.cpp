#include "demos/film/poster.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "demos/film/outputs.h"
#include "demos/text/complaints.h"
#include "demos/text/stop.h"
#include "demos/text/table.h"
#include "render/encode/png.h"

namespace demos {
namespace {

/// "first" and "last" are the section's own frames; a number is a time of the run.
int frameOf(const FilmPlan& plan, std::size_t index) {
    const std::vector<Section>& sections = plan.scene().sections;
    const Section& section = sections[index];
    if (section.poster == "first") return plan.frameAt(section.at);
    if (section.poster == "last")
        return index + 1 < sections.size()
                   ? std::max(plan.frameAt(sections[index + 1].at) - 1, plan.frameAt(section.at))
                   : plan.frames - 1;
    double time = 0.0;
    std::from_chars(section.poster.data(), section.poster.data() + section.poster.size(), time);
    return plan.frameAt(time);
}

}  // namespace

int posterFrame(const FilmPlan& plan, const std::optional<double>& time) {
    if (time) {
        const double last = plan.timeOf(plan.frames - 1);
        if (*time > last + 0.5 / plan.fps)
            throw Stop(Exit::usage, fmt::format("--poster-time {}: the film's last frame is at "
                                                "{:.4g} s",
                                                *time, last));
        return plan.frameAt(*time);
    }
    const std::vector<Section>& sections = plan.scene().sections;
    for (std::size_t i = 0; i < sections.size(); ++i)
        if (!sections[i].poster.empty()) return frameOf(plan, i);
    return plan.frames / 2;
}

Poster::Poster(const FilmPlan& plan, const FilmOptions& options) {
    if (options.poster.empty()) return;
    const int frame = posterFrame(plan, options.posterTime);
    target_ = expandPattern(options.poster, valuesOf(plan, frame));
    if (!target_.ends_with(".png"))
        throw Stop(Exit::usage,
                   fmt::format("--poster '{}': a poster ends in .png", printable(target_)));
    checkFree(target_, options.overwrite);
    frame_ = frame;
    existing_ = existingFiles(options.overwrite);
}

void Poster::add(const DrawnFrame& frame) {
    if (!wants(frame.frame)) return;
    png_ = frame.png.empty() ? render::encodePng(frame.image) : frame.png;
}

void Poster::write() const {
    if (!png_.empty()) writeResult(target_, png_, existing_);
}

void Poster::tell(const FilmPlan& plan, const Talk& talk) const {
    if (png_.empty()) return;
    talk.say(fmt::format("wrote {} (frame {}, t = {:.3f} s)", printable(target_), frame_,
                         plan.timeOf(frame_)));
}

}  // namespace demos
