// A .pptx that Chromium laid out, as LibreOffice shows it: the same as the PDF, slide by slide.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "demos/slides/deck_files.h"
#include "render/encode/program_path.h"
#include "tests/pages/browser.h"
#include "tests/support/planted_deck.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/unzipped.h"

namespace {

using namespace demos;

class PptxInPrograms : public testing::Test {
protected:
    void SetUp() override {
        support::saved(folder_ / "film", std::string("not a film, but bytes"));
        deck_ = support::plantedDeck(folder_ / "film");
        for (const int film : {1, 2})
            deck_.slides[film].film->poster = support::plantedDeckPicture(640, 360, 60);
        deck_.slides[2].pictures[0] = support::plantedDeckPicture(640, 360, 130);
    }
    bool sh(const std::string& command) const {
        return std::system(("cd '" + folder_.path().string() + "' && " + command).c_str()) == 0;
    }
    /// The grey levels of a slide, 80 x 45 of them. `of`: pages.pdf as pictures pages-1.pgm ...
    std::string levels(const std::string& of, int slide) const {
        const std::string text =
            support::contentOf(folder_ / (of + "-" + std::to_string(slide) + ".pgm"));
        return text.size() < 3600 ? "" : text.substr(text.size() - 3600);
    }
    support::TemporaryFolder folder_;
    MadeDeck deck_;
};

/// How much two pictures differ: levels of grey, on average.
double difference(const std::string& one, const std::string& other) {
    if (one.size() != other.size() || one.empty()) return 255.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        sum += std::abs(static_cast<unsigned char>(one[i]) - static_cast<unsigned char>(other[i]));
    return sum / static_cast<double>(one.size());
}

TEST_F(PptxInPrograms, TwiceTheSameBytesAndInLibreOfficeWhatThePdfShows) {
    writeSlidesPptx(deck_, folder_ / "deep/again.pptx", render::Existing::kept);
    writeSlidesPptx(deck_, folder_ / "theirs.pptx", render::Existing::kept);
    const std::string bytes = support::contentOf(folder_ / "theirs.pptx");
    EXPECT_EQ(support::contentOf(folder_ / "deep/again.pptx"), bytes);
    const auto parts = support::unzipped({bytes.begin(), bytes.end()});
    const support::Bytes& slide = parts.at("ppt/slides/slide4.xml");
    const std::string words(slide.begin(), slide.end());
    EXPECT_NE(words.find("name=\"Formula\" descr=\"\\lambda = -\\frac{J"), std::string::npos);
    EXPECT_GT(parts.at("ppt/media/image6.png").size(), 3000u);  // a formula drawn

    for (const char* program : {"soffice", "pdftoppm"})
        if (!render::programPath(program))
            GTEST_SKIP() << "no " << program << ": install libreoffice-impress and poppler-utils";
    writeSlidesPdf(deck_, folder_ / "ours.pdf", render::Existing::kept);
    ASSERT_TRUE(sh("timeout 120 soffice -env:UserInstallation=file://$PWD/office --headless "
                   "--convert-to pdf theirs.pptx > office.txt 2>&1"));
    for (const char* pdf : {"ours", "theirs"})
        ASSERT_TRUE(sh("pdftoppm -gray -scale-to-x 80 -scale-to-y 45 " + std::string(pdf) +
                       ".pdf " + pdf));
    for (int i = 1; i <= 4; ++i) {
        const double own = difference(levels("ours", i), levels("theirs", i));
        EXPECT_LT(own, 8.0) << "slide " << i;  // 1 to 5: the letters and so the places differ
        for (int other = 1; other <= 4; ++other)
            if (other != i) {
                EXPECT_LT(own, difference(levels("ours", other), levels("theirs", i)))
                    << "slide " << i << " looks more like " << other;
            }
    }
    EXPECT_TRUE(levels("theirs", 5).empty());
}

}  // namespace
