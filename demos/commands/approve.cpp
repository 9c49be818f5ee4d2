// impulse approve: makes the results of the last test the new baselines.

#include <fmt/format.h>

#include <algorithm>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/progress.h"
#include "demos/load/load_scene.h"
#include "demos/processes/folder_lock.h"
#include "demos/regression/accept.h"
#include "demos/regression/approved_places.h"
#include "demos/regression/baseline.h"
#include "demos/regression/verdict_json.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/json_limits.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

struct ApproveOptions : Options {
    std::string results = "output/test";  // folder of the test's report
    std::string baselines;                // a folder; empty = next to the scenes
    bool all = false, prune = false;
};

namespace fs = std::filesystem;

/// What one name on the command line asks to accept.
struct Wish {
    enum class What { all, physics, picture };
    const SceneVerdict* scene = nullptr;
    What what = What::all;
    double time = 0.0;  // s
};

TestVerdict reportIn(const fs::path& results) {
    const fs::path file = results / "report.json";
    const std::vector<std::uint8_t> bytes = contentOf(file, kReportJson.bytes);
    std::error_code ignored;
    if (bytes.empty() && fs::exists(fs::symlink_status(file, ignored)))
        throw Stop(Exit::environment,
                   fmt::format("'{}' is empty, above 64 MiB or no regular file; run impulse test again",
                               printable(file.string())));
    if (bytes.empty())
        throw Stop(Exit::environment,
                   fmt::format("there is no '{}'; run impulse test first, or name its folder with "
                               "--results",
                               printable(file.string())));
    return testVerdictFrom({bytes.begin(), bytes.end()}, file.string());
}

/// Failed, or passed with changed values.
bool differs(const SceneVerdict& scene) {
    const bool changed = scene.state == SceneVerdict::State::passed && !scene.changedScene().empty();
    return (changed || scene.state == SceneVerdict::State::failed) && !scene.pictures.empty() &&
           std::any_of(scene.pictures.begin(), scene.pictures.end(),
                       [](const PictureVerdict& picture) { return !picture.actual.empty(); });
}

const char* whatBecameOf(const SceneVerdict& scene) {
    switch (scene.state) {
        case SceneVerdict::State::passed:
            return "passed";
        case SceneVerdict::State::added:
            return "was new, and its baseline was written";
        case SceneVerdict::State::updated:
            return "was updated";
        default:
            return "could not be tested";
    }
}

void checkContract(const SceneVerdict& scene) {
    for (const ExpectationResult& result : scene.expectations)
        if (!result.passed)
            throw Stop(Exit::failed,
                       fmt::format("{}: the expectation '{}' failed, which no baseline can fix; "
                                   "fix the scene or its [[expect]], and test again",
                                   printable(scene.name), printable(result.text)));
}

class Approval {
public:
    explicit Approval(const ApproveOptions& options)
        : options_(options), talk_(options, false), results_(options.results) {}

    Exit run() {
        if (options_.scenes.empty() && !options_.all && !options_.prune)
            throw Stop(Exit::usage,
                       "approve what? name scenes or pictures (stack, stack@2.5), or "
                       "give --all or --prune");
        verdict_ = reportIn(results_);
        places_ = approvedPlaces(verdict_, options_.baselines);
        const FolderLock lock(results_);
        for (const Wish& wish : wishes()) accept(wish);
        if (options_.prune) prune();
        talk_.json(
            fmt::format(R"({{"event":"done","accepted":{},"pruned":{}}})", accepted_, pruned_));
        // The report's own command may come from elsewhere, and be anything.
        talk_.say(fmt::format("accepted {}, removed {}; next: impulse test, as the last time",
                              accepted_, pruned_));
        return Exit::ok;
    }

private:
    /// Resolves all names before anything is written.
    std::vector<Wish> wishes() const {
        std::vector<Wish> wishes;
        for (const std::string& name : options_.scenes) wishes.push_back(wishOf(name));
        if (options_.all)
            for (const SceneVerdict& scene : verdict_.scenes)
                if (differs(scene)) wishes.push_back({&scene, Wish::What::all, 0.0});
        for (const Wish& wish : wishes) checkContract(*wish.scene);
        return wishes;
    }

    Wish wishOf(const std::string& name) const {
        const std::size_t at = name.rfind('@');
        const SceneVerdict& scene = sceneCalled(name.substr(0, at), name);
        if (at == std::string::npos) return {&scene, Wish::What::all, 0.0};
        if (name.substr(at + 1) == "physics") return {&scene, Wish::What::physics, 0.0};
        for (const PictureVerdict& picture : scene.pictures)
            if (pictureName(scene.name, picture.time) == name)
                return {&scene, Wish::What::picture, picture.time};
        std::vector<std::string> names{scene.name + "@physics"};
        for (const PictureVerdict& picture : scene.pictures)
            names.push_back(pictureName(scene.name, picture.time));
        throw Stop(Exit::usage, fmt::format("the last test has no '{}'{}", printable(name),
                                            suggestion(name, names)));
    }

