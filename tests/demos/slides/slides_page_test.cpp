// The page of a talk as text: it holds everything, requests nothing, and nothing breaks out of its
// place. tests/pages tests how it behaves.
#include <gtest/gtest.h>

#include "demos/slides/deck_files.h"
#include "demos/slides/linked_page.h"
#include "demos/slides/math_font.h"
#include "demos/slides/table_columns.h"
#include "demos/text/base64.h"
#include "render/error.h"
#include "tests/support/planted_deck.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace {

using namespace demos;
using support::count;
using support::plantedDeck;

class SlidesPage : public testing::Test {
protected:
    SlidesPage() { support::saved(folder_ / "film", std::string("not a film, but bytes")); }
    MadeDeck deck() const { return plantedDeck(folder_ / "film"); }
    support::TemporaryFolder folder_;
};

TEST_F(SlidesPage, HoldsEverySlideItsFilmsAndItsPictures) {
    const MadeDeck made = deck();
    const std::string page = slidesPage(made);
    EXPECT_EQ(count(page, "<article class=\"leaf\">"), 4);
    EXPECT_EQ(count(page, "data:video/mp4;base64,bm90IGEgZmlsbSwgYnV0IGJ5dGVz"), 2);
    EXPECT_EQ(count(page, "data:image/png;base64," + toBase64(made.slides[1].film->poster.png)), 2);
    EXPECT_EQ(count(page, "src=\"data:image/svg+xml;base64,"), 1);
    EXPECT_EQ(count(page, toBase64(made.slides[2].pictures[0].png)), 0);  // SVG is used instead
    EXPECT_EQ(count(page, "data-frames=\"24\" data-first=\"2\" data-step=\"0.01\""), 2);
    EXPECT_EQ(count(page, "<title>A talk</title>"), 1);
    EXPECT_EQ(count(page, "<code>impulse render stack</code>"), 1);
}

TEST_F(SlidesPage, ForbidsAllButItsOwn) {
    const std::string page = slidesPage(deck());
    EXPECT_EQ(count(page, "default-src 'none'; img-src data:; media-src data:; "), 1);
    EXPECT_EQ(count(page, "https:"), 0);
    EXPECT_EQ(count(page, "http:"), count(page, "=\"http://www.w3.org/1998/Math/MathML\""));
    EXPECT_EQ(count(page, " src=\""), count(page, " src=\"data:"));
}

TEST_F(SlidesPage, LeavesNoMarkOfItsMaking) {
    const std::string page = slidesPage(deck());
    for (const char* mark : {"@title@", "@sources@", "@font@", "@inks@", "@theme@", "@data@"})
        EXPECT_EQ(count(page, mark), 0) << mark;
}

TEST_F(SlidesPage, NothingBreaksOutOfItsPlace) {
    const std::string hostile =
        "</title></script><script>alert(1)</script>\"' onload=x <!-- @font@";
    const std::string harmless = slidesPage(deck());
    MadeDeck made = deck();
    made.deck.title = made.deck.subtitle = made.deck.author = made.deck.date = hostile;
    for (MadeSlide& slide : made.slides) {
        for (std::string* words : {&slide.slide.title, &slide.slide.text, &slide.slide.code,
                                   &slide.slide.caption, &slide.slide.notes, &slide.command})
            *words = hostile;
        if (slide.film) slide.film->poster.says = hostile;
        for (MadePicture& picture : slide.pictures) picture.says = hostile;
        for (MadeTable& table : slide.tables) table.rows[0][0] = table.head[0] = hostile;
    }
    const std::string page = slidesPage(made);
    for (const char* word : {"<script", "</script", "</title", "<!--", "\" onload"})
        EXPECT_EQ(count(page, word), count(harmless, word)) << word;
    EXPECT_GT(count(page, "&lt;script&gt;alert(1)"), 20);
}

TEST_F(SlidesPage, PutsWordsBesideAPictureAndAPictureAlone) {
    MadeDeck made = deck();
    made.slides.push_back(support::plantedSlide("05-strip", "A strip"));
    made.slides.back().slide.text = "above";
    made.slides.back().pictures.push_back(support::plantedDeckPicture(300, 50, 90));
    made.slides.push_back(made.slides.back());
    made.slides.back().pictures = {support::plantedDeckPicture(60, 50, 90)};
    made.slides.push_back(made.slides.back());
    made.slides.back().slide.code = "wide";
    const std::string page = slidesPage(made);
    const char* layouts[] = {"opening", "full", "below", "plain", "below", "beside", "beside even"};
    std::size_t at = 0;
    for (const char* layout : layouts) {
        at = page.find("<section class=\"slide ", at) + 22;
        EXPECT_EQ(page.substr(at, page.find('"', at) - at), layout);
    }
    EXPECT_EQ(count(page, "style=\"--aspect:1.77778;--rows:1;--columns:2\""), 1);
}

TEST_F(SlidesPage, CarriesAFontForItsFormulasOnly) {
    MadeDeck made = deck();
    const int fonts = mathFont().empty() ? 0 : 1;
    EXPECT_EQ(count(slidesPage(made), "@font-face"), fonts);
    made.slides.resize(1);
    EXPECT_EQ(count(slidesPage(made), "@font-face"), 0);
}

TEST_F(SlidesPage, SaysInItsHeadWhatItIsAndByWhom) {
    MadeDeck made = deck();
    made.deck.title = "Why *all* $\\lambda \\ge 0$";
    made.deck.author = "S. \"T\" & Co";
    EXPECT_EQ(count(slidesPage(made),
                    "<title>Why all λ≥0</title>\n<meta name=\"author\" "
                    "content=\"S. &quot;T&quot; &amp; Co\">"),
              1);
    made.deck.author.clear();
    EXPECT_EQ(count(slidesPage(made), "name=\"author\""), 0);
}

TEST_F(SlidesPage, AFilmThatIsGoneIsAnError) {
    std::filesystem::remove(folder_ / "film");
    EXPECT_THROW(slidesPage(deck()), render::Error);
}

TEST_F(SlidesPage, AFolderLinksWhatLiesBesideIt) {
    const std::string page = linkedSlidesPage(deck());
    EXPECT_EQ(count(page, "media-src 'self' file:; "), 1);
    EXPECT_EQ(count(page, "data-film=\"media/02-waits.mp4\""), 1);
    EXPECT_EQ(count(page, "src=\"media/03-loops.png\""), 1);
    EXPECT_EQ(count(page, "src=\"media/03-loops-2.svg\""), 1);
    EXPECT_EQ(count(page, "data:image"), 0);
    EXPECT_EQ(count(page, "data:video"), 0);
}

TEST(NumberColumns, AreThoseWhoseCellsAreNumbersWithUnits) {
    const MadeTable table{
        {"case", "drift", "turn", "none", "which"},
        {{"20 sweeps", "12.3 mm", "-1e-05 rad/s", "", "4"}, {"a", "-", "3", "-", "b"}}};
    EXPECT_EQ(numberColumns(table), (std::vector<bool>{false, true, true, false, false}));
}

}  // namespace
