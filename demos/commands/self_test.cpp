// impulse test --self-test: shows which damage to the scenes' pictures and states a test detects.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "demos/commands/self_test.h"
#include "demos/film/frame_source.h"
#include "demos/film/progress.h"
#include "demos/processes/process_pool.h"
#include "demos/processes/signals.h"
#include "demos/regression/mutants.h"
#include "demos/regression/scene_test.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

using Json = nlohmann::ordered_json;

/// The results of the process of one scene.
struct Findings {
    std::vector<std::string> lines, objects;  // for people, for programs
    std::string problem;                      // why the scene could not be tested; empty: it was
    int caught = 0, missed = 0;
};

std::string sent(const Findings& f) {
    const Json json{{"lines", f.lines},
                    {"objects", f.objects},
                    {"problem", f.problem},
                    {"caught", f.caught},
                    {"missed", f.missed}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Findings received(const std::string& text) {
    const Json json = Json::parse(text);
    return {json.at("lines"), json.at("objects"), json.at("problem"), json.at("caught"),
            json.at("missed")};
}

std::string objectOf(const std::string& scene, const MutantVerdict& v) {
    return fmt::format(R"({{"event":"mutant","scene":{},"time":{},"mutant":"{}","unchanged":{},)"
                       R"("state":{},"picture":{},"differing":{},"largest":{},"window":{},)"
                       R"("ssim":{:.6f}}})",
                       jsonString(scene), numberText(v.time), v.mutant->name, v.unchanged, v.state,
                       v.picture, v.difference.differing, v.difference.largest,
                       v.difference.worstWindow, v.difference.worstSsim);
}

std::string headOf(const std::string& scene, const FilmPlan& plan) {
    const Snapshot& snapshot = plan.scene().snapshot;
    std::string times;
    for (const double time : snapshot.times)
        times += (times.empty() ? "" : ", ") + numberText(time);
    return fmt::format("{}: {}x{} at {} s; up to {} differing pixels per window and SSIM from {} "
                       "pass",
                       printable(scene), plan.picture.width, plan.picture.height, times,
                       snapshot.gate.windowPixels,
                       numberText(snapshot.gate.ssim));
}

std::string rowOf(const MutantSummary& m) {
    const auto noticed = [&m](int times) {
        return times > 0 ? fmt::format("{} of {}", times, m.times) : "-";
    };
    const std::string end = m.caught()    ? "caught"
                            : m.unchanged ? "changes nothing here"
                                          : fmt::format("MISSED: {}", m.mutant->what);
    return fmt::format("  {:10} {:>8} {:>8} {:>7} {:>7.3f}  {}", m.mutant->name, noticed(m.state),
                       noticed(m.picture), m.window, m.ssim, end);
}

void addTable(const std::string& scene, const FilmPlan& plan,
              const std::vector<MutantVerdict>& verdicts, Findings& findings) {
    findings.lines.push_back(headOf(scene, plan));
    findings.lines.push_back(fmt::format("  {:10} {:>8} {:>8} {:>7} {:>7}", "mutant", "state",
                                         "picture", "window", "SSIM"));
    for (const MutantSummary& summary : summaries(verdicts)) {
        findings.lines.push_back(rowOf(summary));
        findings.caught += summary.caught();
        findings.missed += summary.missed();
    }
    for (const MutantVerdict& verdict : verdicts)
        findings.objects.push_back(objectOf(scene, verdict));
}

Findings findingsOf(const ChosenScene& chosen, const TestOptions& options) noexcept {
    Findings findings;
    try {
        const FilmPlan plan = planOfTest(chosen, options);
        if (plan.scene().snapshot.times.empty()) {
            findings.lines.push_back(printable(chosen.name) +
                                     ": [snapshot] lists no times, so there is nothing to damage");
            return findings;
        }
        render::Renderer renderer(plan.picture);
        addTable(chosen.name, plan, selfTest(plan, renderer), findings);
    } catch (const std::exception& error) {
        findings.problem = error.what();
    }
    return findings;
}

}  // namespace

Exit selfTest(const TestOptions& options) {
    const Talk talk(options, false);
    const SceneChoice choice = chooseScenes(options);
    const int count = static_cast<int>(choice.scenes.size());
    int caught = 0, missed = 0, problems = 0;
    watchSignals();
    runInProcesses(
        count, workerCount(options.jobs, count),
        [&](int i) { return sent(findingsOf(choice.scenes[i], options)); },
        [&](int i, const PoolResult& result) {
            Findings findings;
            findings.problem = "the process that tested it " + result.text;
            if (result.ended) findings = received(result.text);
            for (const std::string& line : findings.lines) talk.say(line);
            for (const std::string& object : findings.objects) talk.json(object);
            caught += findings.caught;
            missed += findings.missed;
            if (findings.problem.empty()) return;
            ++problems;
            talk.complain(fmt::format("impulse: {}: {}", printable(choice.scenes[i].name),
                                      printable(findings.problem)));
        });
    talk.json(fmt::format(R"({{"event":"done","caught":{},"missed":{},"problems":{}}})", caught,
                          missed, problems));
    const std::string end = fmt::format("{} of {} mutants caught", caught, caught + missed);
    if (missed == 0) talk.say(end);
    if (missed > 0) talk.complain("impulse: " + end);
    return caught > 0 && missed == 0 && problems == 0 ? Exit::ok : Exit::failed;
}

}  // namespace demos
