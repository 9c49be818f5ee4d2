#include "demos/gallery/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "demos/export/recording.h"
#include "demos/film/film_needs.h"
#include "demos/film/frame_source.h"
#include "demos/film/outputs.h"
#include "demos/film/renderer_name.h"
#include "demos/gallery/gallery_film.h"
#include "demos/gallery/gallery_page.h"
#include "demos/gallery/gallery_record.h"
#include "demos/gallery/gallery_sheet.h"
#include "demos/gallery/gallery_work.h"
#include "demos/processes/folder_lock.h"
#include "demos/processes/signals.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "demos/text/plural.h"
#include "demos/text/shell_word.h"
#include "demos/text/text_hash.h"
#include "render/encode/ffmpeg.h"
#include "render/encode/file.h"
#include "render/encode/png.h"
#include "render/encode/png_read.h"
#include "render/error.h"

namespace demos {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kTileWidth = 480;  // pixels, of the sheet

std::string jsonText(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// As in `impulse list`: by group, then in the given order; scenes without a group come first.
void sortByGroup(std::vector<GalleryCard>& cards) {
    std::stable_sort(cards.begin(), cards.end(),
                     [](const auto& a, const auto& b) { return a.group < b.group; });
}

void refuseStranger(const fs::path& file, bool own) {
    std::error_code ignored;
    if (!own && fs::exists(fs::symlink_status(file, ignored)))
        refuseToReplace(
            file,
            "already exists, and no gallery.json says that it is a gallery's; --overwrite "
            "replaces it");
}

class Gallery {
public:
    explicit Gallery(const GalleryOptions& options)
        : options_(options),
          talk_(options, false),
          troubles_(talk_),
          choices_(chooseGallery(options.scenes)),
          kinds_{options.films, options.replays},
          folder_(options.outputs.empty() ? "output/gallery" : options.outputs.front()),
          record_(folder_) {}

    GalleryMade play() {
        const Exit code = make();
        return {code, std::move(cards_)};
    }

private:
    Exit make() {
        if (kinds_.films && !render::haveFfmpeg()) {
            kinds_.films = false;
            talk_.mention("ffmpeg is not installed: posters are made, films are not");
        }
        render::makeFolder(folder_);
        const FolderLock lock(folder_);
        watchSignals();
        renderer_ = rendererName(options_);
        readAll();
        if (cards_.empty()) return tellNothing();
        checkSheet();
        checkOwn();
        drawMissing();
        return writePages();
    }

    /// Reads the scenes, and finds out which of their files are missing.
    void readAll() {
        const auto read = [this](int i) {
            return attempted([&] {
                const GalleryOptions own = optionsOfFilm(choices_[i], options_);
                const FilmPlan plan = planFilm(own);
                std::vector<Output> films;
                if (kinds_.films)
                    films.push_back({OutputKind::film, {}, record_.filmFile(choices_[i].name)});
                checkOutputs(films, plan, true);
                if (kinds_.replays) checkLength(plan, "--no-replays");
                checkNeeds(needsOf(plan, jobsFor(choices_), films), plan);
                return jsonText(jsonOf(cardOf(choices_[i], plan, own, renderer_)));
            });
        };
        inProcesses(choices_, read, [this](const GalleryChoice& choice, const std::string& text) {
            cards_.push_back(cardFrom(Json::parse(text)));
            if (!record_.has(cards_.back(), kinds_)) missing_.push_back(choice);
        });
        sortByGroup(cards_);
    }

    /// Before anything is drawn: the sheet of all scenes may be too large for a PNG.
    void checkSheet() const {
        stripLayout(static_cast<int>(cards_.size()), options_.columns, tileSize(), true);
    }

    /// Before anything is drawn: refuses to replace files that are not the gallery's.
    void checkOwn() const {
        if (options_.overwrite) return;
        refuseStranger(record_.pageFile(), record_.found());
        refuseStranger(record_.sheetFile(), record_.found());
        refuseOutdated();
        for (const GalleryChoice& choice : missing_) {
            const bool own = record_.owns(choice.name);
            refuseStranger(record_.posterFile(choice.name), own);
            if (kinds_.films) refuseStranger(record_.filmFile(choice.name), own);
            if (kinds_.replays) refuseStranger(record_.replayFile(choice.name), own);
        }
    }

    void refuseOutdated() const {
        std::vector<std::string> names;
        for (const GalleryCard& card : cards_)
            if (record_.isOutdated(card)) names.push_back(card.name);
        if (names.empty()) return;
        refuseToReplace(folder_,
                        fmt::format("holds {} of another run (other settings, scene or program), "
                                    "the first is '{}'; --overwrite replaces what differs",
                                    plural(names.size(), "scene"), printable(names.front())));
    }

    void drawMissing() {
        record_.command = options_.commandLine;
        for (const GalleryChoice& choice : missing_) record_.add(choice.name, {});
        if (!missing_.empty()) record_.write();
        const std::size_t kept = cards_.size() - missing_.size();
        talk_.json(
            fmt::format(R"({{"event":"start","scenes":{},"kept":{}}})", cards_.size(), kept));
        const auto draw = [this](int i) { return attempted([&] { return drawn(missing_[i]); }); };
        try {
            inProcesses(
                missing_, draw,
                [this](const GalleryChoice& choice, const std::string&) { tell(choice.name); },
                [this](const GalleryChoice& choice, const std::string& text) {
                    keep(choice.name, Json::parse(text));
                });
        } catch (const Stop& stop) {
            for (const GalleryChoice& choice : missing_) {
                render::sweepTemporaries(record_.filmFile(choice.name));
                render::sweepTemporaries(record_.posterFile(choice.name));
                render::sweepTemporaries(record_.replayFile(choice.name));
            }
            throw Stop(stop.code(),
                       fmt::format("{} scenes; to resume: {}", stop.what(), options_.commandLine));
        }
    }

    /// Runs in the scene's own process.
    std::string drawn(const GalleryChoice& choice) const {
        GalleryOptions own = optionsOfFilm(choice, options_);
        own.quiet = true;  // its notes have been reported
        GalleryFiles files{record_.posterFile(choice.name), {}, {}};
        if (kinds_.films) files.film = record_.filmFile(choice.name);
        if (kinds_.replays) files.replay = record_.replayFile(choice.name);
        const GalleryEntry entry = drawScene(planPictures(own), files);
        return jsonText({{"poster", hexText(entry.poster)},
                         {"film", hexText(entry.film)},
                         {"replay", hexText(entry.replay)},
                         {"incident", entry.incident}});
    }

    /// Recorded as soon as it is drawn, so that an interrupted run does not draw it again.
    void keep(const std::string& name, const Json& made) {
        const auto number = [&made](const char* key) {
            return std::stoull(made.at(key).get<std::string>(), nullptr, 16);
        };
        record_.add(name, {cardCalled(name).fingerprint, number("poster"), number("film"),
                           number("replay"), made.at("incident").get<std::string>()});
        record_.write();
    }

    void tell(const std::string& name) const {
        const GalleryCard& card = cardCalled(name);
        talk_.say(fmt::format("  {:18} {:g} s, {}", printable(name), card.seconds,
                              plural(card.frames, "frame")));
        talk_.json(jsonText({{"event", "scene"}, {"scene", name}, {"frames", card.frames}}));
        std::fflush(stdout);
    }

    const GalleryCard& cardCalled(const std::string& name) const {
        return *std::find_if(cards_.begin(), cards_.end(),
                             [&name](const GalleryCard& card) { return card.name == name; });
    }

    /// Writes the page and the sheet of the scenes whose files exist now.
    Exit writePages() {
        const std::size_t read = cards_.size();
        std::erase_if(cards_, [this](const auto& card) { return !record_.has(card, kinds_); });
        if (cards_.empty()) return tellNothing();
        for (GalleryCard& card : cards_) {
            card.film = kinds_.films;
            card.replay = kinds_.replays;
        }
        const bool sheet = writeSheet();
        render::writeFileAtomically(
            record_.pageFile(), galleryPage(cards_, renderer_, wordsOf(options_), options_.links));
        record_.command = options_.commandLine;
        record_.write();
        for (const GalleryCard& card : cards_)
            troubles_.tellIncident(card.name, record_.incidentOf(card.name));
        const std::string page = record_.pageFile().string();
        talk_.json(jsonText({{"event", "done"},
                             {"page", page},
                             {"scenes", cards_.size()},
                             {"failed", troubles_.count()}}));
        talk_.say(fmt::format(
            "wrote {} ({}, {} drawn, {} kept{}){}", printable(page), plural(cards_.size(), "scene"),
            missing_.size() - (read - cards_.size()), read - missing_.size(),
            troubles_.count() > 0 ? fmt::format(", {} failed", troubles_.count()) : "",
            sheet ? ", sheet.png" : ""));
        if (options_.links.empty())
            talk_.say(fmt::format("next: open {}", printable(shellWord(page))));
        return troubles_.code();
    }

    Exit tellNothing() const {
        talk_.json(jsonText({{"event", "done"}, {"scenes", 0}, {"failed", troubles_.count()}}));
        talk_.say("no page was written: there is no scene to show");
        return troubles_.code();
    }

    PictureSize tileSize() const {
        const GalleryCard& first = cards_.front();
        const int width = std::min(kTileWidth, first.width);
        return {width, std::max(1, first.height * width / first.width)};
    }

    render::Image posterOf(const GalleryCard& card) const {
        const fs::path file = record_.posterFile(card.name);
        try {
            return render::decodePng(contentOf(file), card.width, card.height);
        } catch (const render::Error& error) {
            throw render::Error(printable(file.string()) + ": " + error.what());
        }
    }

    /// False: it is up to date.
    bool writeSheet() {
        TextHash inputs;
        inputs.add(std::to_string(options_.columns));
        for (const GalleryCard& card : cards_)
            inputs.add(card.name + hexText(record_.posterOf(card.name)));
        std::error_code ignored;
        if (record_.sheet == inputs.value() && fs::exists(record_.sheetFile(), ignored))
            return false;
        GallerySheet sheet(static_cast<int>(cards_.size()), options_.columns, tileSize());
        for (const GalleryCard& card : cards_) sheet.add(posterOf(card), card.name);
        render::writeFileAtomically(record_.sheetFile(), render::encodePng(sheet.paper()));
        record_.sheet = inputs.value();
        return true;
    }

    int jobsFor(const std::vector<GalleryChoice>& choices) const {
        return workerCount(options_.jobs, static_cast<int>(choices.size()));
    }

    using Taken = std::function<void(const GalleryChoice&, const std::string&)>;

    /// Calls `take` in the order of the choices, `finished` in the order in which they end.
    void inProcesses(const std::vector<GalleryChoice>& choices,
                     const std::function<std::string(int)>& work, const Taken& take,
                     const Taken& finished = {}) {
        const auto inOrder = [&](int i, const PoolResult& result) {
            std::string text;
            if (troubles_.take(choices[i], result, text)) take(choices[i], text);
        };
        const auto atOnce = [&](int i, const PoolResult& result) {
            const std::optional<std::string> text = finished ? textOf(result) : std::nullopt;
            if (text) finished(choices[i], *text);
        };
        runInProcesses(static_cast<int>(choices.size()), jobsFor(choices), work, inOrder, atOnce);
    }

    const GalleryOptions& options_;
    Talk talk_;
    GalleryTroubles troubles_;
    std::vector<GalleryChoice> choices_, missing_;
    GalleryKinds kinds_;
    fs::path folder_;
    GalleryRecord record_;
    std::string renderer_;
    std::vector<GalleryCard> cards_;
};

}  // namespace

GalleryMade galleryInFolder(const GalleryOptions& options) { return Gallery(options).play(); }

}  // namespace demos
