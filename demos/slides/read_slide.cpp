#include "demos/slides/read_slide.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/film_plan.h"
#include "demos/look/overlays.h"
#include "demos/measures/measures.h"
#include "demos/measures/summary.h"
#include "demos/scene/table_readers.h"
#include "demos/slides/check_words.h"
#include "demos/slides/markup.h"
#include "demos/slides/read_runs.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

constexpr int kMostMoments = 12;
constexpr std::size_t kMostPictures = 9;  // that can still be read

class SlideReader {
public:
    SlideReader(Keys& keys, bool opening, DeckReading& reading)
        : keys_(keys),
          reading_(reading),
          opening_(opening),
          before_(reading.complaints.count()),
          loaded_(readRuns(keys, reading.folder)) {
        slide_.opening = opening;
        slide_.place = keys.place();
        slide_.runs = loaded_.runs;
    }

    Slide read() {
        if (!loaded_.point.empty()) slide_.caption = commonMarkOf(loaded_.point);
        readSection();
        readWords();
        readExhibit();
        readTimes();
        readPlay();
        readLists();
        needRuns();
        checkRate();
        noteFiles();
        keys_.done();
        needContent();
        return std::move(slide_);
    }

private:
    /// Whether the slide names runs; isRead(): and they could be read.
    bool hasRuns() const { return keys_.has("scene") || keys_.has("compare"); }
    bool isRead() const { return !loaded_.scenes.empty(); }

    /// The end of the shortest run, s.
    double end() const {
        double seconds = 1e5;
        for (const SceneDescription& scene : loaded_.scenes)
            seconds = std::min(seconds, scene.seconds);
        return seconds;
    }

    void readSection() {
        const std::optional<std::string> name = keys_.text("section");
        if (!name) return;
        for (const char* key : {"from", "until", "compare"})
            if (keys_.has(key))
                keys_.complain(key,
                               "a section already gives its scene and times; leave "
                               "out " +
                                   std::string(key) + ", or section");
        if (!isRead()) return;
        const SceneDescription& scene = loaded_.scenes.front();
        std::vector<std::string> names;
        for (const Section& section : scene.sections) {
            if (!section.name.empty()) names.push_back(section.name);
            if (section.name != *name) continue;
            copySection(scene, section, slide_.runs.several(), slide_);
            return checkSection(section, loaded_.scenes, keys_.placeOf("section"),
                                reading_.sections, reading_.complaints);
        }
        keys_.complainOf("section",
                         "'" + scene.name + "' has no section '" + shown(*name) + "'" +
                             (names.empty() ? "; it has none" : suggestion(*name, names)));
    }

    TomlPosition writtenAt(const Value& value) const { return {value.place, reading_.source}; }

    void readText(const char* key, std::string& to) {
        const std::optional<std::string> text = keys_.text(key);
        if (!text) return;
        to = *text;
        if (hasRuns() && !isRead()) return;  // reported already; every number would be an error
        checkWords(to, writtenAt(*keys_.any(key)), loaded_.scenes, reading_.complaints);
    }

    void readWords() {
        if (!opening_) readText("title", slide_.title);
        if (const Value* title = opening_ ? nullptr : keys_.any("title"))
            checkLine(title->text, writtenAt(*title), reading_.complaints);
        readText("text", slide_.text);
        if (const std::optional<bool> reveal = keys_.truth("reveal")) {
            slide_.reveal = *reveal;
            if (*reveal && !keys_.has("text"))
                keys_.complain("reveal", "reveal shows the items of a list one after the other, and "
                                         "there is no text; leave it out");
        }
        readText("caption", slide_.caption);
        readText("notes", slide_.notes);
        readFormulas();
        if (const std::optional<std::string> code = keys_.text("code")) {
            slide_.code = *code;
            checkPlain(*code, writtenAt(*keys_.any("code")), reading_.complaints);
        }
    }

    void readFormulas() {
        const std::optional<std::vector<std::string>> formulas = keys_.texts("formula");
        if (!formulas) return;
        slide_.formulas = *formulas;
        if (hasRuns() && !isRead()) return;
        const Value& value = *keys_.any("formula");
        for (std::size_t i = 0; i < formulas->size(); ++i)
            checkFormula((*formulas)[i], writtenAt(value.items.empty() ? value : value.items[i]),
                         loaded_.scenes, reading_.complaints);
    }

