#include "demos/watch/draft_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "demos/text/complaints.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostSpans = 3;  // listed one by one

/// The names of the sections that these frames are in, in the order of the film.
std::vector<std::string> sectionsOf(const FrameSpan& span, const FilmPlan& plan) {
    const std::vector<Section>& sections = plan.scene().sections;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const bool last = i + 1 == sections.size();
        const double end = last ? plan.timeOf(plan.frames) : sections[i + 1].at;
        const double rounding = 1e-6;  // s
        if (plan.timeOf(span.last) > sections[i].at - rounding &&
            plan.timeOf(span.first) < end - rounding && !sections[i].name.empty())
            names.push_back(sections[i].name);
    }
    return names;
}

std::string sectionsText(const FrameSpan& span, const FilmPlan& plan) {
    std::string text;
    for (const std::string& name : sectionsOf(span, plan))
        text += (text.empty() ? "" : ", ") + fmt::format("'{}'", printable(name));
    const bool several = text.find("', '") != std::string::npos;
    return text.empty() ? text : (several ? ", sections " : ", section ") + text;
}

std::string spanText(const FrameSpan& span, const FilmPlan& plan) {
    const double from = plan.timeOf(span.first), to = plan.timeOf(span.last);
    const std::string where = sectionsText(span, plan);
    if (span.first == span.last)
        return fmt::format("frame {} ({:.2f} s{})", span.first, from, where);
    return fmt::format("frames {} to {} ({:.2f} to {:.2f} s{})", span.first, span.last, from, to,
                       where);
}

int countOf(const std::vector<FrameSpan>& spans) {
    int count = 0;
    for (const FrameSpan& span : spans) count += span.last - span.first + 1;
    return count;
}

std::string lengthText(const Draft& draft) {
    return fmt::format("the film has {}, it had {}", plural(draft.frames, "frame"),
                       draft.framesBefore);
}

std::string stateText(const Draft& draft, const FilmPlan& plan) {
    if (*draft.firstStep == 0) return "state differs from the start";
    return fmt::format("state differs from step {} on ({:.3f} s)", *draft.firstStep,
                       static_cast<double>(*draft.firstStep) / plan.scene().hz);
}

}  // namespace

std::string changeText(const Draft& draft, const FilmPlan& plan) {
    const std::vector<FrameSpan>& spans = draft.changed;
    if (spans.empty())
        return draft.frames == draft.framesBefore ? "no frame changed" : lengthText(draft);
    std::string text;
    if (spans.size() <= kMostSpans)
        for (const FrameSpan& span : spans)
            text += (text.empty() ? "" : ", ") + spanText(span, plan);
    else
        text = fmt::format("{} frames in {} spans of {}", countOf(spans), spans.size(),
                           spanText({spans.front().first, spans.back().last}, plan));
    text += " changed";
    if (draft.frames != draft.framesBefore) text += "; " + lengthText(draft);
    return text;
}

std::vector<std::string> draftLines(const Draft& draft, const FilmPlan& plan,
                                    const DraftPlaces& places) {
    std::vector<std::string> lines;
    if (draft.framesBefore > 0) {
        lines.push_back(changeText(draft, plan));
        if (draft.firstStep) lines.push_back(stateText(draft, plan));
    }
    if (draft.pictured >= 0)
        lines.push_back(fmt::format("wrote {} (frame {}, t = {:.3f} s)",
                                    printable(places.picture().string()), draft.pictured,
                                    plan.timeOf(draft.pictured)));
    const std::string film = printable(places.toOpen().string());
    if (draft.written)
        lines.push_back(fmt::format("wrote {} ({}, {} drawn), open it", film,
                                    plural(draft.frames, "frame"), draft.drawn));
    return lines;
}

std::vector<std::string> failureLines(const Draft& draft, const FilmPlan& plan) {
    std::vector<std::string> lines;
    for (const ExpectationResult& result : draft.failed)
        lines.push_back(fmt::format("{}: failed: {}: {}{}", printable(plan.name), result.text,
                                    cameOut(result),
                                    result.why.empty() ? "" : " (" + printable(result.why) + ")"));
    if (!draft.trouble.empty()) lines.push_back(draft.trouble);
    return lines;
}

std::string draftJson(const Draft& draft, const FilmPlan& plan, const DraftPlaces& places) {
    Json json{{"event", "draft"},
              {"frames", draft.frames},
              {"before", draft.framesBefore},
              {"drawn", draft.drawn},
              {"written", draft.written}};
    json["open"] = places.toOpen().string();
    if (draft.pictured >= 0) json["picture"] = places.picture().string();
    json["changed"] = Json::array();
    for (const FrameSpan& span : draft.changed)
        json["changed"].push_back(
            {{"first", span.first}, {"last", span.last}, {"sections", sectionsOf(span, plan)}});
    json["first_step"] = draft.firstStep ? Json(*draft.firstStep) : Json(nullptr);
    json["failed"] = Json::array();
    for (const ExpectationResult& result : draft.failed)
        json["failed"].push_back(
            {{"text", result.text},
             {"value", std::isfinite(result.value) ? Json(result.value) : Json(nullptr)},
             {"unit", result.unit},
             {"worst", result.worst},
             {"why", result.why}});
    if (!draft.trouble.empty()) json["diverged"] = draft.trouble;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace demos
