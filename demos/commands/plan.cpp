// impulse plan: what a film in parts on several machines would take.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/film_needs.h"
#include "demos/film/film_timing.h"
#include "demos/film/frame_source.h"
#include "demos/film/part_forecast.h"
#include "demos/film/progress.h"
#include "demos/film/simulator.h"
#include "demos/measures/clock.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/shell_word.h"

namespace demos {
namespace {

constexpr int kMeasuredFrames = 30;
constexpr double kMeasuredSeconds = 5.0;  // of processor time

struct PlanOptions : Options {
    int shards = 16;
};

/// The forecast and what it is made from.
struct Plan {
    FilmPlan film;
    PartForecast parts;
    FilmNeeds needs;  // of one machine
    int measured = 0;  // number of frames
};

Plan measuredPlan(const PlanOptions& options) {
    const double before = processorTime();
    Plan plan{planPictures(options), {}, {}, 0};
    PartForecast& parts = plan.parts;
    parts.start = processorTime() - before;
    parts.frames = plan.film.frames;
    parts.shards = options.shards;
    if (parts.shards > parts.frames)
        refuse(fmt::format("--shards {}: the film has {} frames; make fewer parts", parts.shards,
                           parts.frames));
    parts.workers = workerCount(options.jobs, (parts.frames + parts.shards - 1) / parts.shards);
    parts.simulating = canDrawFromStates(plan.film) ? 1 : parts.workers;
    plan.needs = needsOf(plan.film, parts.workers, {});
    checkNeeds(plan.needs, plan.film);
    const FilmTiming timing = timeFrames(plan.film, kMeasuredFrames, kMeasuredSeconds);
    plan.measured = timing.frames;
    parts.begin = timing.start;
    parts.simulate = 1e-3 * timing.ms.front();
    for (std::size_t i = 1; i < timing.ms.size(); ++i) parts.draw += 1e-3 * timing.ms[i];
    return plan;
}

std::string planJson(const Plan& plan) {
    const PartForecast& parts = plan.parts;
    return fmt::format(
        R"({{"event":"plan","scene":{},"frames":{},"width":{},"height":{},"measured_frames":{},)"
        R"("shards":{},"workers":{},"memory":{:.0f},"start_s":{:.6g},"begin_s":{:.6g},)"
        R"("simulate_ms":{:.6g},"draw_ms":{:.6g},"simulation_share":{:.6g},)"
        R"("alone_s":{:.6g},"in_parts_s":{:.6g},)"
        R"("speed_up":{:.6g},"processor_ratio":{:.6g},"shards_that_pay":{}}})",
        jsonString(plan.film.name), parts.frames, plan.film.layout.width, plan.film.layout.height,
        plan.measured, parts.shards, parts.workers, plan.needs.memory(), parts.start,
        parts.begin, 1e3 * parts.simulate, 1e3 * parts.draw, parts.simulationShare(), parts.alone(),
        parts.inParts(), parts.speedUp(), parts.processorRatio(), parts.partsThatPay());
}

void sayForecast(const Plan& plan, const PlanOptions& options, const Talk& talk) {
    const PartForecast& parts = plan.parts;
    talk.say(fmt::format("{}: {} frames of {}x{}, predicted from the first {}",
                         printable(plan.film.name), parts.frames, plan.film.layout.width,
                         plan.film.layout.height, plan.measured));
    talk.say(fmt::format("a frame: {:.3g} ms to simulate, {:.3g} ms to draw; the simulation is "
                         "{:.0f} %",
                         1e3 * parts.simulate, 1e3 * parts.draw, 100 * parts.simulationShare()));
    talk.say(fmt::format("one machine, {}, {:.0f} MB: {:.3g} s",
                         plural(static_cast<std::size_t>(parts.workers), "process", "processes"),
                         1e-6 * plan.needs.memory(), parts.alone()));
    talk.say(fmt::format("{} machines like this: {:.3g} s, {:.2g} times as fast with {:.3g} times "
                         "the processor time; every part simulates from the start",
                         parts.shards, parts.inParts(), parts.speedUp(), parts.processorRatio()));
    const int pay = parts.partsThatPay();
    talk.say(fmt::format("up to {} parts are worthwhile: with more, a machine does less than half of what "
                         "one does alone",
                         pay));
    talk.say(fmt::format("next: impulse farm slurm {} --shards {}",
                         printable(shellWord(options.scene())), std::min(pay, parts.shards)));
}

Exit predict(const PlanOptions& options) {
    checkRange("--shards", options.shards, 1, kMostShards);
    watchSignals();
    const Plan plan = measuredPlan(options);
    const Talk talk(options, false);
    talk.json(planJson(plan));
    sayForecast(plan, options, talk);
    return Exit::ok;
}

Run addPlan(CLI::App& app) {
    const auto asked = std::make_shared<Asked<PlanOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    app.add_option("--shards", options.shards,
                   "number of parts, each on a machine like this one; default: 16")
        ->type_name("N");
    addSeconds(app, options);
    addPicture(app, options, texts);
    addJobs(app, options);
    addFeedback(app, options);
    return
        [asked](const std::string& commandLine) { return predict(settled(*asked, commandLine)); };
}

}  // namespace

Command planCommand() {
    return {"plan",
            "predict what a film in parts takes: time, memory, how many parts are worthwhile",
            {"impulse plan wall --shards 16", "impulse plan galton --shards 4 -q high --json",
             "impulse plan wall --shards 8 -j 1"},
            addPlan};
}

}  // namespace demos
