#ifdef IMPULSE_HAVE_SLIDES

#include <fmt/format.h>

#include <algorithm>

#include "demos/commands/commands.h"
#include "demos/commands/shared_options.h"
#include "demos/film/progress.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/deck_of_scenes.h"
#include "demos/slides/make_deck.h"
#include "demos/slides/read_deck.h"
#include "demos/slides/scratch_folder.h"
#include "demos/slides/slide_media.h"
#include "demos/slides/slides_output.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/table.h"
#include "render/error.h"

namespace demos {
namespace {

struct SlidesOptions : Options {
    bool dryRun = false;  // say what the deck holds, draw nothing
};

constexpr std::size_t kLargePage = 50'000'000;  // bytes; some browsers are slow to load more

/// Refuses options that a deck sets itself, slide by slide.
void checkDeckAlone(const std::string& deckFile, const SlidesOptions& options) {
    if (options.scenes.size() > 1)
        refuse(fmt::format("'{}' is a deck; it takes no other scene or deck", printable(deckFile)));
    if (!options.overrides.empty())
        refuse("--set is for scenes; a deck's slides have settings of their own");
    if (options.seconds) refuse("--seconds is for scenes; a deck's slides have from and until");
}

/// The limits are those of a deck's own theme and size.
void checkLook(const SlidesOptions& options) {
    if (options.theme == "transparent")
        refuse("--theme transparent: slides need a ground; use studio, dark or print");
    if (!options.size) return;
    const PictureSize size = *options.size;
    for (const int side : {size.width, size.height})
        if (side < kLeastSlideSide || side > kMostSlideSide || side % 2 != 0)
            refuse(fmt::format("--size {}x{}: the sides of a slide must be even, {} to {} pixels",
                               size.width, size.height, kLeastSlideSide, kMostSlideSide));
}

Deck deckOf(const SlidesOptions& options) {
    checkLook(options);
    const auto deckFile = std::find_if(options.scenes.begin(), options.scenes.end(), isDeckFile);
    if (deckFile == options.scenes.end()) return deckOfScenes(options);
    checkDeckAlone(*deckFile, options);
    Deck deck = loadDeck(*deckFile);
    if (!options.theme.empty()) deck.theme = options.theme;
    if (options.size) deck.size = *options.size;
    if (options.fps) deck.fps = *options.fps;
    return deck;
}

bool isPdf(const SlidesOutput& output) { return output.kind == SlidesKind::pdf; }

bool isPptx(const SlidesOutput& output) { return output.kind == SlidesKind::pptx; }

bool needsBrowser(const SlidesOutput& output) { return isPdf(output) || isPptx(output); }

/// Warns before drawing of files that cannot be made. Throws if nothing else is requested.
void checkBrowser(const std::vector<SlidesOutput>& outputs, const Talk& talk) {
    if (std::none_of(outputs.begin(), outputs.end(), needsBrowser) || !pdfBrowser().empty()) return;
    if (std::all_of(outputs.begin(), outputs.end(), needsBrowser))
        throw render::Error(
            fmt::format("chromium is needed for a {}; install it (apt install chromium); "
                        "-o talk.html and -o talk/ work without it",
                        isPdf(outputs.front()) ? "PDF" : ".pptx"));
    for (const SlidesOutput& output : outputs)
        if (needsBrowser(output))
            talk.mention(fmt::format("no chromium to {} (apt install chromium): '{}' will not be "
                                     "made, all other outputs will",
                                     isPdf(output) ? "print PDFs" : "lay out a .pptx",
                                     printable(output.name)));
}

std::string megabytes(std::size_t bytes) {
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

class SlidesWriter {
public:
    SlidesWriter(const SlidesOptions& options, const MadeDeck& deck)
        : options_(options), talk_(options, false), deck_(deck) {}

    void write(const SlidesOutput& output) {
        switch (output.kind) {
            case SlidesKind::page:
                return writePage(output.name);
            case SlidesKind::pdf:
            case SlidesKind::pptx:
                return writeByBrowser(output);
            case SlidesKind::folder:
                return writeFolder(output.name);
        }
    }
    /// The errors of outputs that could not be written, without repetitions.
    const std::vector<std::string>& troubles() const { return troubles_; }

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
    std::string slides() const { return plural(deck_.slides.size(), "slide"); }

    void writePage(const std::string& name) {
        const std::string page = slidesPage(deck_);
        writeResult(name, {reinterpret_cast<const std::uint8_t*>(page.data()), page.size()},
                    existingFiles(options_.overwrite));
        tell(name, slides() + ", " + plural(films(), "film"), page.size());
        if (page.size() > kLargePage)
            talk_.mention(
                fmt::format("{} is large for one page; a folder (-o talk/) loads films "
                            "when they are shown",
                            printable(name)));
    }

    /// Errors are only noted: the other outputs are useful without this one.
    void writeByBrowser(const SlidesOutput& output) try {
        const bool paper = isPdf(output);
        (paper ? writeSlidesPdf : writeSlidesPptx)(deck_, output.name, existingFiles(options_.overwrite));
        std::error_code ignored;
        tell(output.name, slides() + (paper ? "" : ", " + plural(films(), "film")),
             std::filesystem::file_size(output.name, ignored));
    } catch (const render::AlreadyThere&) {
        throw;
    } catch (const render::Error& error) {
        if (std::find(troubles_.begin(), troubles_.end(), error.what()) == troubles_.end())
            troubles_.emplace_back(error.what());
    } catch (const Stop& stop) {
        if (stop.code() != Exit::interrupted) throw;
        throw Stop(Exit::interrupted, fmt::format("interrupted while {} '{}'{}",
                                                  isPdf(output) ? "printing" : "writing",
                                                  printable(output.name), againLine(options_)));
    }

    void writeFolder(const std::string& name) {
        std::size_t bytes = 0;
        const std::vector<std::filesystem::path> files =
            writeSlidesFolder(deck_, name, options_.overwrite);
        for (const std::filesystem::path& file : files) {
            std::error_code ignored;
            bytes += std::filesystem::file_size(std::filesystem::path(name) / file, ignored);
        }
        tell(name, slides() + ", " + plural(files.size(), "file"), bytes);
    }

    const SlidesOptions& options_;
    Talk talk_;
    const MadeDeck& deck_;
    std::vector<std::string> troubles_;
};

std::string nextOf(const SlidesOutput& output) {
    const std::string name = printable(output.name);
    if (needsBrowser(output)) return "next: open " + name;
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
        fmt::format("{}: {}, {}, {}", printable(deck.name), plural(deck.slides.size(), "slide"),
                    plural(static_cast<std::size_t>(count(Exhibit::film)), "film"),
                    plural(static_cast<std::size_t>(count(Exhibit::still) + count(Exhibit::strip)),
                           "picture")));
    for (const SlidesOutput& output : outputs) talk.say("would write " + printable(output.name));
    return Exit::ok;
}

Exit slides(const SlidesOptions& options) {
    const Deck deck = deckOf(options);
    const std::vector<SlidesOutput> outputs = slidesOutputsOf(options, deck);
    const Talk talk(options, false);
    checkBrowser(outputs, talk);
    if (options.dryRun) return sayPlan(deck, outputs, talk);
    const ScratchFolder scratch;
    const bool moving = !std::all_of(outputs.begin(), outputs.end(), isPdf);
    const MadeDeck made = makeDeck(deck, {scratch.path(), moving, options});
    SlidesWriter writer(options, made);
    for (const SlidesOutput& output : outputs) writer.write(output);
    if (writer.troubles().empty() || !needsBrowser(outputs.front()))
        talk.say(nextOf(outputs.front()));
    if (!writer.troubles().empty())
        throw render::Error(fmt::format("{}", fmt::join(writer.troubles(), "; ")));
    if (!made.incident.empty()) throw Stop(Exit::diverged, made.incident);
    if (!made.compared.empty()) talk.mention(printable(made.compared));
    return Exit::ok;
}

Run addSlides(CLI::App& app) {
    const auto asked = std::make_shared<Asked<SlidesOptions>>();
    auto& options = asked->options;
    auto& texts = asked->texts;
    texts.ofSlides = true;
    addSceneChoice(app, options, texts);
    app.get_option("scene")
        ->expected(1, kMostScenes)
        ->description("a deck file, or scenes whose sections become slides");
    takesAgain(
        app.add_option(
               "-o,--output", options.outputs,
               ".html: one page with everything in it; .pdf: one picture per slide, by Chromium; "
               ".pptx: for PowerPoint and Impress, with films; a folder: page, films, pictures, "
               "notes, for LaTeX (Beamer) and Marp; may be given again; default: "
               "output/<name>.html")
            ->type_name("OUT"));
    addSeconds(app, options);
    app.add_option(
           "--size", texts.size,
           "pixels of a picture that fills a slide, even, 64..8192 a side; default: the deck's, "
           "else 1280x720")
        ->type_name("WxH");
    app.add_option("--fps", options.fps, "frames per second of films; default: the deck's, else 30")
        ->type_name("N");
    app.add_option("--samples", options.samples,
                   "samples per pixel at edges: 1, 2, 4, 8 or 16; default: 4")
        ->type_name("N");
    app.add_option("--theme", options.theme,
                   "studio, dark or print; default: the deck's, else studio")
        ->type_name("NAME");
    addJobs(app, options);
    app.add_flag("-n,--dry-run", options.dryRun,
                 "print what the deck holds and what would be written; draw nothing; default: off");
    addRenderer(app, options);
    app.add_flag("--overwrite", options.overwrite,
                 "replace existing files; in a folder, those that slides made; default: off");
    addFeedback(app, options);
    return [asked](const std::string& commandLine) { return slides(settled(*asked, commandLine)); };
}

}  // namespace

Command slidesCommand() {
    return {"slides",
            "a talk from scenes or a deck file: a page with films and notes, PDF, .pptx, a folder",
            {"impulse slides stack wall -o talk.html",
             "impulse slides talk.toml -o talk.html -o talk.pdf -o talk.pptx",
             "impulse slides talk.toml -o talk/ --theme dark --overwrite"},
            addSlides};
}

}  // namespace demos

#endif
