// impulse test: pictures, states and expectations against their baselines.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "demos/commands/commands.h"
#include "demos/film/folder_lock.h"
#include "demos/film/frame_source.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/signals.h"
#include "demos/hex_text.h"
#include "demos/regression/baseline.h"
#include "demos/regression/pass_cache.h"
#include "demos/regression/process_pool.h"
#include "demos/regression/renderer_name.h"
#include "demos/regression/report_files.h"
#include "demos/regression/scene_test.h"
#include "demos/regression/tell.h"
#include "demos/regression/verdict_json.h"
#include "demos/scene/complaints.h"
#include "render/driver_environment.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The results may not take the place of the baselines: a test clears what it left before.
void checkApart(const SceneChoice& choice, const fs::path& results) {
    std::error_code ignored;
    for (const ChosenScene& scene : choice.scenes) {
        const fs::path shown = results / (scene.name + kSnapshotsEnding);
        if (fs::weakly_canonical(fs::absolute(shown), ignored) ==
            fs::weakly_canonical(fs::absolute(scene.folder), ignored))
            throw Stop(Exit::usage,
                       fmt::format("--output '{}' is where the baselines are; name another folder",
                                   printable(results.string())));
    }
}

/// Of a process that did not come to its end.
SceneVerdict crashed(const ChosenScene& scene, const std::string& how) {
    SceneVerdict verdict;
    verdict.name = scene.name;
    verdict.scene = scene.scene;
    verdict.folder = scene.folder.string();
    verdict.state = SceneVerdict::State::error;
    verdict.problem = "the process that tested it " + how;
    return verdict;
}

class Test {
public:
    explicit Test(const Options& options)
        : options_(options),
          talk_(options, false),
          choice_(chooseScenes(options)),
          results_(options.outputs.empty() ? "output/test" : options.outputs.front()),
          cache_(results_ / "passed.json"),
          run_{options, results_, updateOf(options), {}, options.cache ? &cache_ : nullptr} {
        checkApart(choice_, results_);
    }

    Exit play() {
        makeFolder(results_);
        const FolderLock lock(results_);
        for (const std::string& note : choice_.notes) talk_.mention(note);
        watchSignals();
        run_.renderer = rendererName(options_);
        begin();
        const int count = static_cast<int>(choice_.scenes.size());
        try {
            runInProcesses(
                count, workerCount(options_.jobs, count), [this](int i) { return tested(i); },
                [this](int i, const PoolResult& result) { take(i, result); });
        } catch (const Stop& stop) {
            cache_.write();  // what has passed need not be played again
            throw Stop(stop.code(), fmt::format("{} scenes; to go on: {}", stop.what(),
                                                options_.commandLine));
        }
        return finish();
    }

private:
    void begin() {
        verdict_.baselines = options_.baselines;
        verdict_.renderer = run_.renderer;
        verdict_.pixels = render::pixelClass(options_.reproducible);
        verdict_.command = options_.commandLine;
        verdict_.orphans = choice_.orphans;
        talk_.json(fmt::format(R"({{"event":"start","scenes":{}}})", choice_.scenes.size()));
    }

    /// In the scene's own process.
    std::string tested(int i) const {
        const SceneTested tested = testScene(choice_.scenes[i], run_);
        const Json json{{"verdict", jsonOf(tested.verdict)},
                        {"fingerprint", hexText(tested.fingerprint)}};
        return json.dump(-1, ' ', false, Json::error_handler_t::replace);
    }

    void take(int i, const PoolResult& result) {
        const ChosenScene& scene = choice_.scenes[i];
        cache_.remove(scene.name);
        verdict_.scenes.push_back(result.ended ? received(result.text)
                                               : crashed(scene, result.text));
        tell(verdict_.scenes.back());
    }

    /// What `tested` has sent; one that passed is known from now on.
    SceneVerdict received(const std::string& text) {
        const Json json = Json::parse(text);
        SceneVerdict verdict = sceneVerdictFrom(json.at("verdict"));
        if (verdict.state == SceneVerdict::State::passed)
            cache_.add(verdict.name, fromHex(json.at("fingerprint").get<std::string>()).value());
        return verdict;
    }

    /// What failed is told with --quiet too, and where errors go.
    void tell(const SceneVerdict& scene) const {
        Json event = jsonOf(scene);
        event["event"] = "scene";
        talk_.json(event.dump(-1, ' ', false, Json::error_handler_t::replace));
        const bool bad = scene.state == SceneVerdict::State::failed ||
                         scene.state == SceneVerdict::State::error;
        if (!bad) talk_.say(headline(scene));
        if (bad) talk_.complain(headline(scene));
        for (const std::string& line : detailsOf(scene)) {
            if (!bad) talk_.say("         " + line);
            if (bad) talk_.complain("         " + line);
        }
        std::fflush(stdout);
    }

    Exit finish() {
        cache_.write();
        writeReport(verdict_, options_, results_);
        const std::string page = (results_ / "report.html").string();
        for (const std::string& orphan : verdict_.orphans)
            talk_.say(fmt::format("{} is of no scene; impulse approve --prune removes it",
                                  printable(orphan)));
        talk_.say(summaryOf(verdict_));
        talk_.say("wrote " + printable(page) + ", report.json, junit.xml");
        talk_.say(nextStep(page));
        talk_.json(fmt::format(R"({{"event":"done","passed":{},"report":{}}})", verdict_.passed(),
                               jsonString(page)));
        return verdict_.passed() ? Exit::ok : Exit::failed;
    }

    std::string nextStep(const std::string& page) const {
        if (!verdict_.passed()) return "next: look at " + printable(page);
        if (verdict_.count(SceneVerdict::State::added) > 0)
            return "next: look at the new pictures, and commit them with their baseline.json";
        return "next: impulse test --self-test tells which damage this would notice";
    }

    const Options& options_;
    Talk talk_;
    SceneChoice choice_;
    fs::path results_;
    PassCache cache_;
    TestRun run_;
    TestVerdict verdict_;
};

}  // namespace

Exit testCommand(const Options& options) { return Test(options).play(); }

}  // namespace demos
