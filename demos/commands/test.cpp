// impulse test: pictures, states and expectations against their baselines.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "demos/commands/commands.h"
#include "demos/commands/self_test.h"
#include "demos/commands/shared_options.h"
#include "demos/commands/test_report.h"
#include "demos/film/frame_source.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/renderer_name.h"
#include "demos/processes/folder_lock.h"
#include "demos/processes/process_pool.h"
#include "demos/processes/signals.h"
#include "demos/regression/pass_cache.h"
#include "demos/regression/test_parts.h"
#include "demos/regression/verdict_json.h"
#include "demos/text/complaints.h"
#include "demos/text/hex_text.h"
#include "render/driver_environment.h"
#include "render/encode/file.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The verdict on a scene whose process ended early.
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
    explicit Test(const TestOptions& options)
        : options_(options),
          talk_(options, false),
          choice_(chooseScenes(options)),
          results_(options.shard ? folderOfPart(resultsOf(options), *options.shard)
                                 : resultsOf(options)),
          cache_(results_ / "passed.json"),
          run_{options, results_, updateOf(options), {}, nullptr} {
        // What passes within tolerances may still be written again.
        if (options.cache && run_.update != Update::all) run_.cache = &cache_;
        if (options.shard) verdict_.part = keepPart(choice_, options);
        for (const ChosenScene& scene : choice_.scenes)
            checkApart(scene.name, scene.folder, results_);
    }

    Exit play() {
        if (options_.dryRun) return list();
        render::makeFolder(results_);
        const FolderLock lock(results_);
        for (const std::string& note : choice_.notes) talk_.mention(note);
        watchSignals();
        forgetReport();
        run_.renderer = rendererName(options_);
        begin();
        const int count = static_cast<int>(choice_.scenes.size());
        try {
            runInProcesses(
                count, workerCount(options_.jobs, count), [this](int i) { return tested(i); },
                [this](int i, const PoolResult& result) { take(i, result); });
        } catch (const Stop& stop) {
            cache_.write();  // scenes that passed need not run again
            throw Stop(stop.code(), fmt::format("{} scenes; to resume: {}", stop.what(),
                                                options_.commandLine));
        }
        return finish();
    }

private:
    Exit list() const {
        for (const ChosenScene& scene : choice_.scenes) talk_.say(printable(scene.scene));
        talk_.json(fmt::format(R"({{"event":"plan","scenes":{}}})", choice_.scenes.size()));
        return Exit::ok;
    }

    /// A part has a report when it is complete, and not while it runs again.
    void forgetReport() const {
        std::error_code ignored;
        if (options_.shard) fs::remove(results_ / "report.json", ignored);
    }

    void begin() {
        verdict_.baselines = options_.baselines;
        verdict_.renderer = run_.renderer;
        verdict_.pixels = render::pixelClass(options_.reproducible);
        verdict_.command = options_.commandLine;
        verdict_.orphans = choice_.orphans;
        talk_.json(fmt::format(R"({{"event":"start","scenes":{}}})", choice_.scenes.size()));
    }

    /// Runs in the scene's own process.
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
        reportScene(verdict_.scenes.back(), talk_);
    }

    /// The verdict that `tested` sent; a scene that passed goes into the cache, unless a change of it is to be named
    /// again.
    SceneVerdict received(const std::string& text) {
        const Json json = Json::parse(text);
        SceneVerdict verdict = sceneVerdictFrom(json.at("verdict"));
        if (verdict.state == SceneVerdict::State::passed && verdict.changedScene().empty())
            cache_.add(verdict.name, fromHex(json.at("fingerprint").get<std::string>()).value());
        return verdict;
    }

    Exit finish() {
        cache_.write();
        return finishTest(verdict_, options_, results_, talk_);
    }

    const TestOptions& options_;
    Talk talk_;
    SceneChoice choice_;
    fs::path results_;
    PassCache cache_;
    TestSetup run_;
    TestVerdict verdict_;
};

Exit test(const TestOptions& options) { return Test(options).play(); }

void addTestFiles(CLI::App& app, TestOptions& options) {
    app.add_option("--baselines", options.baselines,
                   "the folder of all NAME.snapshots; default: next to each scene file, and "
                   "snapshots/ for built-in scenes")
        ->type_name("DIR");
    app.add_option("-o,--output", options.outputs,
                   "a folder for the report and what was drawn; default: output/test")
        ->type_name("DIR")
        ->expected(1);
    app.add_option("--summary", options.summary,
                   "also write the result with its pictures as Markdown, for the page of a job; "
                   "what $GITHUB_STEP_SUMMARY has already is kept")
        ->type_name("FILE");
}

void addTestKinds(CLI::App& app, TestOptions& options, OptionTexts& texts) {
    app.add_option("--update", options.update,
                   "which baselines to write: missing, changed (and missing), all or none; "
                   "default: missing, or none if CI is set; with none, a missing baseline fails")
        ->type_name("WHICH");
    app.add_flag("--cache,!--no-cache", options.cache,
                 "skip scenes that passed and have not changed since; default: on");
    app.add_flag("--self-test", options.selfTest,
                 "damage every picture on purpose and show what would be detected; default: off");
    app.add_option("--size", texts.size,
                   "pixels, 1..16384 a side; default: the scene's [snapshot] size")
        ->type_name("WxH");
}

void addTestParts(CLI::App& app, TestOptions& options, OptionTexts& texts) {
    app.add_option("--shard", texts.shard,
                   "test every N-th scene from the K-th on, with results in OUTPUT.parts/; "
                   "default: all scenes")
        ->type_name("K/N");
    app.add_flag("--merge", options.merge,
                 "make one report from the parts in OUTPUT.parts/, or in the folders that are "
                 "named instead of scenes; default: off");
    app.add_flag("-n,--dry-run", options.dryRun, "only list the scenes; default: off");
    app.add_option("-j,--jobs", options.jobs, "scenes at a time; default: 0, one per core")
        ->type_name("N");
}

Exit checkAndTest(TestOptions& options, const OptionTexts& texts) {
    if (!options.update.empty())
        checkName("--update", options.update, {"missing", "changed", "all", "none"});
    if (!options.summary.empty() && options.selfTest)
        refuse("--summary: a self-test has no verdict on scenes; leave it out");
    if (!texts.shard.empty()) options.shard = shardCalled(texts.shard);
    if ((options.selfTest || options.merge) && options.shard)
        refuse("--shard is for a test; leave --self-test and --merge out");
    if (options.merge) return mergeTest(options);
    return options.selfTest ? selfTest(options) : test(options);
}

Run addTest(CLI::App& app) {
    const auto asked = std::make_shared<Asked<TestOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    app.get_option("scene")
        ->expected(0, kMostScenes)
        ->required(false)
        ->description(
            "built-in scenes, scene files or folders of them; default: all built-in ones");
    addTestFiles(app, options);
    addTestKinds(app, options, texts);
    addRenderer(app, options);
    addTestParts(app, options, texts);
    addFeedback(app, options);
    return [asked](const std::string& commandLine) {
        return checkAndTest(settled(*asked, commandLine), asked->texts);
    };
}

}  // namespace

Command testCommand() {
    return {"test",
            "check pictures, states and expectations of scenes against their baselines",
            {"impulse test", "impulse test scenes/ --baselines snapshots -o results",
             "impulse test my.toml --self-test"},
            addTest};
}

}  // namespace demos