    const SceneVerdict& sceneCalled(const std::string& scene, const std::string& name) const {
        std::vector<std::string> names;
        for (const SceneVerdict& known : verdict_.scenes) {
            if (known.name == scene && !differs(known))
                throw Stop(Exit::usage,
                           fmt::format("'{}' has nothing to accept: in the last test it {}",
                                       printable(name), whatBecameOf(known)));
            if (known.name == scene) return known;
            names.push_back(known.name);
        }
        throw Stop(Exit::usage, fmt::format("the last test has no '{}'{}", printable(name),
                                            suggestion(scene, names)));
    }

    void accept(const Wish& wish) try {
        const fs::path shown = results_ / (wish.scene->name + kSnapshotsEnding);
        const fs::path& folder = placeOf(*wish.scene);
        if (wish.what == Wish::What::all) acceptAll(shown, folder);
        if (wish.what == Wish::What::physics) acceptPhysics(shown, folder);
        if (wish.what == Wish::What::picture) acceptPicture(shown, folder, wish.time);
        ++accepted_;
        const std::string what = wish.what == Wish::What::all       ? "all"
                                 : wish.what == Wish::What::physics ? "physics"
                                                                    : pictureFile(wish.time);
        talk_.say(fmt::format("accepted {} ({}) in {}", printable(wish.scene->name), what,
                              printable(folder.string())));
    } catch (const BaselineError& error) {
        throw Stop(Exit::environment, error.what());
    }

    const fs::path& placeOf(const SceneVerdict& scene) const {
        return places_.scenes[static_cast<std::size_t>(&scene - verdict_.scenes.data())];
    }

    void prune() {
        for (const SceneVerdict& scene : verdict_.scenes)
            if (!scene.orphans.empty()) prunePictures(placeOf(scene), scene);
        for (const fs::path& orphan : places_.orphans) pruneFolder(orphan);
    }

    /// Removes pictures only, only from a folder of baselines, and none of a time that the scene lists, whatever
    /// the report says.
    void prunePictures(const fs::path& folder, const SceneVerdict& scene) {
        if (fs::is_symlink(folder) || !fs::exists(folder / kBaselineFile)) return;
        const std::vector<double> times = loadScene(scene.scene).snapshot.times;
        for (const std::string& picture : orphansOf(folder, times))
            if (std::ranges::count(scene.orphans, picture)) remove(folder / picture);
    }

    /// Removes a baseline's files only; the folder stays if it holds other files.
    void pruneFolder(const fs::path& folder) {
        if (fs::is_symlink(folder) || !fs::exists(folder / kBaselineFile)) return;
        for (const std::string& picture : orphansOf(folder, {})) remove(folder / picture);
        remove(folder / kBaselineFile);
        std::error_code ignored;
        fs::remove(folder, ignored);
    }

    void remove(const fs::path& file) {
        std::error_code problem;
        if (!fs::remove(file, problem)) return;
        ++pruned_;
        talk_.say("removed " + printable(file.string()));
    }

    const ApproveOptions& options_;
    Talk talk_;
    fs::path results_;
    TestVerdict verdict_;
    ApprovedPlaces places_;
    int accepted_ = 0, pruned_ = 0;
};

Exit approve(const ApproveOptions& options) { return Approval(options).run(); }

Run addApprove(CLI::App& app) {
    const auto asked = std::make_shared<Asked<ApproveOptions>>();
    auto& options = asked->options;
    app.add_option("name", options.scenes,
                   "a scene, one picture (NAME@TIME) or its physics (NAME@physics)")
        ->type_name("NAME")
        ->expected(0, kMostScenes);
    app.add_flag("--all", options.all,
                 "accept everything that differed in the last test; default: off");
    app.add_flag("--prune", options.prune,
                 "remove baselines that no scene uses any more; default: off");
    app.add_option("--results", options.results,
                   "the folder that impulse test wrote; default: output/test")
        ->type_name("DIR");
    app.add_option("--baselines", options.baselines,
                   "the folder of all NAME.snapshots, as impulse test had it; default: next to "
                   "each scene file in this folder, and snapshots/ for built-in scenes")
        ->type_name("DIR");
    addFeedback(app, options);
    return
        [asked](const std::string& commandLine) { return approve(settled(*asked, commandLine)); };
}

}  // namespace

Command approveCommand() {
    return {"approve",
            "accept what a test drew as the new baseline",
            {"impulse approve stack@2.5 wall", "impulse approve --all", "impulse approve --prune"},
            addApprove};
}

}  // namespace demos
