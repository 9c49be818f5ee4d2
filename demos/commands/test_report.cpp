#include "demos/commands/test_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "demos/regression/baseline.h"
#include "demos/regression/markdown_summary.h"
#include "demos/regression/report_files.h"
#include "demos/regression/verdict_json.h"
#include "demos/regression/verdict_text.h"
#include "demos/text/complaints.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::string nextStep(const TestVerdict& verdict, const std::string& page) {
    if (!verdict.passed()) return "next: look at " + printable(page);
    if (verdict.count(SceneVerdict::State::added) > 0)
        return "next: look at the new pictures, and commit them with their baseline.json";
    if (verdict.part)
        return fmt::format("next, when all {} parts are there: impulse test --merge",
                           verdict.part->shard.count);
    return "next: impulse test --self-test shows which damage a test would detect";
}

}  // namespace

fs::path resultsOf(const TestOptions& options) {
    return options.outputs.empty() ? "output/test" : options.outputs.front();
}

void checkApart(const std::string& name, const fs::path& folder, const fs::path& results) {
    std::error_code ignored;
    const fs::path shown = results / (name + kSnapshotsEnding);
    if (fs::weakly_canonical(fs::absolute(shown), ignored) ==
        fs::weakly_canonical(fs::absolute(folder), ignored))
        throw Stop(Exit::usage,
                   fmt::format("--output '{}' is where the baselines are; name another folder",
                               printable(results.string())));
}

void reportScene(const SceneVerdict& scene, const Talk& talk) {
    nlohmann::ordered_json event = jsonOf(scene);
    event["event"] = "scene";
    talk.json(event.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    const bool bad = scene.state == SceneVerdict::State::failed ||
                     scene.state == SceneVerdict::State::error;
    if (!bad) talk.say(headline(scene));
    if (bad) talk.complain(headline(scene));
    for (const std::string& line : detailsOf(scene)) {
        if (!bad) talk.say("         " + line);
        if (bad) talk.complain("         " + line);
    }
    std::fflush(stdout);
}

Exit finishTest(const TestVerdict& verdict, const TestOptions& options, const fs::path& results,
                const Talk& talk) {
    writeReport(verdict, options, results);
    if (!options.summary.empty())
        writeSummary(options.summary, markdownSummary(verdict, pictureLinks(options.summary)));
    const std::string page = (results / "report.html").string();
    for (const std::string& orphan : verdict.orphans)
        talk.say(fmt::format("{} belongs to no scene; impulse approve --prune removes it",
                             printable(orphan)));
    talk.say(summaryOf(verdict));
    talk.say("wrote " + printable(page) + ", report.json, junit.xml" +
             (options.summary.empty() ? "" : " and " + printable(options.summary)));
    talk.say(nextStep(verdict, page));
    talk.json(fmt::format(R"({{"event":"done","passed":{},"report":{}}})", verdict.passed(),
                          jsonString(page)));
    return verdict.passed() ? Exit::ok : Exit::failed;
}

}  // namespace demos
