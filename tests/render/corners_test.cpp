// Texts, plates and names do not overlap and stay within the picture, at every size.
#include "render/corners.h"

#include <gtest/gtest.h>

#include "render/camera.h"
#include "render/glyphs.h"

namespace render {
namespace {

Plate plateIn(Corner corner, int rows) {
    Plate plate;
    plate.corner = corner;
    for (int i = 0; i < rows; ++i) plate.rows.push_back({"penetration", "1.62 mm"});
    return plate;
}

/// Something in every corner, and a caption that is much too long for a line.
Frame crowded() {
    Frame frame;
    frame.texts.push_back({"t = 1.750 s   152 bodies   steady, 4 sub-steps"});
    frame.texts.push_back(
        {"400 kg at 17 m/s hit a wall of 150 bricks that nothing but friction "
         "holds together, and what falls lies still after eight seconds",
         Corner::bottomLeft, 24});
    frame.texts.back().plate = true;
    frame.texts.back().heading = "impact";
    frame.texts.push_back({"right", Corner::bottomRight, 20});
    frame.plates = {plateIn(Corner::topRight, 11), plateIn(Corner::topLeft, 5),
                    plateIn(Corner::bottomRight, 2)};
    return frame;
}

std::vector<Box> boxesOf(const CornerLayout& layout) {
    std::vector<Box> boxes;
    for (const PlacedText& text : layout.texts) boxes.push_back(text.box);
    for (const PlacedPlate& plate : layout.plates) boxes.push_back(plate.box);
    return boxes;
}

TEST(Corners, NothingOverlapsOrLeavesThePicture) {
    const Frame frame = crowded();
    for (const auto& [w, h] : {std::pair{480, 270},
                               {640, 360},
                               {1280, 720},
                               {3840, 2160},
                               {720, 1280},
                               {360, 640},
                               {640, 252},
                               {200, 100},
                               {100, 200},
                               {40, 30},
                               {1, 1}}) {
        const std::vector<Box> boxes = boxesOf(layoutCorners(frame, w, h));
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            EXPECT_GE(boxes[i].x, 0.0f) << w << "x" << h;
            EXPECT_GE(boxes[i].y, 0.0f) << w << "x" << h;
            EXPECT_LE(boxes[i].x + boxes[i].width, static_cast<float>(w)) << w << "x" << h;
            EXPECT_LE(boxes[i].y + boxes[i].height, static_cast<float>(h)) << w << "x" << h;
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(boxes[i].overlaps(boxes[k]))
                    << w << "x" << h << ": " << k << ", " << i;
        }
    }
}

TEST(Corners, OrdinaryPicturesHaveRoomForEverything) {
    const Frame frame = crowded();
    for (const auto& [w, h] : {std::pair{640, 360}, {1280, 720}, {3840, 2160}, {720, 1280}}) {
        const CornerLayout layout = layoutCorners(frame, w, h);
        EXPECT_EQ(layout.texts.size(), frame.texts.size()) << w << "x" << h;
        EXPECT_EQ(layout.plates.size(), frame.plates.size()) << w << "x" << h;
    }
}

TEST(Corners, LettersGrowWithThePictureAndStayLegible) {
    const Frame frame = crowded();
    EXPECT_EQ(layoutCorners(frame, 1280, 720).texts[0].pixels, 18);
    EXPECT_EQ(layoutCorners(frame, 3840, 2160).texts[0].pixels, 54);
    EXPECT_EQ(layoutCorners(frame, 720, 1280).texts[0].pixels, 18);
    EXPECT_EQ(layoutCorners(frame, 480, 270).texts[0].pixels, kSmallestText);
}

TEST(Corners, AHeadingIsLeftOutWhereLettersAreSmallest) {
    Frame frame;
    frame.texts.push_back({"400 kg at 17 m/s", Corner::bottomLeft, 24});
    frame.texts.back().heading = "impact";
    for (const auto& [w, h, shown] :
         {std::tuple{1280, 720, true}, {720, 1280, true}, {640, 360, true}, {320, 180, false}}) {
        const PlacedText text = layoutCorners(frame, w, h).texts.at(0);
        EXPECT_EQ(!text.heading.empty(), shown) << w << "x" << h;
        EXPECT_NEAR(text.box.height, text.headingHeight + text.lineHeight, 1e-3f);
    }
}

// A caption of a small picture would hide a fifth of it.
TEST(Corners, APlateIsLeftOutWhereItWouldHideMoreThanAnEighth) {
    Frame frame;
    frame.texts.push_back({"400 kg at 17 m/s", Corner::bottomLeft, 24});
    frame.texts.back().plate = true;
    const auto isShown = [&frame](int width, int height) {
        return !layoutCorners(frame, width, height).texts.empty();
    };
    EXPECT_TRUE(isShown(1280, 720));
    EXPECT_TRUE(isShown(480, 270));
    EXPECT_TRUE(isShown(180, 320));
    EXPECT_FALSE(isShown(320, 180));
    EXPECT_FALSE(isShown(256, 144));
    EXPECT_FALSE(isShown(192, 108));
    frame.look.unit = 1.0f;  // letters of a given size
    EXPECT_TRUE(isShown(256, 144));
    frame.look.unit = 0.0f;
    frame.texts[0].needed = true;  // the label of a panel
    EXPECT_TRUE(isShown(160, 90));
    frame.texts[0].needed = frame.texts[0].plate = false;
    EXPECT_TRUE(isShown(256, 144));
}

TEST(Corners, LongTextsAreBrokenBetweenWords) {
    const std::string text = "one two three four five six";
    const float room = textWidth("one two three", 20) + 1.0f;
    const std::vector<std::string> lines = brokenText(text, 20, room);
    EXPECT_EQ(lines, (std::vector<std::string>{"one two three", "four five six"}));
    EXPECT_EQ(brokenText(text, 20, 1e6f), std::vector<std::string>{text});
}

/// Letters of a fixed size are the same in every picture: texts break into lines or are left out.
TEST(Corners, LettersOfAGivenSizeNeverShrink) {
    Frame frame;
    frame.look.unit = 2.0f;
    frame.texts.push_back({"one two three four five six seven eight nine ten", Corner::topLeft, 15});
    Plate plate;
    plate.rows.assign(4, {"name", "value"});
    frame.plates.push_back(plate);
    for (const auto& [w, h] : {std::pair{400, 300}, {1000, 300}, {3000, 2000}}) {
        const CornerLayout layout = layoutCorners(frame, w, h);
        ASSERT_EQ(layout.texts.size(), 1u) << w;
        EXPECT_EQ(layout.texts[0].pixels, 30) << w;
        for (const PlacedPlate& placed : layout.plates) EXPECT_EQ(placed.metrics.pixels, 30);
    }
    EXPECT_GT(layoutCorners(frame, 400, 300).texts[0].lines.size(), 1u);
    EXPECT_EQ(layoutCorners(frame, 1000, 300).plates.size(), 1u);
    frame.plates[0].rows.assign(40, {"name", "value"});
    EXPECT_TRUE(layoutCorners(frame, 1000, 300).plates.empty());
}

TEST(Corners, AWordThatIsTooLongLosesItsEnd) {
    const float room = 80.0f;
    for (const std::string word : {"incomprehensibilities", "λλλλλλλλλλλλλλλλ"}) {
        const std::vector<std::string> lines = brokenText(word, 20, room);
        ASSERT_EQ(lines.size(), 1u);
        EXPECT_TRUE(lines[0].ends_with("…"));
        EXPECT_LE(textWidth(lines[0], 20), room);
        EXPECT_EQ(lines[0].substr(0, 2), word.substr(0, 2));
    }
}

TEST(Corners, ALegendsArrowIsAsLongAsInTheScene) {
    Camera camera{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 53.130102f};  // 10 m high where it looks
    EXPECT_NEAR(pixelsPerMeter(camera, 500), 50.0f, 1e-3f);
    const View view = makeView(camera, 1.0f);
    const Projected a = project(view, {0, 0, 0}, 500, 500), b = project(view, {0, 1, 0}, 500, 500);
    EXPECT_NEAR(a.y - b.y, pixelsPerMeter(camera, 500), 1e-2f);
}

}  // namespace
}  // namespace render
