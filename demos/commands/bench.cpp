#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <map>
#include <nlohmann/json.hpp>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/film_plan.h"
#include "demos/film/film_timing.h"
#include "demos/film/progress.h"
#include "demos/film/state_files.h"
#include "demos/load/builtin.h"
#include "demos/measures/timing.h"
#include "demos/processes/signals.h"
#include "demos/scene/reader.h"
#include "demos/text/json_limits.h"
#include "demos/text/complaints.h"
#include "demos/text/hex_text.h"
#include "demos/text/shell_word.h"
#include "render/error.h"

namespace demos {
namespace {

struct BenchOptions : Options {
    bool film = false;    // time drawing instead of steps
    bool phases = false;  // and every phase of the loop
    std::string against;  // an earlier run's JSON lines
    std::string from;     // a state to continue from; empty: from time 0
};

/// One scene of an earlier run.
struct Earlier {
    double ms = 0.0;
    std::string hash;
};
using EarlierRun = std::map<std::string, Earlier>;

std::string earlierText(const std::string& path) try {
    return readSceneFile(path, "what 'impulse bench --json' has written", kBenchJson.bytes);
} catch (const SceneError& error) {
    throw render::Error(fmt::format("--against {}", error.what()));
}

/// Reads what `impulse bench --json > FILE` wrote.
EarlierRun readEarlier(const std::string& path) {
    std::istringstream file(earlierText(path));
    EarlierRun run;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        const nlohmann::json object = jsonTrouble(line, kBenchJson).empty()
                                          ? nlohmann::json::parse(line, nullptr, false)
                                          : nullptr;
        const bool good = object.is_object() && object.contains("scene") &&
                          object["scene"].is_string() && object.contains("ms_per_step_median") &&
                          object["ms_per_step_median"].is_number() &&
                          object["ms_per_step_median"] > 0.0 && object.contains("hash") &&
                          object["hash"].is_string();
        if (!good)
            throw Stop(Exit::usage,
                       fmt::format("--against {}:{}: is not a line of 'impulse bench --json'",
                                   printable(path), number));
        run[object["scene"]] = {object["ms_per_step_median"], object["hash"]};
    }
    return run;
}

void sayTimingJson(const Timing& t, const PhaseTimes* phases, const Earlier* before) {
    const auto [least, most] = std::minmax_element(t.ms.begin(), t.ms.end());
    fmt::print(R"({{"scene":{},"bodies":{},"joints":{},"contacts":{},"steps":{},)"
               R"("ms_per_step_median":{:.6g},"ms_per_step_min":{:.6g},"ms_per_step_max":{:.6g},)"
               R"("ns_per_point":{:.6g},"hash":"{}")",
               jsonString(t.scene), t.bodies, t.joints, t.contacts, t.steps, t.median(), *least,
               *most, t.nanosecondsAPoint(), hexText(t.hash));
    if (phases)
        for (std::size_t i = 0; i < phases->size(); ++i)
            fmt::print(R"(,"ms_{}":{:.6g})", kPhaseNames[i], (*phases)[i]);
    if (before)
        fmt::print(R"(,"ratio":{:.6g},"same_hash":{})", t.median() / before->ms,
                   before->hash == hexText(t.hash));
    fmt::print("}}\n");
    std::fflush(stdout);
}

void sayRow(const Timing& t, const PhaseTimes* phases, const Earlier* before) {
    const auto [least, most] = std::minmax_element(t.ms.begin(), t.ms.end());
    fmt::print("{:18} {:6} {:6} {:8}  {:8.3f} {:8.3f} {:8.3f}  {:8.0f}  {}", t.scene, t.bodies,
               t.joints, t.contacts, t.median(), *least, *most, t.nanosecondsAPoint(),
               hexText(t.hash));
    if (before)
        fmt::print("  {:.2f} x {}", t.median() / before->ms,
                   before->hash == hexText(t.hash) ? "before, same state"
                                                   : "before, different state");
    fmt::print("\n");
    if (phases) {
        fmt::print("{:18}", "");
        for (std::size_t i = 0; i < phases->size(); ++i)
            fmt::print(" {} {:.3f}", kPhaseNames[i], (*phases)[i]);
        fmt::print("\n");
    }
    std::fflush(stdout);
}

/// Returns the run's incident, if any.
std::string benchScene(const SceneDescription& scene, const EarlierRun& earlier,
                const BenchOptions& options) {
    const auto begin = [&](Player& player) {
        if (!options.from.empty())
            goOnFrom(options.from, stateKindOf(scene, options), Overlays{}, player);
    };
    const Timing timing = timeScene(scene, begin);
    if (timing.ms.empty())
        refuse(fmt::format("--from {}: is a state of the scene's end; --seconds makes it longer",
                           printable(options.from)));
    PhaseTimes phases{};
    if (options.phases) phases = timePhases(scene, begin);
    const auto found = earlier.find(scene.name);
    const Earlier* before = found == earlier.end() ? nullptr : &found->second;
    const auto say = options.json ? sayTimingJson : sayRow;
    say(timing, options.phases ? &phases : nullptr, before);
    return timing.incident;
}

void sayFilmJson(const FilmPlan& plan, const FilmTiming& t) {
    fmt::print(R"({{"scene":{},"quality":"{}","width":{},"height":{},"samples":{},"moments":{},)"
               R"("bodies":{},"frames":{},"workers":{},"frames_per_second":{:.6g},"goal":{:.6g},)"
               R"("png_bytes":{:.0f},"drawn_share":{:.4g})",
               jsonString(plan.name), plan.quality, plan.layout.width, plan.layout.height,
               plan.picture.samples, plan.shutter.moments, plan.scene().bodies.size(), t.frames,
               t.workers, t.framesASecond, t.goal(), t.pngBytes, t.drawn);
    for (std::size_t i = 0; i < t.ms.size(); ++i)
        fmt::print(R"(,"ms_{}":{:.6g})", kFilmStages[i], t.ms[i]);
    if (t.mp4)
        fmt::print(R"(,"mp4_ms":{:.6g},"mp4_ms_workers":{:.6g},"mp4_ms_program":{:.6g},)"
                   R"("mp4_ms_encoder":{:.6g},"mp4_bytes":{:.0f},"mp4_frames_per_second":{:.6g})",
                   t.mp4->all(), t.mp4->workers, t.mp4->program, t.mp4->encoder, t.mp4->bytes,
                   t.mp4->framesASecond);
    fmt::print("}}\n");
}

void sayFilm(const FilmPlan& plan, const FilmTiming& t) {
    fmt::print("{:18} {:6}", plan.name, plan.scene().bodies.size());
    for (const double ms : t.ms) fmt::print(" {:9.2f}", ms);
    fmt::print(" {:8.1f} {:6.1f} {:6.0f} {:9.1f} {:8.2f}\n", t.drawing(), 100.0 * t.drawn,
               1e-3 * t.pngBytes, t.framesASecond, t.framesASecond / t.goal());
    if (t.mp4)
        fmt::print("{:18} all {:.2f} = workers {:.2f} + program {:.2f} + encoder {:.2f}; {:.1f} "
                   "kB, {:.1f} frames/s\n",
                   "  as an .mp4", t.mp4->all(), t.mp4->workers, t.mp4->program, t.mp4->encoder,
                   1e-3 * t.mp4->bytes, t.mp4->framesASecond);
}

void sayFilmHeader() {
    fmt::print("{:18} {:>6}", "ms a frame", "bodies");
    for (const char* name : kFilmStages) fmt::print(" {:>9}", name);
    fmt::print(" {:>8} {:>6} {:>6} {:>9} {:>8}\n", "drawing", "drawn%", "kB",
               "frames/s", "of goal");
}

std::string benchFilm(const BenchOptions& options) {
    const FilmPlan plan = planPictures(options);
    const FilmTiming timing = timeFilm(plan, options.jobs);
    (options.json ? sayFilmJson : sayFilm)(plan, timing);
    std::fflush(stdout);
    return timing.incident;
}

Exit bench(const BenchOptions& options) {
    std::vector<std::string> scenes = options.scenes;
    if (scenes.empty())
        for (const BuiltinScene& scene : builtinScenes()) scenes.emplace_back(scene.name);
    EarlierRun earlier;
    if (!options.against.empty()) earlier = readEarlier(options.against);
    watchSignals();
    if (options.film && !options.json && !options.quiet) sayFilmHeader();
    if (!options.film && !options.json && !options.quiet)
        fmt::print("{:18} {:>6} {:>6} {:>8}  {:>8} {:>8} {:>8}  {:>8}  {}\n", "scene", "bodies",
                   "joints", "contacts", "ms/step", "min", "max", "ns/point", "state");
    const Talk talk(options, false);
    Exit code = Exit::ok;
    for (const std::string& name : scenes) {
        BenchOptions one = options;
        one.scenes = {name};
        const std::string incident =
            options.film ? benchFilm(one) : benchScene(sceneOf(one), earlier, options);
        if (incident.empty()) continue;
        talk.complain("impulse: " + printable(incident));
        code = Exit::diverged;
    }
    talk.say(fmt::format("next: impulse bench {} --json", printable(shellWord(scenes.front()))));
    return code;
}

Run addBench(CLI::App& app) {
    const auto asked = std::make_shared<Asked<BenchOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    app.get_option("scene")->expected(0, kMostScenes)->required(false);
    addSeconds(app, options);
    app.add_flag("--film", options.film,
                 "measure processor time of every stage of a frame, of all processes of an .mp4, "
                 "the share of the pictures that is drawn and not kept, and frames/s, for the film "
                 "that the options below describe; default: off");
    addPicture(app, options, texts);
    addWholeFrames(app, options);
    addJobs(app, options);
    app.add_flag("--phases", options.phases,
                 "print the ms of every phase of the step, from a second run; default: off");
    app.add_option("--against", options.against,
                   "compare with the output of an earlier 'impulse bench --json'; default: none")
        ->type_name("FILE");
    app.add_option("--from", options.from,
                   "continue from a state that 'impulse sim --states' has written, with one scene and "
                   "without --film; default: from time 0")
        ->type_name("FILE");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        const BenchOptions& given = settled(*asked, commandLine);
        if (!given.from.empty() && (given.scenes.size() != 1 || given.film))
            refuse("--from belongs to one scene, without --film; name the scene of the state");
        return bench(given);
    };
}

}  // namespace

Command benchCommand() {
    return {
        "bench",
        "time per step over the last 2 s of a scene, or per frame of its film",
        {"impulse bench stack chain --json", "impulse bench wall --phases --against before.json",
         "impulse bench wall --film -q film"},
        addBench};
}

}  // namespace demos
