#include <gtest/gtest.h>

#include "render/canvas.h"
#include "render/corners.h"
#include "render/formula_lines.h"
#include "render/overlay.h"

namespace render {
namespace {

Image grey(int width, int height) {
    Image image;
    image.width = width, image.height = height;
    image.pixels.assign(4u * static_cast<std::size_t>(width) * height, 200);
    return image;
}

void drawTexts(Image& image, const Frame& frame) {
    const View view = makeView(frame.camera, 1.0f);
    drawTexts(image, frame, view, DepthMap{});
}

/// Pixels that are clearly dark, in the quarter of the picture given by its corner.
int ink(const Image& image, bool right, bool bottom) {
    int count = 0;
    for (int y = bottom ? image.height / 2 : 0; y < (bottom ? image.height : image.height / 2); ++y)
        for (int x = right ? image.width / 2 : 0; x < (right ? image.width : image.width / 2); ++x)
            count += image.at(x, y)[0] < 100;
    return count;
}

/// A bar of 2 em with a letter above it.
Formula barWithLetter() {
    Formula formula;
    formula.width = 2.0f;
    formula.ascent = 1.5f;
    formula.letters.push_back({'x', 0.7f, 0.8f});
    formula.strokes.push_back({{{0.0f, 0.5f}, {2.0f, 0.5f}}});
    return formula;
}

TEST(Text, FormulasStandBetweenWordsAndMakeLinesHigher) {
    const Formula formula = barWithLetter();
    const std::string line = "a \xf3\xb0\x80\x80 b";  // kFirstFormula
    EXPECT_NEAR(lineWidth(line, {&formula, 1}, 24),
                textWidth("a ", 24) + textWidth(" b", 24) + 2.0f * 24.0f * static_cast<float>(kEmShare), 0.01f);
    EXPECT_GT(lineReach(line, {&formula, 1}, 24).above, 10.0f);
    EXPECT_EQ(lineReach("a b", {&formula, 1}, 24).above, 0.0f);
    Frame frame;
    frame.texts.push_back({"a b", Corner::bottomLeft, 24.0f});
    frame.texts[0].plate = true;
    const float plain = layoutCorners(frame, 1280, 720).texts.at(0).box.height;
    frame.texts[0].text = line;
    frame.texts[0].formulas = {formula};
    const PlacedText placed = layoutCorners(frame, 1280, 720).texts.at(0);
    EXPECT_GT(placed.box.height, plain + 10.0f);
    Image image = grey(1280, 720);
    drawTexts(image, frame);
    int above = 0;  // in the rows of the formula's letter
    for (int y = static_cast<int>(placed.box.y); y < static_cast<int>(placed.box.y + placed.pad + placed.above); ++y)
        for (int x = 0; x < 1280; ++x) above += image.at(x, y)[0] < 100;
    EXPECT_GT(above, 10);
}

TEST(Text, LinesBreakBesideFormulasNotInThem) {
    const Formula formula = barWithLetter();
    const std::string mark = "\xf3\xb0\x80\x80";
    const std::vector<std::string> lines =
        brokenText("one two " + mark + " three", 24, textWidth("one two ", 24), {&formula, 1});
    ASSERT_GE(lines.size(), 2u);
    EXPECT_EQ(lines[0], "one two");
    EXPECT_EQ(lines[1].substr(0, 4), mark);
}

TEST(Text, HasInkAtEverySizeOfPicture) {
    for (const int height : {270, 480, 720, 2160}) {
        Image image = grey(height * 16 / 9, height);
        Frame frame;
        frame.texts.push_back({"t = 0.000 s", Corner::topLeft, 19});
        drawTexts(image, frame);
        EXPECT_GT(ink(image, false, false), 15 * height / 270) << height;
        EXPECT_EQ(ink(image, true, true), 0);
    }
}

TEST(Text, GoesToItsCornerAndLinesDoNotOverlap) {
    Image image = grey(640, 360);
    Frame frame;
    frame.texts.push_back({"one", Corner::bottomRight, 20});
    drawTexts(image, frame);
    const int one = ink(image, true, true);
    EXPECT_GT(one, 0);
    Image two = grey(640, 360);
    frame.texts.push_back({"one", Corner::bottomRight, 20});
    drawTexts(two, frame);
    EXPECT_EQ(ink(two, true, true), 2 * one);
}

TEST(Text, IsWiderWhenLongerAndSurvivesBrokenUtf8) {
    EXPECT_GT(textWidth("impulse", 20), textWidth("imp", 20));
    EXPECT_NEAR(textWidth("\xff", 20), textWidth("?", 20), 1e-3);
    EXPECT_NEAR(textWidth("\xce", 20), textWidth("?", 20), 1e-3);
    EXPECT_NE(textWidth("λ", 20), textWidth("?", 20));
}

TEST(Text, RunningNumbersDoNotJitter) {
    for (const float pixels : {11.0f, 18.0f, 37.0f})
        for (const char one : std::string("0123456789"))
            EXPECT_EQ(textWidth(std::string(5, one), pixels, Figures::tabular),
                      textWidth("00000", pixels, Figures::tabular))
                << one;
    EXPECT_LT(textWidth("11111", 37), textWidth("00000", 37));  // in words they keep their own
}

/// A character that no font has is drawn as a box, as wide as that of U+10FFFD.
TEST(Text, BothFontsTogetherHaveWhatCaptionsNeed) {
    for (const std::string sign :
         {"ω", "α", "μ", "π", "Δ", "é", "Ж", "°", "²", "⁻", "₀", "½", "′", "…", "–", "−", "×", "·",
          "√", "≤", "≈", "≠", "∞", "→", "⇒", "∝", "∥", "⊥", "∈", "∂", "∑", "∫"}) {
        Image one = grey(64, 64), none = grey(64, 64);
        drawLabel(one, sign, {8, 48}, Anchor::start, 40, {});
        drawLabel(none, "\xf4\x8f\xbf\xbd", {8, 48}, Anchor::start, 40, {});
        EXPECT_NE(one.pixels, none.pixels) << sign;
        EXPECT_NE(one.pixels, grey(64, 64).pixels) << sign;
    }
}

/// A caption's letters keep their contrast over black and over white.
TEST(Text, APlateIsLegibleOnEveryBackground) {
    for (const int level : {0, 120, 255}) {
        Image image = grey(640, 360);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            if (i % 4 != 3) image.pixels[i] = static_cast<unsigned char>(level);
        Frame frame;
        frame.texts.push_back({"caption", Corner::bottomLeft, 24});
        frame.texts[0].plate = true;
        drawTexts(image, frame);
        const PlacedText placed = layoutCorners(frame, 640, 360).texts.at(0);
        const int x = static_cast<int>(placed.box.x + placed.pad / 2);
        const int y = static_cast<int>(placed.box.y + placed.box.height / 2);
        EXPECT_GT(image.at(x, y)[0], 200) << level;
    }
}

TEST(Text, NamesHaveAWideHalo) {
    for (const int level : {0, 255}) {
        Image image = grey(200, 60);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            if (i % 4 != 3) image.pixels[i] = static_cast<unsigned char>(level);
        drawHaloed(image, "l", 15, 100.0f, 40.0f, {0.1f, 0.1f, 0.11f, 1});
        int light = 0, dark = 0;  // in a row through the letter
        for (int x = 90; x < 115; ++x) {
            light += image.at(x, 33)[0] > 150;
            dark += image.at(x, 33)[0] < 100;
        }
        EXPECT_GE(light, 4) << level;
        EXPECT_GE(dark, 1) << level;
    }
}

TEST(Text, LeavingThePictureIsCutOff) {
    Image image = grey(60, 40);
    Frame frame;
    frame.texts.push_back({"a line that is much too long for this", Corner::topLeft, 200});
    EXPECT_NO_THROW(drawTexts(image, frame));
}

}  // namespace
}  // namespace render
