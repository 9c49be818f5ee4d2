#include "demos/slides/read_runs.h"
#include "demos/load/load_scene.h"
#include "demos/slides/loaded_runs.h"

#include "demos/comparisons/comparing.h"
#include "demos/comparisons/comparisons.h"
#include "demos/comparisons/sweeping.h"
#include "demos/load/builtin.h"
#include "demos/scene/reader.h"
#include "demos/text/nearest.h"
#include "demos/text/stop.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const BuiltinScene& scene : builtinScenes()) names.emplace_back(scene.name);
    return names;
}

std::vector<std::string> comparisonNames() {
    std::vector<std::string> names;
    for (const Comparison& comparison : builtinComparisons()) names.emplace_back(comparison.name);
    return names;
}

class RunsReader {
public:
    RunsReader(Keys& keys, const fs::path& folder) : keys_(keys), folder_(folder) {}

    ReadRuns read() {
        readNames();
        readVariants();
        if (good_ && read_.runs.any() && readsAlone()) readAll();
        if (!good_) read_.scenes.clear();
        return std::move(read_);
    }

private:
    void complain(std::string_view key, const std::string& what) {
        keys_.complain(key, what);
        good_ = false;
    }

    /// Complains at the value; in a list, at the item that the message quotes.
    void complainOf(const char* key, const std::string& what) {
        const std::vector<std::string> texts =
            keys_.texts(key).value_or(std::vector<std::string>());
        std::size_t item = 0;
        while (item < texts.size() && what.find(texts[item]) == std::string::npos) ++item;
        keys_.complainOf(key, what, item);
        good_ = false;
    }

    void readNames() {
        SlideRuns& runs = read_.runs;
        if (const auto name = keys_.text("scene")) runs.scene = sceneCalled(*name);
        if (const auto name = keys_.text("compare")) runs.comparison = *name;
        if (keys_.has("scene") && runs.scene.empty()) good_ = false;
        if (keys_.has("compare") && !comparisonCalled(runs.comparison))
            complainOf("compare", "no comparison is called '" + shown(runs.comparison) + "'" +
                                      suggestion(runs.comparison, comparisonNames()));
        for (const char* key : {"scene", "vary", "case", "over"})
            if (keys_.has("compare") && keys_.has(key))
                complain(key, "a comparison has its own scene and cases; leave out " +
                                  std::string(key) + ", or compare");
    }

    /// The name as loadScene() takes it; empty, with a complaint, if it cannot be a scene.
    std::string sceneCalled(const std::string& name) {
        if (isBuiltin(name)) return name;
        const bool isPath = name.find('/') != std::string::npos || fs::path(name).has_extension();
        if (isPath && name.find('\0') == std::string::npos) return (folder_ / name).string();
        complainOf("scene", "there is no built-in scene '" + shown(name) + "'" +
                                suggestion(name, sceneNames()));
        return {};
    }

    void readVariants() {
        SlideRuns& runs = read_.runs;
        runs.settings = keys_.texts("set").value_or(runs.settings);
        runs.vary = keys_.texts("vary").value_or(runs.vary);
        runs.cases = keys_.texts("case").value_or(runs.cases);
        runs.over = keys_.text("over").value_or("");
        if (keys_.has("over") && (keys_.has("vary") || keys_.has("case")))
            complain("over", "over is a sweep, vary and case are comparisons; leave out one");
        if (keys_.has("vary") && keys_.has("case"))
            complain("case", "vary and case cannot be given together; use one of them");
        if (keys_.has("scene") || keys_.has("compare")) return;
        for (const char* key : {"set", "vary", "case", "over"})
            if (keys_.has(key)) complain(key, std::string(key) + " needs a run; name a scene");
    }

    Options options() const {
        const SlideRuns& runs = read_.runs;
        Options options;
        options.scenes = {runs.comparison.empty() ? runs.scene : runs.comparison};
        options.overrides = runs.settings;
        options.quiet = true;
        return options;
    }

    /// Reads the scene alone, then with its settings, so that errors are reported at the right key.
    bool readsAlone() {
        const SlideRuns& runs = read_.runs;
        const Comparison* comparison = comparisonCalled(runs.comparison);
        const std::string scene = comparison ? comparison->scene : runs.scene;
        try {
            loadScene(scene);
        } catch (const SceneError& error) {
            for (const std::string& line : error.lines()) complainOf("scene", "the scene: " + line);
            return false;
        }
        try {
            read_.scenes = {loadScene(scene, runs.settings)};
        } catch (const SceneError& error) {
            for (const std::string& line : error.lines()) complainOf("set", withSettings(line));
        }
        return good_;
    }

    /// Turns the option in "--set solver.sweep=4: ..." into a key of the deck.
    static std::string asKey(const std::string& what) {
        if (what.starts_with("--")) return what.substr(2);
        const std::size_t example = what.find(", for example --");
        if (example == std::string::npos) return what;
        return what.substr(0, example) + ", as in vary = \"solver.sweeps=1,4,16\"";
    }

    /// An error that the scene has only with these settings keeps its place in the scene.
    static std::string withSettings(const std::string& line) {
        return line.starts_with("--") ? asKey(line) : "with these settings: " + line;
    }

    void readAll() {
        const SlideRuns& runs = read_.runs;
        if (!runs.several()) return;
        const char* key = !runs.comparison.empty() ? "compare"
                          : !runs.over.empty()     ? "over"
                          : !runs.vary.empty()     ? "vary"
                                                   : "case";
        try {
            std::vector<Variant> variants;
            if (runs.over.empty()) {
                Comparing comparing = comparingOf(compareOptions(runs, options()));
                read_.point = comparing.point;
                variants = std::move(comparing.variants);
            } else {
                variants = sweepingOf(sweepOptions(runs, options())).variants;
            }
            read_.scenes.clear();
            for (Variant& variant : variants) read_.scenes.push_back(std::move(variant.scene));
        } catch (const SceneError& error) {
            for (const std::string& line : error.lines()) complainOf(key, withSettings(line));
        } catch (const Stop& stop) {
            complainOf(key, asKey(stop.what()));
        }
    }

    Keys& keys_;
    const fs::path& folder_;
    ReadRuns read_;
    bool good_ = true;
};

}  // namespace

ReadRuns readRuns(Keys& keys, const fs::path& folder) { return RunsReader(keys, folder).read(); }

}  // namespace demos
