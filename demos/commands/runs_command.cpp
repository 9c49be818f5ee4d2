#include "demos/commands/runs_command.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/measures/summary.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"

namespace demos {
namespace {

/// Prints the commands of the missing parts, then ends the command.
[[noreturn]] void refuseRuns(const PartReview& review, const RunsInParts& runs,
                             const RunsOptions& options, const Talk& talk) {
    const std::string& own = options.commandLine;
    const std::size_t at = own.find(" --merge"), end = own.find(' ', at + 1);
    for (const int number : review.wanted) {
        const std::string command = own.substr(0, at) +
                                    fmt::format(" --shard {}/{}", number, review.count) +
                                    own.substr(std::min(end, own.size()));
        talk.say("to do: " + printable(command));
        talk.json(fmt::format(R"({{"event":"wanted","shard":{},"command":{}}})", number,
                              jsonString(command)));
    }
    throw Stop(Exit::incomplete,
               fmt::format("'{}': {} of {} parts are complete; {}",
                           printable(runs.folder.string()), review.good.size(), review.count,
                           fmt::join(review.troubles, "; ")));
}

}  // namespace

void addRuns(CLI::App& app, RunsOptions& options, OptionTexts& texts) {
    addSceneChoice(app, options, texts);
    addSeconds(app, options);
    addPicture(app, options, texts);
    addFigure(app, options, texts);
    app.add_option("-t,--time", options.time,
                   "with --width: time of the figure in s; default: the end")
        ->type_name("S");
    addJobs(app, options);
    app.add_option("--measure", options.measure,
                   "the measure to plot: drift speed penetration separation energy residual "
                   "sweeps ms; "
                   "default: the most telling")
        ->type_name("NAME");
    app.add_option("--shard", texts.shard,
                   "simulate every N-th run from the K-th on and keep its measures for --merge; "
                   "default: all runs")
        ->type_name("K/N");
    app.add_flag("--merge", options.merge,
                 "take the measures from parts instead of simulating; all else as without; "
                 "default: off");
    app.add_option("--parts", options.parts,
                   "the folder of the parts; default: output/<scene>-<command>.parts")
        ->type_name("DIR");
    app.add_flag("-n,--dry-run", options.dryRun,
                 "print the number of runs; simulate nothing; default: off");
    addFeedback(app, options);
}

void checkRuns(RunsOptions& options, const OptionTexts& texts) {
    checkTime("--time", options.time);
    if (!options.measure.empty() && measureCalled(options.measure) < 0)
        checkName("--measure", options.measure, measureWords());
    if (!texts.shard.empty()) options.shard = shardCalled(texts.shard);
    if (options.shard && options.merge) refuse("--shard and --merge: give one of them");
    spareScenes(options.scenes, {options.plot, options.parts});
    spareOthers(ResultKind::chart, {options.plot});
}

Exit sayRuns(const std::vector<Variant>& variants, const RunsOptions& options) {
    if (options.shard) checkShard(*options.shard, variants.size(), "runs");
    const Talk talk(options, false);
    talk.say(fmt::format("{} of {} s", plural(variants.size(), "run"),
                         numberText(variants.front().scene.seconds)));
    talk.json(fmt::format(R"({{"event":"plan","runs":{}}})", variants.size()));
    return Exit::ok;
}

Exit runPart(const RunsInParts& runs, const std::vector<Variant>& variants,
             const RunsOptions& options) {
    const Shard& shard = *options.shard;
    checkShard(shard, variants.size(), "runs");
    const Talk talk(options, false);
    const std::string name = fmt::format("part {} of {}", shard.number, shard.count);
    if (isDone(runs, shard, options.overwrite)) {
        talk.say(name + " is complete already");
        return Exit::ok;
    }
    std::vector<Summary> measured;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        if (!isIn(shard, i)) continue;
        measured.push_back(summarize(variants[i].scene));
        talk.json(jsonLine({variants[i], measured.back()}));
        if (!runs.histories) measured.back().history.clear();
    }
    writePart(runs, shard, measured);
    talk.say(fmt::format("wrote {} ({}) to {}", name,
                         plural(measured.size(), "run"),
                         printable(runs.folder.string())));
    return Exit::ok;
}

std::vector<Measured> measuredRuns(const RunsInParts& runs, const std::vector<Variant>& variants,
                                   const RunsOptions& options, const Talk& talk) {
    RunsFound found;
    if (options.merge) found = runsFound(runs, variants.size());
    if (!found.review.wanted.empty()) refuseRuns(found.review, runs, options, talk);
    std::vector<Measured> all;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        all.push_back({variants[i], options.merge ? std::move(found.summaries[i])
                                                  : summarize(variants[i].scene)});
        talk.json(jsonLine(all.back()));
    }
    return all;
}

}  // namespace demos
