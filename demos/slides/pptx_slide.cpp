#include "demos/slides/pptx_slide.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/slides/pptx_shapes.h"
#include "demos/slides/pptx_text.h"
#include "demos/slides/slide_media.h"

namespace demos {
namespace {

constexpr double kSlack = 10.0;  // px: another program's letters may be a little wider

PptxLook lookOf(const MeasuredWords& words, const char* color = "tx1") {
    PptxLook look{words.size, words.line};
    look.color = color;
    look.align = words.centered ? "ctr" : "l";
    return look;
}

SlideBox withSlack(SlideBox box) {
    box.width += kSlack;
    return box;
}

class SlideWriter {
public:
    SlideWriter(const MadeSlide& made, const MeasuredSlide& measured, const PptxSlideFiles& files,
                PptxRelations& relations,
                const std::function<std::string(const MeasuredFormula&)>& formula)
        : made_(made), measured_(measured), files_(files), relations_(relations),
          formula_(formula) {}

    std::string write(const Deck& deck) {
        if (made_.slide.opening)
            addOpening(deck);
        else
            addTitle(made_.slide.title, "title");
        addBlocks();
        addCode();
        for (const MeasuredFormula& formula : measured_.formulas) addFormula(formula);
        for (std::size_t i = 0; i < std::min(made_.tables.size(), measured_.tables.size()); ++i)
            shapes_.addTable(made_.tables[i], measured_.tables[i]);
        const std::string timing = addPictures();
        addCaption();
        return fmt::format(
            "<p:sld {}><p:cSld><p:spTree><p:nvGrpSpPr><p:cNvPr id=\"1\" name=\"\"/>"
            "<p:cNvGrpSpPr/><p:nvPr/></p:nvGrpSpPr><p:grpSpPr/>{}</p:spTree></p:cSld>"
            "<p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr>{}</p:sld>",
            kPptxSpaces, shapes_.xml(), timing);
    }

private:
    std::string line(const std::string& words, const PptxLook& look) {
        return pptxParagraphs({pptxLine(words, look, link_)}, look);
    }

    void addTitle(const std::string& title, const char* placeholder) {
        if (title.empty() || measured_.title.empty()) return;
        PptxLook look = lookOf(measured_.title.front());
        look.bold = true;
        shapes_.addText("Title", measured_.title.front().box, line(title, look), placeholder);
    }

    void addOpening(const Deck& deck) {
        if (!measured_.title.empty()) {
            const SlideBox& title = measured_.title.front().box;
            shapes_.addRectangle({title.x, title.y - 41.0, 84.0, 7.0}, {"accent1", 1.0});
        }
        addTitle(made_.slide.title.empty() ? deck.title : made_.slide.title, "ctrTitle");
        auto under = measured_.under.begin();
        if (!deck.subtitle.empty() && under != measured_.under.end()) {
            const PptxLook look = lookOf(*under, "tx2");
            shapes_.addText("Subtitle", withSlack(under->box), line(deck.subtitle, look));
            ++under;
        }
        if (under == measured_.under.end()) return;
        const std::string between = deck.author.empty() || deck.date.empty() ? "" : " · ";
        const PptxLook look = lookOf(*under);
        const double above = under->box.height - under->line;  // padding
        shapes_.addText(
            "Author", {under->box.x, under->box.y + above, under->box.width, under->line},
            pptxParagraphs({pptxPlainLine(deck.author + between + deck.date, look)}, look));
    }

    void addFormula(const MeasuredFormula& formula) {
        shapes_.addPicture("Formula", formula.box, relations_.add("image", formula_(formula)),
                           formula.tex);
    }

    /// One text of all blocks between two formulas.
    void addBlocks() {
        if (measured_.blocks.empty()) return;
        const PptxLook look = lookOf(measured_.blocks.front().words);
        const auto blocks = pptxBlocks(made_.slide.text, look, link_);
        std::vector<PptxParagraph> group;
        SlideBox box;
        const auto flush = [&] {
            if (!group.empty())
                shapes_.addText("Text", withSlack(box), pptxParagraphs(group, look));
            group.clear();
        };
        for (std::size_t i = 0; i < std::min(blocks.size(), measured_.blocks.size()); ++i) {
            const MeasuredBlock& block = measured_.blocks[i];
            if (block.formula) {
                flush();
                addFormula(*block.formula);
                continue;
            }
            if (group.empty()) box = block.words.box;
            box.height = block.words.box.y + block.words.box.height - box.y;
            group.insert(group.end(), blocks[i].begin(), blocks[i].end());
        }
        flush();
    }

