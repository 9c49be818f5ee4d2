#include "demos/scene/reader.h"
#include "demos/slides/read_deck.h"

#include <algorithm>
#include <cmath>

#include "demos/load/builtin.h"
#include "demos/scene/expression.h"
#include "demos/scene/keys.h"
#include "demos/slides/check_words.h"
#include "demos/slides/read_slide.h"
#include "demos/text/nearest.h"

namespace demos {
namespace {

namespace fs = std::filesystem;

constexpr int kMostFps = 240;

void readFormat(Keys& top) {
    const Value* format = top.any("format");
    if (!format)
        top.complain("format", "the deck has no format; begin it with format = 1");
    else if (format->kind == Value::Kind::integer && format->integer == 1)
        top.whole("format", {1, 1});
    else
        top.complain("format", "format is " + describe(*format) + "; this version reads format 1");
}

void readSize(Keys& top, PictureSize& size) {
    const char* right = "two even whole numbers [width, height] of pixels";
    const Value* value = top.any("size");
    if (value && value->kind == Value::Kind::array && value->items.size() != 2)
        return top.complainOf("size", "size is " + describe(*value) + "; it should be " + right);
    const auto pixels = top.numbers("size", {kLeastSlideSide, kMostSlideSide, "pixels"});
    if (!pixels) return;
    // Films have colour at half the resolution in each direction.
    const auto isEven = [](double x) { return x == 2.0 * std::floor(0.5 * x); };
    if (!std::all_of(pixels->begin(), pixels->end(), isEven))
        return top.complainOf("size", std::string("size should be ") + right);
    size = {static_cast<int>((*pixels)[0]), static_cast<int>((*pixels)[1])};
}

class DeckReader {
public:
    DeckReader(std::string_view text, const fs::path& file, Complaints& complaints)
        : folder_(file.parent_path()),
          complaints_(complaints),
          reading_{folder_, text, std::nullopt, complaints, SectionFiles(complaints)} {
        deck_.name = sceneNameOf(file);
        deck_.files = {file};
    }

    Deck read(const Value& document, const Scope& scope) {
        Keys top(document, "a deck", complaints_, scope);
        readFormat(top);
        if (const auto dollars = std::ranges::count(reading_.source, '$'); dollars > kMostDollars) {
            top.complain("", "the deck has " + std::to_string(dollars) +
                                 " $ around formulas; it should have at most " +
                                 std::to_string(kMostDollars));
            return std::move(deck_);
        }
        readWords(top);
        set(deck_.theme, top.word("theme", {"studio", "dark", "print"}));
        readSize(top, deck_.size);
        reading_.fps = top.whole("fps", {1, kMostFps, "frames a second"});
        set(deck_.fps, reading_.fps);
        readOpening(top);
        readSlides(top);
        top.done();
        for (fs::path& path : reading_.files) deck_.files.push_back(std::move(path));
        return std::move(deck_);
    }

private:
    /// Reads one line and returns its position; nothing if the key is missing.
    std::optional<TomlPosition> readText(Keys& top, const char* key, std::string& to) {
        const std::optional<std::string> line = top.text(key);
        if (!line) return std::nullopt;
        to = *line;
        const TomlPosition position{top.any(key)->place, reading_.source};
        checkLine(to, position, complaints_);
        return position;
    }

    void readLine(Keys& top, const char* key, std::string& to) {
        if (const std::optional<TomlPosition> position = readText(top, key, to))
            checkWords(to, *position, {}, complaints_);
    }

    /// Plain text, not CommonMark: a date may be "24. 12.", an author may be from "$-Soft".
    void readPlain(Keys& top, const char* key, std::string& to) {
        if (const std::optional<TomlPosition> position = readText(top, key, to))
            checkPlain(to, *position, complaints_);
    }

    void readWords(Keys& top) {
        readLine(top, "title", deck_.title);
        if (!top.has("title"))
            top.complain("title", "the deck has no title; write title = \"...\"");
        readLine(top, "subtitle", deck_.subtitle);
        readPlain(top, "author", deck_.author);
        readPlain(top, "date", deck_.date);
    }

    /// `opening` is a table with the slide's keys, or false for no opening.
    void readOpening(Keys& top) {
        const Value* opening = top.any("opening");
        Slide slide;
        if (opening && opening->kind != Value::Kind::table) {
            if (opening->kind == Value::Kind::boolean && !opening->boolean) return;
            top.complainOf("opening", "opening is " + describe(*opening) +
                                          "; it should be false, or a table [opening]");
        } else if (opening) {
            slide = readSlide(top.inner(*opening, "[opening]"), true, reading_);
        }
        slide.opening = true;
        slide.title = deck_.title;
        deck_.slides.push_back(std::move(slide));
    }

    void readSlides(Keys& top) {
        const std::vector<const Value*> tables = top.tables("slide");
        const Value* list = top.any("slide");
        const bool none = !list || (list->kind == Value::Kind::array && list->items.empty());
        if (none) top.complain("slide", "the deck has no slide; write a [[slide]]");
        if (tables.size() > kMostSlides)
            return top.complain("slide", std::to_string(tables.size()) +
                                             " slides; a deck has at most " +
                                             std::to_string(kMostSlides));
        for (const Value* table : tables)
            deck_.slides.push_back(readSlide(top.inner(*table, "a [[slide]]"), false, reading_));
        for (std::size_t i = 0; i < deck_.slides.size(); ++i)
            deck_.slides[i].id =
                slideId(static_cast<int>(i) + 1, deck_.slides.size(), deck_.slides[i].title);
    }

    fs::path folder_;
    Complaints& complaints_;
    DeckReading reading_;
    Deck deck_;
};

/// Recognizes a deck by keys that only decks have, even misspelled; without `slide`, all keys of
/// the file must be keys of a deck.
bool isDeck(const Value& file) {
    const std::vector<std::string> slide = {"slide"};
    const std::vector<std::string> own = {"subtitle", "author", "date", "opening", "fps", "size"};
    if (file.find("slide")) return true;
    if (file.find("body")) return false;
    return std::all_of(file.keys.begin(), file.keys.end(), [&](const Key& key) {
        return key.name == "format" || key.name == "title" || key.name == "theme" ||
               !nearest(key.name, slide).empty() || !nearest(key.name, own).empty();
    });
}

}  // namespace

bool isDeckFile(const std::string& nameOrPath) {
    if (isBuiltin(nameOrPath) || fs::path(nameOrPath).extension() != ".toml") return false;
    try {
        Complaints complaints;
        const Value file = parseToml(readSceneFile(nameOrPath), complaints);
        return complaints.count() == 0 && isDeck(file);
    } catch (const SceneError&) {
        return false;
    }
}

Deck readDeck(std::string_view text, const fs::path& file) {
    Complaints complaints;
    complaints.addFile(file.string());
    const Value document = parseToml(text, complaints);
    if (complaints.count() > 0) throw SceneError(complaints.lines());
    Expressions expressions;
    Deck deck = DeckReader(text, file, complaints).read(document, {&expressions, {}, nullptr});
    if (complaints.count() > 0) throw SceneError(complaints.lines());
    return deck;
}

Catalog catalogDeck(std::string_view text) {
    Complaints complaints;
    complaints.addFile("deck.toml");
    const Value document = parseToml(text, complaints);
    Catalog catalog;
    Expressions expressions;
    DeckReader(text, "deck.toml", complaints).read(document, {&expressions, {}, &catalog});
    return catalog;
}

Deck loadDeck(const fs::path& file) { return readDeck(readSceneFile(file, "a deck"), file); }

}  // namespace demos
