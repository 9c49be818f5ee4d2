#include <fmt/format.h>

#include "demos/slides/deck_files.h"
#include "demos/slides/measured_slide.h"
#include "demos/slides/pptx.h"
#include "demos/slides/pptx_parts.h"
#include "demos/slides/pptx_slide.h"
#include "demos/slides/slide_media.h"
#include "demos/text/complaints.h"
#include "demos/text/file_content.h"
#include "render/encode/file.h"
#include "render/error.h"

namespace demos {
namespace {

class PptxWriter {
public:
    explicit PptxWriter(const MadeDeck& deck) : deck_(deck) {
        addPptxParts(deck.deck, deck.slides.size(), package_);
    }

    void add(const MadeSlide& made, const MeasuredSlide& measured) {
        ++number_;
        PptxRelations relations;
        relations.add("slideLayout", fmt::format("../slideLayouts/slideLayout{}.xml",
                                                 made.slide.opening ? 2 : 1));
        const bool notes = !made.slide.notes.empty() || !made.command.empty();
        if (notes)
            relations.add("notesSlide", fmt::format("../notesSlides/notesSlide{}.xml", number_));
        const std::string xml = pptxSlideXml(
            deck_.deck, made, measured, filesOf(made), relations,
            [this](const MeasuredFormula& formula) { return addMedia("png", formula.png); });
        package_.add(fmt::format("ppt/slides/slide{}.xml", number_), xml, "slide", relations);
        if (notes) addNotes(made);
    }

    std::vector<std::uint8_t> bytes() const { return package_.bytes(); }

private:
    /// Its name as a slide sees it.
    std::string addMedia(const char* ending, std::vector<std::uint8_t> bytes) {
        const std::string name = fmt::format("media/{}{}.{}", ending[0] == 'p' ? "image" : "film",
                                             ++media_, ending);
        package_.addBytes("ppt/" + name, std::move(bytes));
        return "../" + name;
    }

    PptxSlideFiles filesOf(const MadeSlide& made) {
        PptxSlideFiles files;
        if (hasFilm(made)) {
            std::vector<std::uint8_t> film = contentOf(made.film->file);
            if (film.empty())
                throw render::Error("cannot read '" + made.film->file.string() + "'");
            files.film = addMedia("mp4", std::move(film));
        }
        for (const MadePicture* picture : picturesOf(made))
            files.pictures.push_back(addMedia("png", picture->png));
        return files;
    }

    void addNotes(const MadeSlide& made) {
        PptxRelations relations;
        relations.add("notesMaster", "../notesMasters/notesMaster1.xml");
        relations.add("slide", fmt::format("../slides/slide{}.xml", number_));
        const std::string xml = pptxNotesXml(made, relations);
        package_.add(fmt::format("ppt/notesSlides/notesSlide{}.xml", number_), xml, "notesSlide",
                     relations);
    }

    const MadeDeck& deck_;
    PptxPackage package_;
    std::size_t number_ = 0, media_ = 0;
};

std::vector<MeasuredSlide> measuredFor(const std::filesystem::path& file, const MadeDeck& deck) {
    const std::string program = pdfBrowser();
    if (program.empty())
        throw render::Error(
            "chromium is needed for a .pptx; install it (apt install chromium)");
    try {
        return measuredSlides(deck, program);
    } catch (const render::Error& error) {
        throw render::Error(
            fmt::format("no '{}': {} {}", printable(file.string()), program, error.what()));
    }
}

}  // namespace

std::vector<std::uint8_t> pptxOf(const MadeDeck& deck, const std::vector<MeasuredSlide>& measured) {
    PptxWriter writer(deck);
    for (std::size_t i = 0; i < deck.slides.size(); ++i) writer.add(deck.slides[i], measured[i]);
    return writer.bytes();
}

void writeSlidesPptx(const MadeDeck& deck, const std::filesystem::path& file, render::Existing existing) {
    render::checkReplaceable(file);
    const std::vector<MeasuredSlide> measured = measuredFor(file, deck);
    render::makeFolder(file.parent_path());
    render::writeFileAtomically(file, pptxOf(deck, measured), existing);
}

}  // namespace demos
