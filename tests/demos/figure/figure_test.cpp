// Sizes on paper: lengths, pixels, type in points, the places of pictures, captions.
#include <gtest/gtest.h>

#include <cmath>

#include "demos/charts/drawing.h"
#include "demos/charts/layout.h"
#include "demos/figure/caption.h"
#include "demos/figure/figure_grid.h"
#include "demos/look/length.h"
#include "demos/look/type.h"
#include "demos/options/picture_options.h"
#include "demos/scene/reader.h"
#include "demos/scene/solver_settings.h"
#include "demos/text/stop.h"
#include "tests/demos/charts/column.h"

namespace demos {
namespace {

TEST(Length, IsReadInEveryUnit) {
    EXPECT_NEAR(*lengthFrom("85mm"), 85.0, 1e-12);
    EXPECT_NEAR(*lengthFrom("85"), 85.0, 1e-12);
    EXPECT_NEAR(*lengthFrom("8.5cm"), 85.0, 1e-12);
    EXPECT_NEAR(*lengthFrom("2in"), 50.8, 1e-12);
    EXPECT_NEAR(*lengthFrom("72pt"), 25.4, 1e-12);
    for (const char* bad : {"", "mm", "85m", "85 mm", "nan", "inf", "8,5cm", "85mmm", "1e2mm", "x"})
        EXPECT_FALSE(lengthFrom(bad)) << bad;
}

TEST(Paper, GivesPixelsAndKeepsTheRatio) {
    EXPECT_EQ(kColumn.pixels(), 1004);  // 85 / 25.4 * 300 = 1003.9
    EXPECT_EQ(figureSize(kColumn, {1280, 720}).width, 1004);
    EXPECT_EQ(figureSize(kColumn, {1280, 720}).height, 565);
    EXPECT_EQ(figureSize({170.0, 150}, {2, 1}).height, 502);
    EXPECT_DOUBLE_EQ(kColumn.pixelsPerPoint(), 300 / 72.0);
    EXPECT_DOUBLE_EQ(Paper{}.pixelsPerPoint(), 0.0);
    EXPECT_THROW(figureSize(kColumn, {1, 100}), Stop);
}

TEST(Paper, IsForPrintUnlessSomethingElseIsAskedFor) {
    SceneDescription scene;
    Options options;
    EXPECT_EQ(themeOf(scene, options), "studio");
    options.width = 85.0;
    EXPECT_EQ(themeOf(scene, options), "print");
    scene.look.theme = "dark";
    EXPECT_EQ(themeOf(scene, options), "dark");
    options.theme = "studio";
    EXPECT_EQ(themeOf(scene, options), "studio");
}

/// An em of 8 pt in pixels, rounded to a whole number.
TEST(Type, IsInPointsOfTheEm) {
    for (const int dpi : {72, 150, 300, 600}) {
        const double em = kEmShare * letterPixels(kLabelPoints, dpi / 72.0);
        EXPECT_NEAR(em, 8.0 * dpi / 72.0, 0.5) << dpi;
    }
}

/// Whatever sizes a frame had before.
TEST(Type, OfAFrameIsThatOfACharts) {
    render::Frame frame;
    frame.texts = {{"first line", render::Corner::topLeft, 18.0f},
                   {"caption", render::Corner::bottomLeft, 26.0f}};
    frame.plates.push_back({});
    setType(kColumn.pixelsPerPoint(), frame);
    const Page page = pageOf({}, {1004, 565}, kColumn);
    const auto pixels = [&](float size) {
        return static_cast<float>(std::lround(size * frame.look.unit));
    };
    EXPECT_EQ(pixels(frame.texts[0].size), page.text);
    EXPECT_EQ(pixels(frame.texts[1].size), page.title);
    EXPECT_EQ(pixels(frame.plates[0].size), page.text);
    EXPECT_EQ(page.text, 39.0f);  // 8 pt * 300 / 72 * 2384 / 2048 = 38.8
    EXPECT_NEAR(frame.look.edgePixels, 0.45 * 300 / 72, 1e-5);
}

/// Three lines that end at one place: on a screen their labels shrink, on paper they do not.
std::vector<Chart> crowdedChart(int lines) {
    Chart chart;
    chart.title = "t";
    for (int i = 0; i < lines; ++i)
        chart.series.push_back({"line " + std::to_string(i), {0, 1}, {0, 1.0 + 0.01 * i}});
    return {chart};
}

TEST(FigureChart, HasOneSizeOfLettersInEveryPicture) {
    for (const PictureSize size : {PictureSize{1004, 400}, {1004, 900}, {2008, 700}})
        for (const int lines : {1, 4, 12})
            for (const Label& label : drawingOf(crowdedChart(lines), size, "print", kColumn).labels)
                EXPECT_EQ(label.pixels, label.text == "t" ? 44.0f : 39.0f) << label.text;
}

TEST(FigureChart, LeavesAsidesOfATitleToTheCaption) {
    std::vector<Chart> charts = crowdedChart(1);
    charts[0].title = "chain: residual sweep by sweep, in the hardest of sub-steps (t = 7.633 s)";
    const auto title = [&](const Paper& paper) {
        return drawingOf(charts, {1004, 565}, "print", paper).labels.front().text;
    };
    EXPECT_EQ(title(kColumn), "chain: residual sweep by sweep");
    EXPECT_EQ(title({}), charts[0].title);
    charts[0].title = "a title of many words without an aside that has no room in a column";
    const Drawing drawing = drawingOf(charts, {1004, 565}, "print", kColumn);
    EXPECT_EQ(drawing.labels[0].text + " " + drawing.labels[1].text, charts[0].title);
}

TEST(FigureChart, DrawsCurvesOfFourFifthsOfAPoint) {
    for (const int dpi : {72, 100, 150, 300, 600}) {
        const Paper paper{85.0, dpi};
        const Drawing drawing =
            drawingOf(crowdedChart(1), chartSize(1, paper, std::nullopt), "print", paper);
        EXPECT_NEAR(drawing.lines.front().width, 0.8 * dpi / 72.0, 1e-4) << dpi;
    }
}

TEST(FigureChart, TellsItsMillimetresInAnSvg) {
    const PictureSize size = chartSize(1, kColumn, std::nullopt);
    const std::string svg = svgOf(crowdedChart(1), size, "print", kColumn);
    EXPECT_NE(svg.find("width=\"85mm\" height=\"47.834mm\" viewBox=\"0 0 1004 565\""),
              std::string::npos)
        << svg.substr(0, 200);
    EXPECT_NE(svgOf(crowdedChart(1), size, "print").find("width=\"1004\" height=\"565\""),
              std::string::npos);
}

TEST(FigureChart, IsHighEnoughForItsType) {
    EXPECT_EQ(chartSize(4, kColumn, std::nullopt).height, kColumn.pixelsOf(4 * 38.0));
    EXPECT_EQ(chartSize(1, kColumn, PictureSize{2, 1}).height, 502);
    const PictureSize size = chartSize(4, kColumn, std::nullopt);
    const std::vector<Chart> charts(4, crowdedChart(2).front());
    for (const Plot& plot : pageOf(charts, size, kColumn).plots)
        EXPECT_GT(plot.bottom - plot.top, 0.35f * static_cast<float>(size.height) / 4.0f);
}

TEST(FigureChart, HasNoGroundWhereItIsTransparent) {
    const Drawing solid = drawingOf(crowdedChart(1), {1004, 565}, "print", kColumn);
    const Drawing clear = drawingOf(crowdedChart(1), {1004, 565}, "transparent", kColumn);
    EXPECT_EQ(clear.rectangles.size() + 1, solid.rectangles.size());
    const render::Image image = imageOf(clear);
    EXPECT_EQ(image.at(0, 0)[3], 0);
    int opaque = 0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) opaque += image.pixels[i] == 255;
    EXPECT_GT(opaque, 2000);  // the curve and the letters
}

TEST(FigureGrid, FillsTheWidthToThePixel) {
    for (const double width : {85.0, 123.4, 170.0})
        for (const int dpi : {72, 150, 300})
            for (int columns = 1; columns <= 4; ++columns) {
                const Paper paper{width, dpi};
                const StripLayout layout = figureLayout(8, columns, {16, 9}, paper, 1);
                EXPECT_EQ(layout.width, paper.pixels());
                EXPECT_EQ(layout.left(0),
                          columns > 1 ? 0 : (layout.width - layout.picture.width) / 2);
                EXPECT_EQ(layout.left(columns - 1) + layout.picture.width, layout.width) << columns;
                for (int i = 1; i < columns; ++i)
                    EXPECT_GE(layout.left(i) - layout.left(i - 1),
                              layout.picture.width + layout.gap);
                EXPECT_EQ(layout.label, letterPixels(kLabelPoints, paper.pixelsPerPoint()));
            }
}

TEST(FigureGrid, HasPicturesThatAreWideEnoughForTheirLabels) {
    EXPECT_EQ(figureColumns(6, kColumn), 3);
    EXPECT_EQ(figureColumns(6, {170.0, 300}), 6);
    EXPECT_EQ(figureColumns(2, {10.0, 300}), 1);
    EXPECT_THROW(figureLayout(100, 100, {16, 9}, kColumn, 1), Stop);  // of 1 pixel
    EXPECT_THROW(figureLayout(100, 1, {16, 9}, {170.0, 600}, 1), Stop);
}

TEST(FigureCaption, BeginsWithASentenceAndTellsWhatIsNotAsUsual) {
    const SceneDescription scene = readScene(
        "format = 1\ntitle = \"Ball: it falls.\"\n[world]\nhz = 120\n"
        "gravity = [0, -1.6, 0]\n[solver]\npreset = \"fast\"\nsubsteps = 7\n"
        "[[body]]\nname = \"b\"\nshape = { sphere = 1 }\nat = [0, 0, 0]\n",
        "ball.toml", "ball");
    Options options;
    options.scenes = {"ball.toml"};
    options.overrides = {"world.hz=120"};
    options.commandLine = "impulse still ball.toml";
    Caption caption(titleOf(scene) + ". t = 1 s");
    addFiles({"a.png"}, {1004, 565}, kColumn, caption);
    addPhysics(scene, options, caption);
    addShots({{1.0, 120, 0xabcu}}, caption);
    addProgram(options, caption);
    const std::string text = caption.text();
    EXPECT_TRUE(text.starts_with("Ball: it falls. t = 1 s.\n\nfigure: a.png\n")) << text;
    for (const char* line :
         {"\nsize on paper: 85 x 47.8 mm, 1004x565 pixels at 300 dpi\n", "\nscene: ball.toml\n",
          "\nsteps a second: 120\n", "\ngravity: 0 -1.6 0 m/s^2\n",
          "\nsolver: preset fast; substeps=7\n", "\nset: world.hz=120\n", "\ntime: 1.000 s\n",
          "\nstep: 120\n", "\nstate: 0000000000000abc\n", "\ncommand: impulse still ball.toml\n"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "in\n" << text;
    EXPECT_EQ(text.find("seed"), std::string::npos);
}

TEST(FigureCaption, TellsTheArrowsScaleOfEveryPicture) {
    Overlays overlays;
    EXPECT_EQ(scalesText(overlays, {{}}), "");
    overlays.impulses = true;
    PictureFacts one, two;
    one.impulse = 50.02, two.impulse = 12.3;
    EXPECT_EQ(scalesText(overlays, {one, one}),
              "; red arrows: impulses along the normals, 1 cm = 50 N s");
    EXPECT_EQ(scalesText(overlays, {one, two, {}}),
              "; red arrows: impulses along the normals, 1 cm = 50 N s, 12.3 N s, none");
    EXPECT_EQ(scalesText(overlays, {one, two}),
              "; red arrows: impulses along the normals, 1 cm = 50, 12.3 N s");
    EXPECT_EQ(scalesText(overlays, {{}}), "; red arrows: impulses along the normals");
    PictureFacts bare;
    bare.onPaper = true;
    EXPECT_EQ(scalesText(overlays, {bare}), "");  // there is no arrow to name
    EXPECT_EQ(timesText({one, one}), "t = 0 s");
    two.time = 1.25;
    EXPECT_EQ(timesText({one, two}), "t = 0, 1.25 s");
    one.time = 7.0 / 3;
    EXPECT_EQ(timesText({one, two}), "t = 2.333, 1.250 s");
}

TEST(FigureCaption, NamesEveryMark) {
    for (const char* mark : {"contacts", "normals", "joints", "axes", "com", "bounds", "annotate", "ghost"}) {
        Overlays overlays;
        ASSERT_TRUE(switchOn(overlays, mark));
        EXPECT_TRUE(scalesText(overlays, {{}}).starts_with("; ")) << mark;
    }
}

TEST(FigureCaption, ListsWhatIsSeen) {
    Overlays overlays;
    overlays.stats = true;
    PictureFacts full, small;
    small.leftOut = {"stats", "caption"};
    const auto shown = [&](const std::vector<PictureFacts>& facts) {
        Caption caption("x");
        addLook(overlays, facts, caption);
        const std::string text = caption.text();
        return text.substr(text.find("shown"));
    };
    EXPECT_NE(shown({full, small}).find("stats"), std::string::npos);
    EXPECT_EQ(shown({small, small}).find("stats"), std::string::npos);
    EXPECT_EQ(shown({small}).find("caption"), std::string::npos);
    EXPECT_EQ(leftOut({small, full, small}), (std::vector<std::string>{"stats", "caption"}));
}

TEST(SolverSettings, OfAPresetAreNotBesideIt) {
    for (const char* preset : {"steady", "fast", "seed"}) {
        EXPECT_EQ(besidePreset(presetCalled(preset), preset), "");
        engine::Settings changed = presetCalled(preset);
        changed.slop = 0.25;
        EXPECT_EQ(besidePreset(changed, preset), "slop=0.25");
    }
}

}  // namespace
}  // namespace demos
