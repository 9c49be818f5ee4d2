// A .pptx as a package: its parts are well-formed and have types and relationships; its slides.
// tests/pages makes one in a browser and opens it in LibreOffice.
#include "demos/slides/pptx.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <pugixml.hpp>
#include <set>

#include "demos/text/page_text.h"
#include "render/error.h"
#include "tests/support/planted_deck.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"
#include "tests/support/unzipped.h"

namespace demos::test {
namespace {

using support::count;

const SlideBox kBox{60.0, 120.0, 400.0, 300.0};
const MeasuredWords kWords{kBox, 27.0, 38.0, false};

/// All parts of a slide at one place.
MeasuredSlide measuredAlike(const MadeSlide& made) {
    MeasuredSlide measured;
    measured.title = measured.caption = measured.code = {kWords};
    measured.under = {kWords, kWords};
    measured.blocks = {{kWords, {}}};
    for (const std::string& tex : made.slide.formulas)
        measured.formulas.push_back({kBox, tex, {1, 2, 3}});
    for (const MadeTable& table : made.tables)
        measured.tables.push_back({kWords, std::vector<double>(table.head.size(), 90.0),
                                   std::vector<double>(table.rows.size() + 1, 30.0)});
    measured.pictures.assign(made.pictures.size() + (made.film ? 1 : 0), kBox);
    return measured;
}

class Pptx : public testing::Test {
protected:
    Pptx() {
        support::saved(folder_ / "film", std::string("not a film, but bytes"));
        deck_ = support::plantedDeck(folder_ / "film");
    }
    std::vector<std::uint8_t> bytes() const {
        std::vector<MeasuredSlide> measured;
        for (const MadeSlide& made : deck_.slides) measured.push_back(measuredAlike(made));
        return pptxOf(deck_, measured);
    }
    /// The texts of the parts by their names.
    std::map<std::string, std::string> parts() const {
        std::map<std::string, std::string> texts;
        for (const auto& [name, content] : support::unzipped(bytes()))
            texts[name] = std::string(content.begin(), content.end());
        return texts;
    }
    std::string slide(int number) const {
        return parts().at("ppt/slides/slide" + std::to_string(number) + ".xml");
    }
    support::TemporaryFolder folder_;
    MadeDeck deck_;
};

bool isXml(const std::string& name) { return name.ends_with(".xml") || name.ends_with(".rels"); }

TEST_F(Pptx, EveryPartIsWellFormedAndHasAType) {
    const auto all = parts();
    const std::string types = all.at("[Content_Types].xml");
    for (const auto& [name, text] : all) {
        pugi::xml_document document;
        if (isXml(name)) {
            EXPECT_TRUE(document.load_string(text.c_str())) << name;
        }
        const bool byEnding = name.ends_with(".rels") || name.ends_with(".png") ||
                              name.ends_with(".mp4") || name == "[Content_Types].xml";
        EXPECT_EQ(count(types, "PartName=\"/" + name + "\""), byEnding ? 0 : 1) << name;
    }
    for (const char* ending : {"rels", "png", "mp4"})
        EXPECT_EQ(count(types, "Extension=\"" + std::string(ending) + "\""), 1) << ending;
    EXPECT_EQ(count(types, "PartName"), count(types, "ContentType") - 4);
}

/// Every target is there, every part is somebody's target, and every rId in use is declared.
TEST_F(Pptx, RelationshipsLeadToEveryPart) {
    const auto all = parts();
    std::set<std::string> reached{"[Content_Types].xml"};
    for (const auto& [name, text] : all) {
        if (!name.ends_with(".rels")) continue;
        reached.insert(name);
        const std::filesystem::path folder =
            std::filesystem::path(name).parent_path().parent_path();
        pugi::xml_document document;
        ASSERT_TRUE(document.load_string(text.c_str()));
        for (const pugi::xml_node one : document.child("Relationships").children()) {
            if (one.attribute("TargetMode")) continue;
            const std::string target =
                (folder / one.attribute("Target").value()).lexically_normal().string();
            EXPECT_EQ(all.count(target), 1u) << name << " -> " << target;
            reached.insert(target);
        }
        const auto part = all.find((folder / std::filesystem::path(name).stem()).string());
        if (part == all.end()) continue;
        for (std::size_t at = part->second.find("=\"rId"); at != std::string::npos;
             at = part->second.find("=\"rId", at + 1)) {
            const std::string id =
                part->second.substr(at + 2, part->second.find('"', at + 2) - at - 2);
            EXPECT_EQ(count(text, "Id=\"" + id + "\""), 1) << part->first << " " << id;
        }
    }
    for (const auto& [name, text] : all) EXPECT_EQ(reached.count(name), 1u) << name;
}

TEST_F(Pptx, FilmsAreWithinAndStartByAClick) {
    const auto all = parts();
    EXPECT_EQ(all.at("ppt/media/film1.mp4"), "not a film, but bytes");
    const std::string film = slide(3), still = slide(4);
    EXPECT_EQ(count(film, "<a:videoFile r:link="), 1);
    EXPECT_EQ(count(film, "<p14:media "), 1);
    EXPECT_EQ(count(film, "cmd=\"togglePause\""), 1);
    EXPECT_EQ(count(film, "evt=\"onClick\""), 2);
    EXPECT_EQ(count(film, "repeatCount=\"indefinite\""), 1);
    EXPECT_EQ(count(slide(2), "repeatCount"), 0);  // it does not loop
    EXPECT_EQ(count(still, "<p:timing>") + count(still, "videoFile"), 0);
    const std::size_t at = film.find("name=\"Film\" descr=\"a grey field\"");
    ASSERT_NE(at, std::string::npos);
    const std::size_t id = film.rfind("id=\"", at) + 4;  // the shape that the click is about
    EXPECT_EQ(count(film, "spid=\"" + film.substr(id, film.find('"', id) - id) + "\""), 4);
}

TEST_F(Pptx, WordsAreTextAndFormulasPicturesWithTheirLatex) {
    const std::string words = slide(4);
    EXPECT_EQ(count(words, "<p:ph type=\"title\"/>"), 1);
    EXPECT_EQ(count(words, "<a:t>Words</a:t>"), 1);
    EXPECT_EQ(count(words, "<a:t>    solve(row)  # {50%}</a:t>"), 1);
    EXPECT_EQ(
        count(words, "name=\"Formula\" descr=\"\\lambda = -\\frac{J v + b}{J M^{-1} J^T}\""), 1);
    EXPECT_EQ(count(words, " b=\"1\" dirty=\"0\"><a:solidFill><a:schemeClr val=\"tx1\"/>"
                           "</a:solidFill><a:latin typeface=\"+mn-lt\"/></a:rPr><a:t>v</a:t>"),
              1);
    EXPECT_EQ(count(words, "<a:tr "), 3);
    EXPECT_EQ(count(words, "<a:t>a_b &amp; c</a:t>"), 1);
    EXPECT_EQ(count(slide(1), "<p:ph type=\"ctrTitle\"/>"), 1);
    EXPECT_EQ(count(slide(3), "<a:buChar char=\"•\"/>"), 2);
    EXPECT_EQ(count(slide(2), "<a:t>λ</a:t>"), 1);  // its caption
}

TEST_F(Pptx, NotesAreBesideTheirSlide) {
    const auto all = parts();
    EXPECT_EQ(count(all.at("ppt/notesSlides/notesSlide1.xml"), "<a:t>calm</a:t>"), 1);
    EXPECT_EQ(count(all.at("ppt/notesSlides/notesSlide2.xml"), "impulse render stack"), 1);
    EXPECT_EQ(all.count("ppt/notesSlides/notesSlide3.xml"), 0u);  // nothing to say
    EXPECT_EQ(count(all.at("ppt/notesSlides/_rels/notesSlide2.xml.rels"), "slides/slide2.xml"), 1);
}

TEST_F(Pptx, ItsThemeIsThatOfThePage) {
    const std::string style = slidesPageText().before;
    for (const char* theme : {"studio", "dark", "print"}) {
        deck_.deck.theme = theme;
        const std::string text = parts().at("ppt/theme/theme1.xml");
        const std::size_t at = text.find("<a:accent1><a:srgbClr val=\"") + 27;
        EXPECT_GE(count(style, "--accent: #" + text.substr(at, 6) + ";"), 1) << theme;
    }
}

TEST_F(Pptx, NothingBreaksOutOfItsPlace) {
    const std::string hostile = "</a:t></p:sld>\" <!-- & ]]> \x01 'x'";
    for (MadeSlide& made : deck_.slides) {
        made.slide.title = made.slide.text = made.slide.code = made.slide.caption = hostile;
        made.slide.notes = made.command = hostile;
        if (made.film) made.film->poster.says = hostile;
    }
    deck_.deck.author = hostile;
    for (const auto& [name, text] : parts()) {
        pugi::xml_document document;
        if (!isXml(name)) continue;
        EXPECT_TRUE(document.load_string(text.c_str())) << name;
        EXPECT_EQ(count(text, "\x01"), 0) << name;
    }
}

TEST_F(Pptx, TheSameDeckGivesTheSameBytes) { EXPECT_EQ(bytes(), bytes()); }

TEST_F(Pptx, AFilmThatIsGoneIsAnError) {
    std::filesystem::remove(folder_ / "film");
    EXPECT_THROW(bytes(), render::Error);
}

}  // namespace
}  // namespace demos::test
