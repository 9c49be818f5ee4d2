#include "demos/slides/slide_facts.h"

#include <fmt/format.h>

#include "demos/slides/slide_arrangement.h"
#include "demos/slides/slide_charts.h"
#include "demos/slides/slide_numbers.h"
#include "demos/slides/slide_tables.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

void stopAt(const std::string& failed) {
    if (!failed.empty()) throw Stop(Exit::diverged, failed);
}

}  // namespace

SlideFacts::SlideFacts(const Slide& slide, const LoadedRuns& loaded, DeckRuns& runs)
    : slide_(slide), loaded_(loaded), runs_(runs) {
    for (const NumberName& name : numbersIn(slide)) askNumber(name);
    for (std::size_t run = 0; run < loaded.variants.size(); ++run) {
        if (asksAll()) askMoment(run);
        if (slide.expectations) runs_.askExpectations(keyOf(run), loaded.variants[run].scene);
    }
}

void SlideFacts::askNumber(const NumberName& name) {
    const std::size_t count = loaded_.variants.size();
    const auto run = static_cast<std::size_t>(name.run - 1);
    if (run >= count)
        throw Stop(Exit::scene, fmt::format("there is no run {}; the slide has {} {}", name.run,
                                            count, count == 1 ? "run" : "runs"));
    askMoment(run);
    if (name.group == "expect") runs_.askExpectations(keyOf(run), loaded_.variants[run].scene);
}

void SlideFacts::askMoment(std::size_t run) {
    const Variant& variant = loaded_.variants[run];
    runs_.askMoment(keyOf(run), variant.scene, untilOf(slide_, variant));
    asked_.insert(run);
}

const PlayedMoment& SlideFacts::momentOf(std::size_t run) const {
    return runs_.moment(keyOf(run), untilOf(slide_, loaded_.variants[run]));
}

void SlideFacts::checkFailed(std::size_t run, bool toEnd) const {
    if (toEnd) stopAt(runs_.failed(keyOf(run)));
    if (asked_.count(run) > 0) stopAt(momentOf(run).failed);
}

std::string SlideFacts::incident() const {
    for (std::size_t run = 0; run < loaded_.variants.size(); ++run) {
        const bool asked = asked_.count(run) > 0;
        if (!asked && !slide_.expectations) continue;
        const std::string& line =
            slide_.expectations ? runs_.incident(keyOf(run)) : momentOf(run).summary.diverged;
        if (line.empty()) continue;
        return loaded_.several ? loaded_.variants[run].label + ": " + line : line;
    }
    return {};
}

std::string SlideFacts::valueOf(const NumberName& name, NumberSetting setting) const {
    static const std::vector<ExpectationResult> kNone;
    const auto run = static_cast<std::size_t>(name.run - 1);
    const PlayedMoment& played = momentOf(run);
    const bool expects = name.group == "expect";
    checkFailed(run, expects);
    return demos::valueOf(name,
                          {loaded_.variants[run].scene, played.summary, played.moment,
                           expects ? runs_.expectations(keyOf(run)) : kNone},
                          setting);
}

std::vector<Measured> SlideFacts::measured() const {
    std::vector<Measured> all;
    for (std::size_t run = 0; run < loaded_.variants.size(); ++run)
        all.push_back({loaded_.variants[run], momentOf(run).summary});
    return all;
}

void SlideFacts::addTables(MadeSlide& made, const std::vector<Measured>& all, bool timing) {
    if (slide_.measures) made.tables.push_back(measuresTable(all, loaded_.several, timing));
    if (!slide_.expectations) return;
    std::vector<RunExpectations> expected;
    for (std::size_t run = 0; run < loaded_.variants.size(); ++run)
        expected.push_back({loaded_.variants[run].label, &loaded_.variants[run].scene,
                            runs_.expectations(keyOf(run))});
    made.tables.push_back(expectationsTable(expected));
}

void SlideFacts::fill(MadeSlide& made, const std::string& theme, std::optional<double> exhibit,
                      bool timing) {
    if (!loaded_.several && !loaded_.variants.empty()) checkFailed(0, slide_.expectations);
    fillNumbers(made.slide, [&](const NumberName& name, NumberSetting setting) {
        return valueOf(name, setting);
    });
    if (loaded_.variants.empty()) return;
    const std::vector<Measured> all = asksAll() ? measured() : std::vector<Measured>();
    addTables(made, all, timing);
    if (slide_.plots.empty()) return;
    const std::vector<Chart> charts = chartsOf(slide_, loaded_, momentOf(0).recorder, all);
    const SlideRoom room = chartRoom(made.slide, made.tables, charts.size(), exhibit);
    for (const Chart& chart : charts) made.pictures.push_back(chartPicture(chart, room, theme));
}

}  // namespace demos