    void readExhibit() {
        slide_.exhibit = hasRuns() ? Exhibit::film : Exhibit::none;
        const std::vector<std::string> words = {"none", "film", "still", "strip"};
        if (const std::optional<std::string> word = keys_.word("picture", words))
            slide_.exhibit =
                static_cast<Exhibit>(std::find(words.begin(), words.end(), *word) - words.begin());
        if (keys_.has("at") && slide_.exhibit != Exhibit::still)
            keys_.complain("at",
                           "at is the time of a still; write picture = \"still\", or from and "
                           "until for a film");
        if (keys_.has("moments") && slide_.exhibit != Exhibit::strip)
            keys_.complain("moments", "moments needs a strip; write picture = \"strip\"");
        if (slide_.exhibit != Exhibit::film)
            for (const char* key : {"slow", "pause", "loop"})
                if (keys_.has(key))
                    keys_.complain(key, std::string(key) +
                                            " needs a film, and none is shown here; "
                                            "leave it out");
        set(slide_.moments, keys_.whole("moments", {1, kMostMoments}));
    }

    /// Reads a time of the run; the complaint about a later one says when the run ends.
    void readTime(const char* key, std::optional<double>& to) {
        const std::optional<double> time = keys_.number(key, {0.0, 1e5, "s"});
        if (!time) return;
        to = time;
        if (isRead() && *time > end())
            keys_.complainOf(key, std::string(key) + " is " + numberText(*time) +
                                      " s; the run ends at " + numberText(end()) + " s");
    }

    void readTimes() {
        std::optional<double> from;
        readTime("from", from);
        readTime("until", slide_.until);
        readTime("at", slide_.at);
        set(slide_.from, from);
        if (slide_.until && *slide_.until <= slide_.from)
            keys_.complainOf("until", "until is " + numberText(*slide_.until) +
                                          " s; it should be later than from, " +
                                          numberText(slide_.from) + " s");
        else if (isRead() && from && *from >= end() && !slide_.until)
            keys_.complainOf("from", "from is " + numberText(*from) + " s; the run ends then");
    }

    void readPoster() {
        const Value* value = keys_.any("poster");
        if (!value) return;
        const std::vector<std::string> words = {"first", "last"};
        if (value->kind == Value::Kind::text && value->text != words[0] && value->text != words[1])
            return keys_.complainOf("poster", "poster is " + describe(*value) +
                                                  "; it should be first, last or a time in s");
        if (!value->isNumber()) return set(slide_.poster, keys_.word("poster", words));
        const double until = slide_.until.value_or(end());
        if (const auto time = keys_.number("poster", {slide_.from, until, "s"}))
            slide_.poster = numberText(*time);
    }

    void readPlay() {
        set(slide_.slow, keys_.number("slow", {0.001, 1000.0}));
        set(slide_.pause, keys_.truth("pause"));
        set(slide_.loop, keys_.truth("loop"));
        readPoster();
        set(slide_.colorBy, keys_.word("colour_by", colorings()));
    }

    std::vector<std::string> readNames(const char* key, const char* what,
                                       const std::vector<std::string>& known) {
        const std::vector<std::string> names =
            keys_.texts(key).value_or(std::vector<std::string>{});
        for (std::size_t i = 0; i < names.size(); ++i)
            if (std::find(known.begin(), known.end(), names[i]) == known.end())
                keys_.complainOf(key,
                                 "no " + std::string(what) + " is called '" + shown(names[i]) +
                                     "'" + suggestion(names[i], known),
                                 i);
        return names;
    }

