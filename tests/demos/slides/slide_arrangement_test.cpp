// The places of a slide's pictures, their sizes, and the sizes of their letters.
#include "demos/slides/slide_arrangement.h"

#include <gtest/gtest.h>

#include "demos/look/type.h"

namespace demos::test {
namespace {

TEST(Arrangement, PicturesAreAsLargeAsTheirRoomLetsThemBe) {
    const double aspect = 16.0 / 9.0;
    const struct {
        std::size_t count;
        SlideRoom room;
        int rows, columns;
    } cases[] = {{1, {700, 540}, 1, 1},  {2, {700, 540}, 2, 1},   {2, {1168, 390}, 1, 2},
                 {3, {1168, 390}, 1, 3}, {6, {1168, 540}, 2, 3},  {7, {1168, 390}, 2, 4},
                 {9, {700, 540}, 3, 3},  {19, {1168, 390}, 3, 7}, {4, {1168, 540}, 2, 2}};
    for (const auto& c : cases) {
        const PictureGrid grid = gridOf(c.count, aspect, c.room);
        EXPECT_EQ(grid.rows, c.rows) << c.count;
        EXPECT_EQ(grid.columns, c.columns) << c.count;
        EXPECT_GE(emptyCells(c.count, grid), 0) << c.count;
    }
}

TEST(Arrangement, AHoleHasToBeWorthIt) {
    const double aspect = 16.0 / 9.0;
    Slide alone;
    const auto columns = [&](std::size_t count) {
        return arrangement(alone, count, aspect).columns;
    };
    EXPECT_EQ(columns(3), 3);  // two and a third in the middle would be a quarter wider
    EXPECT_EQ(columns(4), 2);
    EXPECT_EQ(columns(5), 3);  // one row would be half as large
    EXPECT_EQ(columns(6), 3);
    EXPECT_EQ(columns(12), 4);
    EXPECT_EQ(columns(16), 4);
}

TEST(Arrangement, LettersAreReadWhereverTheirPictureStands) {
    Slide slide;
    slide.text = "words";
    const PictureSize picture{854, 480};
    const double beside = pointPixels(slide, picture);
    const double shown = 700.0 / 854.0;  // px of a slide for a pixel of the picture
    EXPECT_NEAR(beside * kLabelPoints * shown, kLeastLetters, 1e-9);
    slide.plots = {"energy"};
    EXPECT_GT(pointPixels(slide, picture), beside);  // less room
}

TEST(Arrangement, ATableThatCanBeBrokenStandsBesideItsCharts) {
    const Slide slide;
    const std::vector<double> charts = {1.6, 1.6};
    const MadeTable expectations{
        {"what", "of", "expected", "measured", "ok"},
        {{"drift", "box*", "below 0.00002 m, 0 s to 2.8 s", "8e-06 m", "yes"}}};
    EXPECT_EQ(layoutOf(slide, widthOf({expectations}), charts), SlideLayout::even);
    MadeTable measures{{}, {{}}};
    for (int i = 0; i < 8; ++i) {
        measures.head.push_back("a measure");
        measures.rows[0].push_back("1");
    }
    EXPECT_EQ(layoutOf(slide, widthOf({expectations, measures}), charts), SlideLayout::below);
    EXPECT_EQ(layoutOf(slide, widthOf({{{"a", "b"}, {{"1", "2"}}}}), charts), SlideLayout::beside);
}

}  // namespace
}  // namespace demos::test
