#include "demos/film/caption_track.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "demos/film/outputs.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/stop.h"
#include "demos/text/table.h"

namespace demos {
namespace {

std::string cueTime(double seconds) {
    const long long all = std::llround(1e3 * seconds);
    return fmt::format("{:02}:{:02}:{:02}.{:03}", all / 3600000, all / 60000 % 60, all / 1000 % 60,
                       all % 1000);
}

/// One line, in which nothing is a tag or an arrow between two times.
std::string cueLine(const std::string& text) {
    std::string line;
    for (const char c : text)
        if (c == '&')
            line += "&amp;";
        else if (c == '<')
            line += "&lt;";
        else if (c == '>')
            line += "&gt;";
        else
            line += c == '\n' || c == '\r' ? ' ' : c;
    return line;
}

std::vector<const Section*> captionedSections(const SceneDescription& scene, double seconds) {
    std::vector<const Section*> sections;
    for (const Section& section : scene.sections)
        if (!section.caption.empty() && section.at < seconds) sections.push_back(&section);
    return sections;
}

}  // namespace

std::string captionTrackText(const FilmPlan& plan) {
    const std::vector<const Section*> sections =
        captionedSections(plan.scene(), plan.timeOf(plan.frames));
    if (sections.empty()) return {};
    std::string text = "WEBVTT\n";
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const double begin = plan.filmTimeAt(sections[i]->at);
        const double end =
            i + 1 < sections.size() ? plan.filmTimeAt(sections[i + 1]->at) : plan.seconds();
        text += fmt::format("\n{}\n{} --> {}\n{}\n", cueLine(sections[i]->name),
                            cueTime(begin), cueTime(end), cueLine(sections[i]->caption));
    }
    return text;
}

CaptionTrack::CaptionTrack(const FilmPlan& plan, const FilmOptions& options) {
    if (options.captions.empty()) return;
    target_ = expandPattern(options.captions, valuesOf(plan, 0));
    if (!target_.ends_with(".vtt"))
        throw Stop(Exit::usage,
                   fmt::format("--captions '{}': captions end in .vtt", printable(target_)));
    if (options.shard)
        throw Stop(Exit::usage, "--captions with --shard: they are for the whole film: impulse join "
                                "has --captions");
    text_ = captionTrackText(plan);
    if (text_.empty())
        throw Stop(Exit::usage, fmt::format("--captions '{}': no [[section]] of the scene has a "
                                            "caption",
                                            printable(target_)));
    checkFree(target_, options.overwrite);
    existing_ = existingFiles(options.overwrite);
}

void CaptionTrack::write() const {
    if (text_.empty()) return;
    writeResult(target_, {reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size()},
                existing_);
}

void CaptionTrack::tell(const Talk& talk) const {
    if (!text_.empty()) talk.say(fmt::format("wrote {}", printable(target_)));
}

}  // namespace demos
