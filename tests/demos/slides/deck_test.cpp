// Deck files: what is read, and the complaints about invalid ones.

#include "demos/slides/deck.h"

#include <gtest/gtest.h>

#include "demos/slides/read_deck.h"
#include "demos/slides/read_slide.h"
#include "demos/slides/slide_plan.h"
#include "tests/demos/reading.h"
#include "tests/support/text.h"

namespace demos::test {
namespace {

using List = std::vector<std::string>;

/// `slides` begins at line 3.
Deck deck(const std::string& slides) {
    return readDeck("format = 1\ntitle = 'A deck'\n" + slides, "deck.toml");
}

List deckErrors(const std::string& slides) {
    try {
        deck(slides);
    } catch (const SceneError& error) {
        return error.lines();
    }
    return {};
}

/// The first complaint about a slide's keys, which begin at line 4.
std::string wrong(const std::string& keys) {
    const List lines = deckErrors("[[slide]]\n" + keys);
    return lines.empty() ? "" : lines.front();
}

const std::string kSlide = "[[slide]]\ntitle = 'x'\n";

TEST(Deck, HasItsDefaults) {
    const Deck read = deck("[[slide]]\ntitle = 'One'\n");
    EXPECT_EQ(read.name, "deck");
    EXPECT_EQ(read.title, "A deck");
    EXPECT_EQ(read.theme, "studio");
    EXPECT_EQ(read.fps, 30);
    EXPECT_EQ(read.size.width, 1280);
    EXPECT_EQ(read.files, std::vector<std::filesystem::path>{"deck.toml"});
    ASSERT_EQ(read.slides.size(), 2u);
    EXPECT_TRUE(read.slides[0].opening);
    EXPECT_EQ(read.slides[0].id, "01-a-deck");
    EXPECT_EQ(read.slides[1].id, "02-one");
    EXPECT_EQ(read.slides[1].exhibit, Exhibit::none);
    EXPECT_FALSE(read.slides[1].runs.any());
    EXPECT_EQ(deck("opening = false\n" + kSlide).slides.size(), 1u);
    EXPECT_EQ(deckErrors("opening = true\n" + kSlide),
              List{"deck.toml:3:11: opening is true; it should be false, or a table [opening]"});
}

TEST(Deck, SaysWhatItsSlidesSay) {
    const Deck read = deck(
        "subtitle = 's'\nauthor = 'a'\ndate = 'd'\ntheme = 'print'\nsize = [640, 360]\nfps = 20\n"
        "[opening]\nscene = 'pendulum'\npicture = 'still'\nat = 1\n"
        "[[slide]]\ntitle = 'T'\ntext = 'x $y$ @{drift}'\nformula = 'z'\ncode = 'c'\n"
        "caption = 'p'\nnotes = 'n'\nscene = 'stack'\nfrom = 0.5\nuntil = 2\n"
        "set = ['solver.sweeps=4']\nshow = ['impulses']\ncolour_by = 'speed'\nslow = 0.5\n"
        "pause = true\nloop = true\nposter = 1\nplot = ['residual', 'energy']\n"
        "table = ['measures', 'expectations']\n");
    EXPECT_EQ(read.subtitle + read.author + read.date + read.theme, "sadprint");
    EXPECT_EQ(read.size.height, 360);
    EXPECT_EQ(read.fps, 20);
    EXPECT_EQ(read.slides[0].exhibit, Exhibit::still);
    EXPECT_EQ(read.slides[0].at, 1.0);
    EXPECT_EQ(read.slides[0].title, "A deck");
    const Slide& slide = read.slides[1];
    EXPECT_EQ(slide.title + slide.text + slide.code + slide.caption + slide.notes,
              "Tx $y$ @{drift}cpn");
    EXPECT_EQ(slide.formulas, List{"z"});
    EXPECT_EQ(slide.runs.scene, "stack");
    EXPECT_EQ(slide.runs.settings, List{"solver.sweeps=4"});
    EXPECT_FALSE(slide.runs.several());
    EXPECT_EQ(slide.exhibit, Exhibit::film);
    EXPECT_EQ(slide.from, 0.5);
    EXPECT_EQ(slide.until, 2.0);
    EXPECT_EQ(slide.show, List{"impulses"});
    EXPECT_EQ(slide.colorBy, "speed");
    EXPECT_EQ(slide.slow, 0.5);
    EXPECT_TRUE(slide.pause && slide.loop && slide.measures && slide.expectations);
    EXPECT_EQ(slide.poster, "1");
    EXPECT_EQ(slide.plots, (List{"residual", "energy"}));
    EXPECT_EQ(slide.place.line, 13);
}

TEST(Deck, ComparesRuns) {
    const Deck read = deck(
        "[[slide]]\ncompare = 'nudges'\ntext = '@{2.speed}'\nplot = 'speed'\n"
        "[[slide]]\nscene = 'stack'\nvary = 'solver.sweeps=1,4'\n"
        "[[slide]]\nscene = 'stack'\ncase = ['a: solver.sweeps=1', 'b: solver.sweeps=2']\n"
        "[[slide]]\nscene = 'stack'\nover = 'solver.sweeps=1..4:x2'\ntext = '@{3.speed}'\n");
    EXPECT_EQ(read.slides[1].runs.comparison, "nudges");
    EXPECT_EQ(read.slides[1].caption,
              "Baumgarte's correction becomes velocity and throws the ball up; nudges do not");
    EXPECT_EQ(read.slides[2].runs.vary, List{"solver.sweeps=1,4"});
    EXPECT_EQ(read.slides[3].runs.cases.size(), 2u);
    EXPECT_EQ(read.slides[4].runs.over, "solver.sweeps=1..4:x2");
}

TEST(Deck, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(deckErrors("subtitel = 's'\n" + kSlide),
              List{"deck.toml:3:1: unknown key 'subtitel' in a deck; did you mean 'subtitle'?"});
    EXPECT_EQ(wrong("titel = 'a'\n"),
              "deck.toml:4:1: unknown key 'titel' in a [[slide]]; did you mean 'title'?");
    EXPECT_EQ(wrong("scene = 'stak'\n"),
              "deck.toml:4:9: there is no built-in scene 'stak'; did you mean 'stack'?");
    EXPECT_EQ(wrong("scene = 'none/a.toml'\n"),
              "deck.toml:4:9: the scene: none/a.toml: there is no such file");
    EXPECT_EQ(wrong("scene = 'stack'\nsection = 'impct'\n"),
              "deck.toml:5:11: 'stack' has no section 'impct'; did you mean 'impact'?");
    EXPECT_EQ(wrong("compare = 'nudge'\n"),
              "deck.toml:4:11: no comparison is called 'nudge'; did you mean 'nudges'?");
    EXPECT_EQ(wrong("scene = 'stack'\nshow = ['impulse']\n"),
              "deck.toml:5:9: no overlay is called 'impulse'; did you mean 'impulses'?");
    EXPECT_EQ(wrong("scene = 'stack'\nplot = 'enrgy'\n"),
              "deck.toml:5:8: no chart of one run is called 'enrgy'; did you mean 'energy'?");
    const std::string charts = "'energy', 'energy', 'energy', 'energy', 'energy', 'energy', ";
    EXPECT_EQ(wrong("scene = 'stack'\nplot = [" + charts + "'energy', 'energy', 'energy']\n"),
              "deck.toml:5:8: a slide shows 9 pictures at most; here are 10");
    EXPECT_EQ(wrong("scene = 'stack'\nplot = [" + charts + "'energy', 'energy']\n"), "");
    EXPECT_EQ(wrong("compare = 'pgs'\nplot = ['contacts']\n"),
              "deck.toml:5:9: no measure of several runs is called 'contacts'; known are: drift, "
              "speed, penetration, separation, energy, residual, sweeps, ms");
    EXPECT_EQ(wrong("scene = 'stack'\ntable = 'measure'\n"),
              "deck.toml:5:9: no table is called 'measure'; did you mean 'measures'?");
    EXPECT_EQ(wrong("scene = 'stack'\npicture = 'stil'\n"),
              "deck.toml:5:11: picture is the text \"stil\"; it should be none, film, still or "
              "strip; did you mean 'still'?");
    EXPECT_EQ(wrong("scene = 'stack'\nset = ['solver.sweps=4']\n"),
              "deck.toml:5:8: set solver.sweps=4: unknown key 'sweps' in [solver]; did you mean "
              "'sweeps'?");
    EXPECT_EQ(wrong("scene = 'stack'\nvary = 'solver.sweeps'\n"),
              "deck.toml:5:8: vary 'solver.sweeps': must be KEY=VALUE,VALUE..., for example "
              "solver.sweeps=1,4,16");
    EXPECT_EQ(deckErrors("theme = 'transparent'\n" + kSlide).front(),
              "deck.toml:3:9: theme is the text \"transparent\"; it should be studio, dark or "
              "print");
}

TEST(Deck, RefusesWhatContradicts) {
    EXPECT_EQ(
        wrong("scene = 'stack'\nsection = 'impact'\nfrom = 1\n"),
        "deck.toml:6:1: a section already gives its scene and times; leave out from, "
        "or section");
    EXPECT_EQ(wrong("compare = 'nudges'\nscene = 'stack'\n"),
              "deck.toml:5:1: a comparison has its own scene and cases; leave out scene, or "
              "compare");
    EXPECT_EQ(wrong("scene = 'stack'\nvary = 'solver.sweeps=1,2'\ncase = 'solver.sweeps=1'\n"),
              "deck.toml:6:1: vary and case cannot be given together; use one of them");
    EXPECT_EQ(wrong("set = 'solver.sweeps=1'\n"), "deck.toml:4:1: set needs a run; name a scene");
    EXPECT_EQ(wrong("plot = 'energy'\n"),
              "deck.toml:4:1: plot needs a run; name a scene or compare");
    EXPECT_EQ(wrong("scene = 'stack'\nat = 1\n"),
              "deck.toml:5:1: at is the time of a still; write picture = \"still\", or from and "
              "until for a film");
    EXPECT_EQ(wrong("scene = 'stack'\nmoments = 3\n"),
              "deck.toml:5:1: moments needs a strip; write picture = \"strip\"");
    EXPECT_EQ(wrong("scene = 'stack'\npicture = 'still'\nloop = true\n"),
              "deck.toml:6:1: loop needs a film, and none is shown here; leave it out");
}

TEST(Deck, KnowsWhenARunEnds) {
    EXPECT_EQ(wrong("scene = 'stack'\nuntil = 99\n"),
              "deck.toml:5:9: until is 99 s; the run ends at 7 s");
    EXPECT_EQ(wrong("scene = 'stack'\npicture = 'still'\nat = 7.1\n"),
              "deck.toml:6:6: at is 7.1 s; the run ends at 7 s");
    EXPECT_EQ(wrong("compare = 'nudges'\nuntil = 2.5\n"),
              "deck.toml:5:9: until is 2.5 s; the run ends at 2 s");
    EXPECT_EQ(wrong("scene = 'stack'\nfrom = 7\n"),
              "deck.toml:5:8: from is 7 s; the run ends then");
    EXPECT_EQ(
        wrong("scene = 'stack'\nset = 'seconds=2'\n"),
        "deck.toml:5:7: with these settings: stack.toml:40:16: at is 3; it should be a number "
        "from 0 to 2 s");
    EXPECT_EQ(wrong("scene = 'stack'\nfrom = 2\nuntil = 2\n"),
              "deck.toml:6:9: until is 2 s; it should be later than from, 2 s");
    EXPECT_EQ(wrong("scene = 'stack'\nfrom = 2\nposter = 1\n"),
              "deck.toml:6:10: poster is 1; it should be a number from 2 to 7 s");
}

TEST(Deck, RefusesNonsenseSizesAndRates) {
    EXPECT_EQ(deckErrors("size = [1, 2, 3]\n" + kSlide),
              List{"deck.toml:3:8: size is a list of 3; it should be two even whole numbers "
                   "[width, height] of pixels"});
    for (const char* size : {"[640]", "[640, 361]", "[0, 360]", "[640, 99999]", "[640.5, 360]"})
        EXPECT_EQ(deckErrors("size = " + std::string(size) + "\n" + kSlide).size(), 1u) << size;
    EXPECT_EQ(
        deckErrors("fps = 25\n[[slide]]\nscene = 'stack'\n"),
        List{"deck.toml:5:9: fps of the deck is 25: 'stack' steps 60 times a second, which must "
             "be a multiple; good: 6 10 12 15 20 30, or set = \"world.hz=50\""});
    EXPECT_EQ(deckErrors("fps = 25\n[[slide]]\nscene = 'stack'\nset = 'world.hz=50'\n"), List{});
    EXPECT_EQ(deckErrors("fps = 25\n[[slide]]\nscene = 'stack'\npicture = 'still'\n"), List{});
    EXPECT_EQ(deckErrors("fps = 0\n" + kSlide),
              List{"deck.toml:3:7: fps is 0; it should be a whole number from 1 to 240 frames a "
                   "second"});
}

TEST(Deck, HasATitleAndSlides) {
    try {
        readDeck("format = 2\n", "a.toml");
        ADD_FAILURE();
    } catch (const SceneError& error) {
        EXPECT_EQ(error.lines(), (List{"a.toml:1:1: format is 2; this version reads format 1",
                                       "a.toml:1:1: the deck has no title; write title = \"...\"",
                                       "a.toml:1:1: the deck has no slide; write a [[slide]]"}));
    }
    EXPECT_EQ(deckErrors("slide = []\n"),
              List{"deck.toml:3:1: the deck has no slide; write a [[slide]]"});
    EXPECT_EQ(deckErrors("[[slide]]\nnotes = 'n'\n"),
              List{"deck.toml:3:1: the slide shows nothing; give it a title, text or a scene"});
    std::string many;
    for (int i = 0; i < 201; ++i) many += "[[slide]]\n";
    EXPECT_EQ(deckErrors(many), List{"deck.toml:3:3: 201 slides; a deck has at most 200"});
}

TEST(Deck, ReportsWhereAFormulaIsWrong) {
    EXPECT_EQ(wrong("text = '''\none\ntwo $x^1^2$\n'''\n"),
              "deck.toml:6:9: formula: Double superscript");
    EXPECT_EQ(wrong("text = \"\\u00e4 \\\"$\\\\lambda \\\\foo$\"\n"),
              "deck.toml:4:28: formula: Undefined control sequence: \\foo");
    EXPECT_EQ(wrong("text = \"\"\"\\\n   a \\\n\n   $a_1_2$\"\"\"\n"),
              "deck.toml:7:8: formula: Double subscript");
    EXPECT_EQ(wrong("formula = ['a', 'b & c']\n"),
              "deck.toml:4:20: formula: Expected 'EOF', got '&'");
    EXPECT_EQ(wrong("formula = 'a^b^c'\n"), "deck.toml:4:15: formula: Double superscript");
    EXPECT_EQ(wrong("title = \"$\\\\href{http://a}{b}$\"\n"),
              "deck.toml:4:11: formula: \\href is not allowed in a formula");
}

// In double quotes TOML reads \\theta as a tab and heta, \\nabla as a new line and abla.
TEST(Deck, ReportsBackslashesThatAreLost) {
    const std::string advice =
        ", written as an escape; write LaTeX in single quotes, which keep its backslashes";
    EXPECT_EQ(wrong("formula = \"\\theta + x\"\n"), "deck.toml:4:12: a tab in a formula" + advice);
    EXPECT_EQ(wrong("formula = \"a + \\nabla f\"\n"),
              "deck.toml:4:16: a line break in a formula" + advice);
    EXPECT_EQ(wrong("text = \"one\\ntwo $\\nu$\"\n"),
              "deck.toml:4:19: a line break in a formula" + advice);
    EXPECT_EQ(wrong("text = \"x $\\theta$\"\n"), "deck.toml:4:12: a tab in a formula" + advice);
    EXPECT_EQ(wrong("formula = \"\"\"\na\n+ \\rho\"\"\"\n"),
              "deck.toml:6:3: a line break in a formula" + advice);
    EXPECT_EQ(wrong("formula = \"\\frac12\"\n"), "deck.toml:4:12: a control byte" + advice);
    const std::string lambda = wrong("formula = \"\\lambda\"\n");
    EXPECT_TRUE(lambda.ends_with("; single quotes keep backslashes, as LaTeX needs them"))
        << lambda;
    EXPECT_EQ(wrong("formula = \"\\\\theta\"\n"), "");
    EXPECT_EQ(wrong("formula = '''\na\n\t+ b\n'''\ntext = \"a\\tb\""), "");
}

TEST(Deck, ReportsADollarWithoutAnother) {
    EXPECT_EQ(wrong("text = 'a $x and b'\n"),
              "deck.toml:4:11: a $ that neither begins nor ends a formula; write \\$ for a dollar, "
              "and a formula with no space inside its dollars");
    EXPECT_NE(wrong("text = 'a $x $ b'\n"), "");
    EXPECT_EQ(wrong("text = 'a \\$x `$x` $5 and $6'\n"), "");
    EXPECT_EQ(wrong("scene = 'stack'\ntext = '$v=$@{speed}'\n"), "");
}

TEST(Deck, RefusesWhatWouldBeEmpty) {
    EXPECT_EQ(wrong("scene = 'stack'\nplot = ['energy', 'separation']\n"),
              "deck.toml:5:19: 'stack' has no joints; leave out separation");
    EXPECT_EQ(wrong("formula = ''\n"),
              "deck.toml:4:12: the formula is empty; write LaTeX, or leave it out");
}

TEST(Deck, RefusesWhatIsNoLineOrNoMoment) {
    EXPECT_EQ(wrong("title = \"a\\nb\"\n"),
              "deck.toml:4:11: a line break; this should be one line");
    EXPECT_EQ(deckErrors("author = '''a\nb'''\n" + kSlide),
              List{"deck.toml:3:14: a line break; this should be one line"});
    EXPECT_EQ(
        wrong("scene = 'stack'\nposter = 'middle'\n"),
        "deck.toml:5:10: poster is the text \"middle\"; it should be first, last or a time in "
        "s");
    EXPECT_EQ(wrong("scene = 'stack'\nvary = 'solver.sweeps=1'\n"),
              "deck.toml:5:8: 1 to compare; give two to four, as in vary = "
              "\"solver.sweeps=1,4,16\"");
    EXPECT_EQ(wrong("scene = 'stack'\nshow = ['impulses', 3]\n"),
              "deck.toml:5:21: show holds 3; it should be a list of texts, like [\"box0\", "
              "\"box1\"]");
}

TEST(Deck, ReportsWhichNumbersItsRunsDoNotHave) {
    const std::string stack = "scene = 'stack'\n";
    EXPECT_EQ(wrong(stack + "text = 'a @{body.bx3.speed}'\n").substr(0, 87),
              "deck.toml:5:11: no body of 'stack' is called 'bx3'; did you mean 'box3'?");
    EXPECT_EQ(wrong(stack + "text = '@{joint.a.force}'\n"),
              "deck.toml:5:9: no joint of 'stack' is called 'a'; it has none");
    EXPECT_EQ(wrong(stack + "text = '@{2.drift}'\n"),
              "deck.toml:5:9: there is no run 2; the slide has 1");
    EXPECT_EQ(wrong(stack + "caption = '@{expect.99}'\n"),
              "deck.toml:5:12: 'stack' has 4 [[expect]]; there is no expectation 99");
    EXPECT_EQ(wrong(stack + "formula = 'v = @{penetraton}'\n"),
              "deck.toml:5:16: no number is called 'penetraton'; did you mean 'penetration'?");
    EXPECT_EQ(wrong("notes = '@{drift}'\n"),
              "deck.toml:4:10: there is no run here to take numbers from; name a scene");
    EXPECT_EQ(wrong(stack + "text = '$x = @{run.time}$ and $y$'\n"), "");
}

TEST(Deck, SurvivesAnything) {
    EXPECT_EQ(wrong("text = '" + std::string(17000, 'x') + "'\n"),
              "deck.toml:4:9: the text has 17000 bytes; it should have at most 16384");
    EXPECT_EQ(wrong("text = \"a\\u0000b\"\n"), "deck.toml:4:10: a control byte; take it out");
    EXPECT_EQ(wrong("code = \"a\\u001bb\"\n"), "deck.toml:4:10: a control byte; take it out");
    EXPECT_NE(wrong("text = 'a\xff'\n"), "");
    EXPECT_EQ(wrong("text = '" + support::repeated("$a$ ", 2001) + "'\n"),
              "deck.toml:1:1: the deck has 4002 $ around formulas; it should have at most 4000");
    for (const std::string& text :
         {std::string(1 << 20, '['), std::string(1 << 20, '\0'), std::string("format"),
          std::string(""), std::string("slide = 3"), std::string("opening = 3\nslide = [1, 'a']"),
          std::string(9 << 20, ' ')})
        EXPECT_THROW(readDeck(text, "a.toml"), SceneError) << text.substr(0, 20);
}

TEST(Deck, NamesItsSlides) {
    EXPECT_EQ(slideId(3, 20, "Clamp the *total*: $\\lambda \\geq 0$!"),
              "03-clamp-the-total-lambda-geq-0");
    EXPECT_EQ(slideId(7, 100, ""), "007");
    EXPECT_EQ(slideId(1, 9, "\u00c4rger / ../x"), "01-rger-x");
    EXPECT_EQ(slideId(1, 9, std::string(99, 'a')).size(), 43u);
}

TEST(Deck, TheTalkIsRead) {
    const Deck talk = loadDeck(std::filesystem::path(IMPULSE_SOURCE_DIR) /
                               "demos/decks/sequential-impulses.toml");
    EXPECT_GE(talk.slides.size(), 20u);
    EXPECT_EQ(talk.slides[0].title, "Sequential impulses");
}

TEST(ClipRate, ShowsAsManyPicturesAsTheStepsAllow) {
    const struct {
        int hz, fps;
        double slow;
        int drawn, shown;
    } cases[] = {{60, 30, 1.0, 30, 30},  {60, 30, 0.5, 60, 30},  {60, 30, 2.0, 15, 30},
                 {60, 30, 0.3, 60, 18},  {240, 30, 0.3, 80, 24}, {60, 24, 1.0, 20, 20},
                 {60, 30, 0.01, 60, 1},  {60, 30, 50.0, 1, 50},  {300, 30, 0.3, 100, 30},
                 {60, 30, 900.0, 1, 240}};
    for (const auto& c : cases) {
        const ClipRate rate = clipRate(c.hz, c.fps, c.slow);
        EXPECT_EQ(rate.drawn, c.drawn) << c.hz << " hz, slow " << c.slow;
        EXPECT_EQ(rate.shown, c.shown) << c.hz << " hz, slow " << c.slow;
    }
}

}  // namespace
}  // namespace demos::test
