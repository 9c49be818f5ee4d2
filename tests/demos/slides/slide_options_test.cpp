// A slide's keys as the options of a command: the size of its pictures, the command that draws one.
#include "demos/slides/slide_options.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "demos/slides/slide_plan.h"

namespace demos::test {
namespace {

TEST(SlideOptions, SizesFollowWhatStandsBeside) {
    Slide slide;
    slide.title = slide.caption = slide.notes = "words";
    EXPECT_EQ(pictureSize(slide, {1280, 720}).width, 1280);
    slide.formulas = {"x"};
    EXPECT_EQ(pictureSize(slide, {1280, 720}).width, 854);
    EXPECT_EQ(pictureSize(slide, {1280, 720}).height, 480);
}

TEST(SlideOptions, OnePictureBesideWordsIsAsHighAsItsColumn) {
    Slide slide;
    slide.text = "words";
    slide.runs.scene = "stack";
    slide.exhibit = Exhibit::film;
    EXPECT_EQ(pictureSize(slide, {1280, 720}).width, 854);
    EXPECT_EQ(pictureSize(slide, {1280, 720}).height, 640);
    EXPECT_EQ(pictureSize(slide, {800, 800}).height, 534);  // already higher
    slide.plots = {"energy"};  // below the words, in a row
    EXPECT_EQ(pictureSize(slide, {1280, 720}).height, 480);
    slide.plots = {};
    slide.runs.cases = {"a: solver.sweeps=1", "b: solver.sweeps=2"};
    EXPECT_EQ(pictureSize(slide, {1280, 720}).height, 480);
    slide.runs.cases = {};
    slide.exhibit = Exhibit::strip;
    EXPECT_EQ(pictureSize(slide, {1280, 720}).height, 480);
}

/// Half of what a camera sees at the sides, at a distance of 1.
double sideOf(const FilmPlan& plan) {
    const double fov = plan.scene().camera.fovDegrees;
    return plan.layout.width * std::tan(fov * std::numbers::pi / 360.0) / plan.layout.height;
}

TEST(SlideOptions, AHigherPictureShowsAsMuchAtTheSides) {
    Slide slide;
    slide.runs.scene = "stack";
    for (const Exhibit exhibit : {Exhibit::film, Exhibit::still}) {
        slide.exhibit = exhibit;
        std::vector<double> sides;
        for (const char* text : {"", "words"}) {
            slide.text = text;
            const Options options = optionsOf(slide, {}, {});
            sides.push_back(
                sideOf(planSlide(slide, {}, loadRuns(slide, options), options, false)->film));
        }
        EXPECT_NEAR(sides[0], sides[1], 1e-6);
    }
}

std::string commandFor(const Slide& slide) {
    Deck deck;
    deck.theme = "print";
    const Options options = optionsOf(slide, deck, {});
    return commandOf(slide, deck, loadRuns(slide, options));
}

TEST(SlideOptions, CommandsMakeThePictureAlone) {
    Slide slide;
    EXPECT_EQ(commandFor(slide), "");
    slide.runs.scene = "stack";
    EXPECT_EQ(commandFor(slide), "");
    slide.plots = {"energy", "residual"};
    EXPECT_EQ(commandFor(slide), "impulse plot stack --what energy,residual --theme print");
    slide.exhibit = Exhibit::still;
    slide.at = 2.9;
    slide.show = {"impulses"};
    EXPECT_EQ(commandFor(slide), "impulse still stack -t 2.9 --show impulses --theme print");
    slide = Slide();
    slide.id = "02-nudges";
    slide.runs.comparison = "nudges";
    slide.plots = {"penetration"};
    EXPECT_EQ(commandFor(slide),
              "impulse compare nudges --measure penetration --no-film --plot 02-nudges.svg --theme "
              "print");
    slide.exhibit = Exhibit::film;
    EXPECT_EQ(commandFor(slide), "impulse compare nudges --theme print");
    slide.from = 1.0, slide.until = 3.0, slide.slow = 0.5;
    EXPECT_EQ(commandFor(slide),
              "impulse compare nudges --seconds 3 --theme print  # the slide shows 1 s to 3 s, at "
              "0.5 times the speed");
    slide.from = 0.0;
    EXPECT_TRUE(commandFor(slide).ends_with("print  # the slide plays at 0.5 times the speed"));
    slide = Slide();
    slide.id = "03-sweep";
    slide.runs.scene = "stack";
    slide.runs.settings = {"title='a b'"};
    slide.runs.over = "solver.sweeps=1,4";
    slide.exhibit = Exhibit::film;
    slide.until = 1.5;
    EXPECT_EQ(commandFor(slide),
              "impulse sweep stack --set 'title='\\''a b'\\''' --over "
              "solver.sweeps=1,4 --seconds 1.5 --theme print -o 03-sweep.mp4");
}

}  // namespace
}  // namespace demos::test
