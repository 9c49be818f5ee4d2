#include <gtest/gtest.h>

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

TEST(Text, LeavingThePictureIsCutOff) {
    Image image = grey(60, 40);
    Frame frame;
    frame.texts.push_back({"a line that is much too long for this", Corner::topLeft, 200});
    EXPECT_NO_THROW(drawTexts(image, frame));
}

}  // namespace
}  // namespace render