    void addCode() {
        if (made_.slide.code.empty() || measured_.code.empty()) return;
        const MeasuredWords& code = measured_.code.front();
        const SlideBox& box = code.box;
        shapes_.addRectangle(box, {"tx1", 0.05});
        shapes_.addRectangle({box.x, box.y, 4.0, box.height}, {"accent1", 1.0});
        const double side = 1.1 * code.size + 4.0, top = 0.9 * code.size;
        const PptxLook look = lookOf(code);
        shapes_.addText(
            "Code", {box.x + side, box.y + top, box.width - side, box.height - 2.0 * top},
            pptxParagraphs(pptxCode(made_.slide.code, look), look));
    }

    /// Returns how the film starts, if there is one.
    std::string addPictures() {
        const std::vector<const MadePicture*> pictures = picturesOf(made_);
        std::string timing;
        for (std::size_t i = 0; i < std::min(pictures.size(), measured_.pictures.size()); ++i) {
            const SlideBox& box = measured_.pictures[i];
            const std::string picture = relations_.add("image", files_.pictures[i]);
            if (i > 0 || files_.film.empty()) {
                shapes_.addPicture("Picture", box, picture, pictures[i]->says);
                continue;
            }
            const int film =
                shapes_.addFilm(box, picture, relations_.add("video", files_.film),
                                relations_.addMedia(files_.film), pictures[i]->says);
            timing = pptxFilmTiming(film, made_.slide.loop);
        }
        return timing;
    }

    void addCaption() {
        if (made_.slide.caption.empty() || measured_.caption.empty()) return;
        const PptxLook look = lookOf(measured_.caption.front(), "tx2");
        shapes_.addText("Caption", withSlack(measured_.caption.front().box),
                        line(made_.slide.caption, look));
    }

    const MadeSlide& made_;
    const MeasuredSlide& measured_;
    const PptxSlideFiles& files_;
    PptxRelations& relations_;
    const std::function<std::string(const MeasuredFormula&)>& formula_;
    const PptxLink link_ = [this](const std::string& address) {
        return relations_.addLink(address);
    };
    PptxShapes shapes_;
};

}  // namespace

std::string pptxSlideXml(const Deck& deck, const MadeSlide& made, const MeasuredSlide& measured,
                         const PptxSlideFiles& files, PptxRelations& relations,
                         const std::function<std::string(const MeasuredFormula&)>& formula) {
    return SlideWriter(made, measured, files, relations, formula).write(deck);
}

std::string pptxNotesXml(const MadeSlide& made, PptxRelations& relations) {
    PptxLook look{16.0, 20.0};
    const PptxLink link = [&](const std::string& address) { return relations.addLink(address); };
    std::vector<PptxParagraph> paragraphs;
    for (const std::vector<PptxParagraph>& block : pptxBlocks(made.slide.notes, look, link))
        paragraphs.insert(paragraphs.end(), block.begin(), block.end());
    if (!made.command.empty())
        paragraphs.push_back(pptxPlainLine("The picture: " + made.command, look));
    return fmt::format(
        "<p:notes {}><p:cSld><p:spTree><p:nvGrpSpPr><p:cNvPr id=\"1\" name=\"\"/><p:cNvGrpSpPr/>"
        "<p:nvPr/></p:nvGrpSpPr><p:grpSpPr/><p:sp><p:nvSpPr><p:cNvPr id=\"2\" name=\"Slide\"/>"
        "<p:cNvSpPr><a:spLocks noGrp=\"1\" noRot=\"1\" noChangeAspect=\"1\"/></p:cNvSpPr><p:nvPr>"
        "<p:ph type=\"sldImg\"/></p:nvPr></p:nvSpPr><p:spPr/></p:sp><p:sp><p:nvSpPr><p:cNvPr "
        "id=\"3\" name=\"Notes\"/><p:cNvSpPr><a:spLocks noGrp=\"1\"/></p:cNvSpPr><p:nvPr><p:ph "
        "type=\"body\" idx=\"1\"/></p:nvPr></p:nvSpPr><p:spPr/><p:txBody><a:bodyPr/><a:lstStyle/>"
        "{}</p:txBody></p:sp></p:spTree></p:cSld><p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr>"
        "</p:notes>",
        kPptxSpaces, pptxParagraphs(paragraphs, look));
}

}  // namespace demos
