#include <fmt/format.h>

#include <algorithm>

#include "demos/commands/commands.h"
#include "demos/commands/table.h"
#include "demos/film/progress.h"
#include "demos/scene/complaints.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/deck_of_scenes.h"
#include "demos/slides/make_deck.h"
#include "demos/slides/read_deck.h"
#include "demos/slides/scratch_folder.h"
#include "demos/slides/slide_media.h"
#include "demos/slides/slides_output.h"
#include "render/error.h"

namespace demos {
namespace {

constexpr std::size_t kLargePage = 50'000'000;  // bytes, which some browsers take their time for

[[noreturn]] void refuse(const std::string& line) { throw Stop(Exit::usage, line); }

/// What a deck says itself cannot be said again for all of its slides.
void checkDeckAlone(const Options& options) {
    if (options.scenes.size() > 1)
        refuse(fmt::format("'{}' is a deck, which is shown alone", printable(options.scene())));
    if (!options.overrides.empty())
        refuse("--set belongs to scenes; a deck's slides have settings of their own");
    if (options.seconds) refuse("--seconds belongs to scenes; a deck's slides have from and until");
}

Deck deckOf(const Options& options) {
    const auto deckFile = std::find_if(options.scenes.begin(), options.scenes.end(), isDeckFile);
    Deck deck;
    if (deckFile != options.scenes.end()) {
        checkDeckAlone(options);
        deck = loadDeck(*deckFile);
    } else {
        deck = deckOfScenes(options);
    }
    if (options.theme == "transparent")
        refuse("--theme transparent: slides have a ground; studio, dark or print");
    if (!options.theme.empty()) deck.theme = options.theme;
    if (options.size) deck.size = *options.size;
    if (options.fps) deck.fps = *options.fps;
    return deck;
}

std::string amount(std::size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string megabytes(std::size_t bytes) {
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

class SlidesWriter {
public:
    SlidesWriter(const Options& options, const MadeDeck& deck)
        : talk_(options, false), deck_(deck) {}

    void write(const SlidesOutput& output) {
        switch (output.kind) {
            case SlidesKind::page:
                return writePage(output.name);
            case SlidesKind::pdf:
                return writePdf(output.name);
            case SlidesKind::folder:
                return writeFolder(output.name);
        }
    }
    /// Of what could not be written; the others are.
    const std::string& trouble() const { return trouble_; }

private:
    void tell(const std::string& name, const std::string& what, std::size_t bytes) const {
        talk_.say(fmt::format("wrote {} ({}, {})", printable(name), what, megabytes(bytes)));
        talk_.json(
            fmt::format(R"({{"event":"slides","file":{},"slides":{},"films":{},"bytes":{}}})",
                        jsonString(name), deck_.slides.size(), films(), bytes));
    }
    std::size_t films() const {
        return static_cast<std::size_t>(
            std::count_if(deck_.slides.begin(), deck_.slides.end(), hasFilm));
    }
    std::string slides() const { return amount(deck_.slides.size(), "slide"); }

    void writePage(const std::string& name) {
        const std::string page = slidesPage(deck_);
        writeResult(name, {reinterpret_cast<const std::uint8_t*>(page.data()), page.size()});
        tell(name, slides() + ", " + amount(films(), "film"), page.size());
        if (page.size() > kLargePage)
            talk_.mention(
                fmt::format("{} is large for one page; a folder (-o talk/) loads films "
                            "as they come",
                            printable(name)));
    }

    /// The others are worth having without it.
    void writePdf(const std::string& name) try {
        writeSlidesPdf(deck_, name);
        std::error_code ignored;
        tell(name, slides(), std::filesystem::file_size(name, ignored));
    } catch (const render::Error& error) {
        trouble_ = error.what();
    }

    void writeFolder(const std::string& name) {
        std::size_t bytes = 0;
        const std::vector<std::filesystem::path> files = writeSlidesFolder(deck_, name);
        for (const std::filesystem::path& file : files) {
            std::error_code ignored;
            bytes += std::filesystem::file_size(std::filesystem::path(name) / file, ignored);
        }
        tell(name, slides() + ", " + amount(files.size(), "file"), bytes);
    }

    Talk talk_;
    const MadeDeck& deck_;
    std::string trouble_;
};

std::string nextOf(const SlidesOutput& output) {
    const std::string name = printable(output.name);
    if (output.kind == SlidesKind::pdf) return "next: open " + name;
    const std::string page =
        output.kind == SlidesKind::page
            ? name
            : printable((std::filesystem::path(output.name) / "index.html").string());
    return fmt::format("next: open {} in a browser; ? shows the keys, s the notes", page);
}

Exit sayPlan(const Deck& deck, const std::vector<SlidesOutput>& outputs, const Talk& talk) {
    const auto count = [&](Exhibit exhibit) {
        return std::count_if(deck.slides.begin(), deck.slides.end(),
                             [&](const Slide& slide) { return slide.exhibit == exhibit; });
    };
    talk.say(
        fmt::format("{}: {}, {}, {}", printable(deck.name), amount(deck.slides.size(), "slide"),
                    amount(static_cast<std::size_t>(count(Exhibit::film)), "film"),
                    amount(static_cast<std::size_t>(count(Exhibit::still) + count(Exhibit::strip)),
                           "picture")));
    for (const SlidesOutput& output : outputs) talk.say("would write " + printable(output.name));
    return Exit::ok;
}

}  // namespace

Exit slidesCommand(const Options& options) {
    const Deck deck = deckOf(options);
    const std::vector<SlidesOutput> outputs = slidesOutputsOf(options, deck);
    const Talk talk(options, false);
    if (options.dryRun) return sayPlan(deck, outputs, talk);
    const auto moves = [](const SlidesOutput& output) { return output.kind != SlidesKind::pdf; };
    const ScratchFolder scratch;
    const MadeDeck made = makeDeck(
        deck, {scratch.path(), std::any_of(outputs.begin(), outputs.end(), moves), options});
    for (const std::string& remark : made.remarks) talk.mention(remark);
    SlidesWriter writer(options, made);
    for (const SlidesOutput& output : outputs) writer.write(output);
    if (writer.trouble().empty() || outputs.front().kind != SlidesKind::pdf)
        talk.say(nextOf(outputs.front()));
    if (!writer.trouble().empty()) throw render::Error(writer.trouble());
    return Exit::ok;
}

}  // namespace demos
