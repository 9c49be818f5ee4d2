// impulse watch: a draft of a scene file whenever it is saved.

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/film_needs.h"
#include "demos/film/outputs.h"
#include "demos/film/progress.h"
#include "demos/film/scene_fps.h"
#include "demos/load/builtin.h"
#include "demos/load/load_scene.h"
#include "demos/processes/signals.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"
#include "demos/text/put_text.h"
#include "demos/watch/draft_lock.h"
#include "demos/watch/draft_text.h"
#include "demos/watch/file_watch.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

struct WatchOptions : Options {
    bool once = false;  // make one draft and exit
};

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string nameOf(const WatchOptions& options) {
    return sceneNameOf(options.scene());
}

DraftPlaces placesOf(const WatchOptions& options) {
    DraftPlaces places;
    places.folder = options.outputs.empty() ? fs::path("output") / nameOf(options)
                                            : fs::path(options.outputs.front());
    places.films = render::haveFfmpeg();
    return places;
}

class Watching {
public:
    explicit Watching(const WatchOptions& options)
        : options_(options), talk_(options, false), drafts_(placesOf(options)) {
        options_.quality = "draft";
    }

    Exit play() {
        watchSignals();
        if (options_.theme == "transparent")
            throw Stop(Exit::usage,
                       "--theme transparent: a draft has no alpha; leave it out, or make a film: "
                       "impulse render -o FILE.webm");
        if (!drafts_.places().films)
            talk_.mention(
                "ffmpeg is not installed: drafts are PNG frames and a strip instead of a film");
        if (options_.once) return makeDraft();
        if (isBuiltin(options_.scene()))
            throw Stop(Exit::usage,
                       fmt::format("'{0}' is built in and does not change; watch a file of your "
                                   "own (impulse list {0} --print > {0}.toml), or give --once",
                                   options_.scene()));
        if (!fs::exists(options_.scene())) loadScene(options_.scene());  // throws the reason
        files_.emplace(DraftPlaces::names());
        files_->watch({options_.scene()});
        return goOn();
    }

private:
    Exit goOn() {
        for (bool first = true;; first = false) {
            attempt(first);
            if (interrupted()) return Exit::interrupted;
            if (first) tellWatched();
            std::fflush(stdout);
            // An error may name a file that is not watched yet.
            const auto which =
                errors_.empty() ? FileWatch::Which::files : FileWatch::Which::anyBeside;
            if (!files_->wait(which)) return Exit::interrupted;
        }
    }

    /// Errors are reported; the next save may fix them.
    void attempt(bool first) {
        try {
            if (!first && !fs::exists(options_.scene()))
                return tellErrors({options_.scene() + " is gone; waiting for it"});
            makeDraft();
        } catch (const SceneError& error) {
            tellErrors(error.lines());
        } catch (const Stop& stop) {
            if (first) throw;  // the command line's fault
            tellErrors({stop.what()});
        } catch (const render::Error& error) {
            tellErrors({error.what()});
        }
    }

    /// Printed even with --quiet, but not again while they stay the same.
    void tellErrors(const std::vector<std::string>& lines) {
        if (lines == errors_) return;
        errors_ = lines;
        const Json json{{"event", "error"}, {"lines", lines}};
        talk_.json(json.dump(-1, ' ', false, Json::error_handler_t::replace));
        for (const std::string& line : lines) putError(printable(line));
    }

    Exit makeDraft() {
        const Options own = optionsOfDraft();
        FilmPlan plan = planFilm(own);
        std::vector<Output> films;
        if (drafts_.places().films)
            films.push_back({OutputKind::film, {}, drafts_.places().film()});
        checkOutputs(films, plan, true);
        checkNeeds(needsOf(plan, 1, films), plan);
        fitCameras(plan);
        if (!lock_) {
            render::makeFolder(drafts_.places().folder);
            lock_.emplace(drafts_.places());
        }
        const Draft draft = drafts_.make(plan, own, [this] {
            return interrupted() || (files_ && files_->hasNews(FileWatch::Which::files));
        });
        return draft.whole ? tell(draft, plan) : Exit::interrupted;
    }

    Exit tell(const Draft& draft, const FilmPlan& plan) {
        errors_.clear();
        for (const std::string& line : draftLines(draft, plan, drafts_.places())) talk_.say(line);
        std::fflush(stdout);
        for (const std::string& line : failureLines(draft, plan)) putError(line);
        talk_.json(draftJson(draft, plan, drafts_.places()));
        if (!draft.trouble.empty()) return Exit::diverged;
        return draft.failed.empty() ? Exit::ok : Exit::failed;
    }

    /// Reads the scene until all of its files were watched before they were read.
    Options optionsOfDraft() {
        SceneDescription scene = loadScene(options_.scene(), options_.overrides);
        while (files_ && files_->watch(filesOf(scene)))
            scene = loadScene(options_.scene(), options_.overrides);
        read_ = scene.files.size();
        Options own = options_;
        suitFilm(scene, own);
        return own;
    }

    std::vector<fs::path> filesOf(const SceneDescription& scene) const {
        std::vector<fs::path> files{options_.scene()};
        files.insert(files.end(), scene.files.begin(), scene.files.end());
        return files;
    }

    void tellWatched() const {
        talk_.say(fmt::format("watching {}{}; Ctrl-C ends it", printable(options_.scene()),
                              read_ == 0   ? ""
                              : read_ == 1 ? " and the file that it reads"
                                           : fmt::format(" and {} files that it reads", read_)));
        talk_.json(fmt::format(R"({{"event":"watching","files":{}}})", read_ + 1));
    }

    WatchOptions options_;
    Talk talk_;
    DraftMaker drafts_;
    std::optional<DraftLock> lock_;    // from the first draft on
    std::optional<FileWatch> files_;   // not with --once
    std::vector<std::string> errors_;  // of the last attempt
    std::size_t read_ = 0;             // files besides the scene's own
};

Exit watch(const WatchOptions& options) { return Watching(options).play(); }

Run addWatch(CLI::App& app) {
    const auto asked = std::make_shared<Asked<WatchOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    addSceneChoice(app, options, texts);
    app.add_flag("--once", options.once,
                 "make one draft and exit; default: off, until Ctrl-C (exit code 130)");
    app.add_option("-o,--output", options.outputs,
                   "a folder for draft.mp4 and draft.png; default: output/<scene>")
        ->type_name("DIR")
        ->expected(1);
    addSeconds(app, options);
    app.add_option("--size", texts.size, "pixels, 1..16384 a side; default: 480x270")
        ->type_name("WxH");
    takesList(
        app.add_option("--show", texts.show,
                       "overlays, with commas, see impulse render --help; default: the scene's")
            ->type_name("NAMES"));
    app.add_option("--theme", options.theme, "studio, dark or print; default: the scene's")
        ->type_name("NAME");
    app.add_option("--colour-by,--color-by", options.colorBy,
                   "what the bodies' colours show, see impulse render --help; default: the scene's")
        ->type_name("NAME");
    app.add_option("--context", options.context,
                   "source of OpenGL: osmesa, egl or auto, the first that works; default: auto")
        ->type_name("NAME");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) { return watch(settled(*asked, commandLine)); };
}

}  // namespace

Command watchCommand() {
    return {"watch",
            "draw a draft of a scene file whenever it is saved; only what changed is drawn again",
            {"impulse watch my.toml", "impulse watch my.toml --show contacts --seconds 3",
             "impulse watch stack --once"},
            addWatch};
}

}  // namespace demos