    /// Complains about parts that would be empty: a curve of joints without joints, an empty table.
    void needParts(const char* key, const std::vector<std::string>& names, const char* name,
                   bool (*has)(const SceneDescription&), const char* lack) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (!isRead() || found == names.end() ||
            std::any_of(loaded_.scenes.begin(), loaded_.scenes.end(), has))
            return;
        keys_.complainOf(
            key, "'" + loaded_.scenes.front().name + "' has no " + lack + "; leave out " + name,
            static_cast<std::size_t>(found - names.begin()));
    }

    void readLists() {
        const bool several = slide_.runs.several();
        slide_.show = readNames("show", "overlay", overlayNames());
        const std::vector<std::string> plots =
            readNames("plot", several ? "measure of several runs" : "chart of one run",
                      several ? measureWords() : measureNames());
        if (keys_.has("plot")) slide_.plots = plots;
        checkPictures();
        needParts(
            "plot", plots, "separation",
            [](const SceneDescription& scene) { return !scene.joints.empty(); }, "joints");
        const std::vector<std::string> tables = readNames("table", "table", tableNames());
        const auto names = [&](const char* table) {
            return std::find(tables.begin(), tables.end(), table) != tables.end();
        };
        needParts(
            "table", tables, "expectations",
            [](const SceneDescription& scene) { return !scene.expectations.empty(); },
            "[[expect]]");
        if (!keys_.has("table")) return;
        slide_.measures = names("measures");
        slide_.expectations = names("expectations");
    }

    void checkPictures() {
        const std::size_t count = slide_.plots.size() + (slide_.exhibit != Exhibit::none);
        if (count <= kMostPictures) return;
        keys_.complainOf("plot", fmt::format("a slide shows {} pictures at most; here are {}",
                                             kMostPictures, count));
    }

    void needRuns() {
        if (hasRuns()) return;
        for (const char* key : {"section", "picture", "from", "until", "poster", "show",
                                "colour_by", "plot", "table"})
            if (keys_.has(key))
                keys_.complain(key, std::string(key) + " needs a run; name a scene or compare");
    }

    void needContent() {
        const bool words = !slide_.title.empty() || !slide_.text.empty() ||
                           !slide_.formulas.empty() || !slide_.code.empty() ||
                           !slide_.caption.empty();
        const bool shows = slide_.exhibit != Exhibit::none || !slide_.plots.empty() ||
                           slide_.measures || slide_.expectations;
        if (opening_ || words || shows || reading_.complaints.count() > before_) return;
        reading_.complaints.add(keys_.place(),
                                "the slide shows nothing; give it a title, text or a scene");
    }

    /// A film's frames fall on steps.
    void checkRate() {
        if (!reading_.fps || slide_.exhibit != Exhibit::film) return;
        for (const SceneDescription& scene : loaded_.scenes) {
            if (scene.hz % *reading_.fps == 0) continue;
            return keys_.complainOf(
                keys_.has("scene") ? "scene" : "compare",
                fmt::format("fps of the deck is {}: '{}' steps {} times a second, which must be a "
                            "multiple; good: {}, or set = \"world.hz={}\"",
                            *reading_.fps, scene.name, scene.hz,
                            goodRates(scene.hz, *reading_.fps),
                            goodSteps(scene.hz, *reading_.fps)));
        }
    }

    void noteFiles() {
        const auto note = [&](const std::filesystem::path& path) {
            std::vector<std::filesystem::path>& files = reading_.files;
            if (std::find(files.begin(), files.end(), path) == files.end()) files.push_back(path);
        };
        if (slide_.runs.scene.find('/') != std::string::npos ||
            std::filesystem::path(slide_.runs.scene).has_extension())
            note(slide_.runs.scene);
        for (const SceneDescription& scene : loaded_.scenes)
            for (const std::string& file : scene.files) note(file);
    }

    Keys& keys_;
    DeckReading& reading_;
    bool opening_;
    int before_;  // number of complaints before this slide
    ReadRuns loaded_;
    Slide slide_;
};

}  // namespace

Slide readSlide(Keys keys, bool opening, DeckReading& reading) {
    return SlideReader(keys, opening, reading).read();
}

std::string slideId(int number, std::size_t count, const std::string& title) {
    constexpr std::size_t kLongest = 40;
    std::string words;
    for (const char c : plainOf(title)) {
        const bool capital = c >= 'A' && c <= 'Z';
        const bool letter = capital || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (letter)
            words += static_cast<char>(capital ? c - 'A' + 'a' : c);
        else if (!words.empty() && words.back() != '-')
            words += '-';
    }
    words.resize(std::min(words.size(), kLongest));
    while (words.ends_with('-')) words.pop_back();
    return fmt::format("{:0{}}{}{}", number, count > 99 ? 3 : 2, words.empty() ? "" : "-", words);
}

}  // namespace demos
