// Decks simulated and drawn: films, stills, strips, charts, tables and numbers of slides.
#include "demos/slides/make_deck.h"

#include <cmath>
#include <csignal>

#include "demos/processes/child_program.h"
#include "demos/processes/signals.h"
#include "demos/scene/reader.h"
#include "demos/slides/slide_options.h"
#include "demos/slides/slide_pictures.h"
#include "demos/text/stop.h"
#include "render/encode/png_read.h"
#include "tests/demos/small_film.h"
#include "tests/render/film_bytes.h"

namespace demos::test {
namespace {

class MakeDeck : public testing::Test {
protected:
    MakeDeck() {
        if (const char* path = std::getenv("PATH")) path_ = path;
        write(folder / "ball.toml", kBall);
        deck.theme = "print";
        deck.size = {kWidth, kHeight};
        making.folder = folder.path();
        making.options.samples = 1;
        making.options.quiet = true;
        making.options.jobs = 2;
    }
    ~MakeDeck() override { ::setenv("PATH", path_.c_str(), 1); }

    Slide& add(Exhibit exhibit) {
        Slide slide;
        slide.id = "0" + std::to_string(deck.slides.size() + 1) + "-ball";
        slide.exhibit = exhibit;
        slide.runs.scene = (folder / "ball.toml").string();
        deck.slides.push_back(slide);
        return deck.slides.back();
    }
    MadeSlide made() { return makeDeck(deck, making).slides.front(); }
    MadeFilm film(double from, double until, double slow, const std::string& poster = "last") {
        deck.slides.clear();
        Slide& slide = add(Exhibit::film);
        slide.from = from, slide.until = until, slide.slow = slow, slide.poster = poster;
        return *made().film;
    }
    Stop stopped() {
        try {
            makeDeck(deck, making);
        } catch (const Stop& stop) {
            return stop;
        }
        return Stop(Exit::ok, "it went well");
    }
    std::vector<std::uint8_t> drawnByTheProgram(std::vector<std::string> arguments) {
        for (const char* word : {"ball.toml", "--size", "96x54", "--samples", "1", "--theme",
                                 "print", "-o", "alone.png"})
            arguments.push_back(word);
        const Ended ended = run(folder.path(), arguments);
        EXPECT_EQ(ended.code, 0) << ended.err;
        const std::string png = contentOf(folder / "alone.png");
        fs::remove(folder / "alone.png");
        return {png.begin(), png.end()};
    }

    TemporaryFolder folder;
    Deck deck;
    DeckMaking making;
    std::string path_;
};

/// "30/1"
std::string rateOf(const fs::path& film) {
    const std::string command =
        "ffprobe -v error -select_streams v -show_entries "
        "stream=r_frame_rate -of csv=p=0 '" +
        film.string() + "'";
    FILE* pipe = popen(command.c_str(), "r");
    char text[64] = {};
    const bool got = std::fgets(text, sizeof text, pipe) != nullptr;
    pclose(pipe);
    const std::string line = got ? text : "";
    return line.substr(0, line.find_first_of("\r\n"));
}

TEST_F(MakeDeck, AFilmHasTheFramesOfItsTimesAtItsSpeed) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    const struct {
        double slow;
        int frames, fps;
        double secondsAFrame;
    } cases[] = {{1.0, 10, 30, 1.0 / 30},
                 {0.5, 19, 30, 1.0 / 60},
                 {2.0, 6, 30, 1.0 / 15},
                 {0.3, 19, 18, 1.0 / 60}};
    for (const auto& c : cases) {
        const MadeFilm film = this->film(0.2, 0.5, c.slow);
        EXPECT_EQ(film.frames, c.frames) << c.slow;
        EXPECT_EQ(film.fps, c.fps) << c.slow;
        EXPECT_DOUBLE_EQ(film.secondsAFrame, c.secondsAFrame) << c.slow;
        EXPECT_NEAR(film.first, 0.2, 1e-12) << c.slow;
        EXPECT_EQ(film.file, folder / "01-ball.mp4");
        EXPECT_EQ(playableFrames(film.file), c.frames);
        EXPECT_EQ(rateOf(film.file), std::to_string(c.fps) + "/1");
    }
}

/// Compares colours that differ much: finds motion, not losses of the codec.
int differingPixels(const render::Image& a, const render::Image& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        int most = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            most = std::max(most, std::abs(int{a.pixels[c]} - int{b.pixels[c]}));
        count += most > 48;
    }
    return count;
}

TEST_F(MakeDeck, ThePosterIsAFrameOfTheFilm) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    const struct {
        const char* poster;
        int frame;
    } cases[] = {{"first", 0}, {"last", 12}, {"0.5", 9}};
    deck.size = {2 * kWidth, 2 * kHeight};
    for (const auto& c : cases) {
        const MadeFilm film = this->film(0.2, 0.6, 1.0, c.poster);
        const render::Image poster = render::decodePng(film.poster.png);
        const auto frames = film_bytes::decoded(film.file, 2 * kWidth, 2 * kHeight);
        ASSERT_EQ(frames.size(), 13u);
        for (int i = 0; i < 13; ++i) {
            if (std::abs(i - c.frame) < 3) continue;  // the ball has moved by two pixels by then
            EXPECT_LT(differingPixels(frames[c.frame], poster), differingPixels(frames[i], poster))
                << c.poster << " " << i;
        }
        EXPECT_FALSE(film.poster.says.empty());
    }
}

TEST_F(MakeDeck, ThePosterAloneIsTheSame) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    const MadeFilm whole = film(0.0, 0.4, 1.0);
    fs::remove(whole.file);
    making.films = false;
    const MadeFilm alone = film(0.0, 0.4, 1.0);
    EXPECT_EQ(alone.poster.png, whole.poster.png);
    EXPECT_EQ(alone.frames, whole.frames);
    EXPECT_TRUE(alone.file.empty());
    EXPECT_FALSE(fs::exists(whole.file));
    EXPECT_TRUE(makeDeck(deck, making).diagnostics.empty());
}

TEST_F(MakeDeck, TheSameDeckGivesTheSameBits) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    add(Exhibit::film).plots = {"energy"};
    making.options.reproducible = true;
    const MadeSlide once = made();
    const std::string bytes = contentOf(once.film->file);
    making.options.jobs = 1;
    const MadeSlide again = made();
    EXPECT_GT(bytes.size(), 1000u);
    EXPECT_EQ(contentOf(again.film->file), bytes);
    EXPECT_EQ(again.film->poster.png, once.film->poster.png);
    EXPECT_EQ(again.pictures.front().png, once.pictures.front().png);
    EXPECT_EQ(again.pictures.front().svg, once.pictures.front().svg);
}

TEST_F(MakeDeck, WithoutFfmpegThereArePostersAndOneRemark) {
    for (int i = 0; i < 2; ++i) add(Exhibit::film).until = 0.2;
    add(Exhibit::none).text = "t = @{run.time}";
    ::setenv("PATH", "", 1);
    const MadeDeck made = makeDeck(deck, making);
    ASSERT_EQ(made.diagnostics.size(), 1u);
    EXPECT_NE(made.diagnostics.front().find("apt install ffmpeg"), std::string::npos);
    for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(made.slides[i].film->file.empty());
        EXPECT_EQ(render::decodePng(made.slides[i].film->poster.png).width, kWidth);
        EXPECT_EQ(made.slides[i].film->frames, 7);
    }
    EXPECT_EQ(made.slides[2].slide.text, "t = 1\u00a0s");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST_F(MakeDeck, StillsAndStripsAreThoseOfTheProgram) {
    add(Exhibit::still).at = 0.45;
    EXPECT_EQ(made().pictures.front().png, drawnByTheProgram({"still", "-t", "0.45"}));
    deck.slides.clear();
    deck.size = {2 * kWidth, 2 * kHeight};  // a strip's pictures are half as large
    Slide& strip = add(Exhibit::strip);
    strip.from = 0.1, strip.until = 0.7, strip.moments = 3;
    const MadeSlide made = this->made();
    EXPECT_EQ(made.pictures.front().png, drawnByTheProgram({"strip", "--times", "0.1,0.4,0.7"}));
    EXPECT_NE(made.command.find("--times 0.1,0.4,0.7"), std::string::npos) << made.command;
}

TEST_F(MakeDeck, SeveralRunsStandSideBySide) {
    making.films = false;
    Slide& slide = add(Exhibit::film);
    slide.until = 0.5, slide.poster = "last";
    slide.runs.vary = {"world.gravity=[0,-9.81,0],[0,0,0]"};
    slide.plots = {"speed"};
    slide.measures = true;
    slide.text = "@{1.speed:2} and @{2.speed:2}";
    deck.size = {320, 180};
    const MadeSlide made = this->made();
    EXPECT_EQ(made.slide.text, "4.9\u00a0m/s and 0\u00a0m/s");  // g t
    const render::Image poster = render::decodePng(made.film->poster.png);
    EXPECT_EQ(poster.width, 214);  // two thirds: there are words beside it
    int different = 0;
    for (int y = 0; y < poster.height; ++y)
        for (int x = 0; x < 100; ++x)
            different += !std::equal(poster.at(x, y), poster.at(x, y) + 3, poster.at(x + 107, y));
    EXPECT_GT(different, 50);
    EXPECT_NE(made.pictures.front().svg.find("gravity=[0,0,0]"), std::string::npos);
    ASSERT_EQ(made.tables.size(), 1u);
    EXPECT_EQ(made.tables.front().head.front(), "run");
    EXPECT_EQ(made.tables.front().rows.size(), 2u);
    for (const auto& row : made.tables.front().rows)
        EXPECT_EQ(row.size(), made.tables.front().head.size());
    EXPECT_NE(made.command.find("compare"), std::string::npos);
}

TEST_F(MakeDeck, ASweepIsAGridAndAChart) {
    making.films = false;
    Slide& slide = add(Exhibit::film);
    slide.until = 0.2;
    slide.runs.over = "world.hz=30,60,120,240";
    slide.plots = {"speed"};
    const MadeSlide made = this->made();
    EXPECT_DOUBLE_EQ(made.film->secondsAFrame, 1.0 / 30);  // divides the rates of all runs
    EXPECT_NE(made.pictures.front().svg.find("world.hz"), std::string::npos);
    EXPECT_EQ(made.pictures.front().size.width, render::decodePng(made.pictures.front().png).width);
}

std::string withSpaces(std::string text) {
    const std::string noBreak = "\u00a0";
    for (std::size_t i = 0; (i = text.find(noBreak, i)) != std::string::npos;)
        text.replace(i, noBreak.size(), " ");
    return text;
}

TEST_F(MakeDeck, TablesSayWhatCameOut) {
    write(folder / "ball.toml", kBall + R"([[expect]]
what = "speed"
of = ["ball"]
below = 9
why = "it falls for 0.7 s"
[[expect]]
what = "drift"
above = 1
why = "nothing pushes it"
)");
    Slide& slide = add(Exhibit::none);
    slide.measures = slide.expectations = true;
    slide.until = 0.5;
    making.options.reproducible = true;
    const std::vector<MadeTable> tables = made().tables;
    ASSERT_EQ(tables.size(), 2u);
    ASSERT_EQ(tables[0].rows.size(), 1u);
    int speeds = 0;
    for (std::size_t i = 0; i < tables[0].head.size(); ++i) {
        EXPECT_NE(tables[0].head[i], "ms");  // differs every time
        if (tables[0].head[i] != "speed (m/s)") continue;
        ++speeds;
        EXPECT_NEAR(std::stod(tables[0].rows[0][i]), 9.81 * 0.5, 2e-3);
    }
    EXPECT_EQ(speeds, 1);
    const std::vector<std::string> head = {"what", "of", "expected", "measured", "ok"};
    EXPECT_EQ(tables[1].head, head);
    const Ended sim = run(folder.path(), {"sim", "ball.toml"});
    const std::string said = sim.out + sim.err;
    for (const auto& row : tables[1].rows) {
        const std::string line = withSpaces(row[0] + " of " + row[1] + " " + row[2] + ": ");
        const std::size_t at = said.find(line);
        ASSERT_NE(at, std::string::npos) << line;
        const double value = std::stod(said.substr(at + line.size()));  // six digits
        EXPECT_NEAR(std::stod(row[3]), value, 0.6e-3 * value) << "four digits";
    }
    EXPECT_EQ(tables[1].rows[0].back(), "yes");
    EXPECT_EQ(tables[1].rows[1].back(), "no");
}

TEST_F(MakeDeck, AnIncidentIsReportedWithItsSlideAndTheDeckIsWhole) {
    making.films = false;
    add(Exhibit::none).text = "words";
    for (const Exhibit exhibit : {Exhibit::none, Exhibit::film}) {
        deck.slides.resize(1);
        Slide& slide = add(exhibit);
        slide.runs.settings = {"body.ball.velocity=[9999,0,0]", "world.gravity=[0,0,0]"};
        slide.measures = exhibit == Exhibit::none;
        slide.until = 12.0;  // 100 km are passed at 10 s
        const MadeDeck made = makeDeck(deck, making);
        EXPECT_TRUE(made.incident.starts_with("slide '02-ball': ball: step 60")) << made.incident;
        EXPECT_EQ(made.compared, "");
        EXPECT_EQ(made.slides[1].tables.size(), exhibit == Exhibit::none ? 1u : 0u);
        EXPECT_EQ(made.slides[1].film.has_value(), exhibit == Exhibit::film);
    }
}

TEST_F(MakeDeck, AStepThatFailsIsReportedWithItsSlide) {
    write(folder / "ball.toml", kTooTall);
    add(Exhibit::none).measures = true;
    EXPECT_EQ(stopped().code(), Exit::diverged);
    EXPECT_TRUE(std::string(stopped().what()).starts_with("slide '01-ball': ball: step "))
        << stopped().what();
}

TEST_F(MakeDeck, MoreWordsThanFitAreReported) {
    Slide& slide = add(Exhibit::none);
    slide.title = "Many *words*";
    slide.place.line = 7;
    deck.files = {"talk.toml"};
    for (int i = 0; i < 15; ++i) slide.text += "\n\nA paragraph.";
    EXPECT_TRUE(makeDeck(deck, making).diagnostics.empty());
    for (int i = 0; i < 15; ++i) deck.slides[0].text += "\n\nA paragraph.";
    EXPECT_EQ(makeDeck(deck, making).diagnostics,
              std::vector<std::string>{
                  "talk.toml:7: slide 1, 'Many words': about 43 lines of the smallest letters, "
                  "but only 24 fit; leave some out, or make two slides"});
}

TEST_F(MakeDeck, AmongSeveralADivergedRunIsMarked) {
    Slide& slide = add(Exhibit::none);
    slide.runs.settings = {"world.gravity=[0,0,0]"};
    slide.runs.vary = {"body.ball.velocity=[0,0,0],[9999,0,0]"};
    slide.until = 12.0;
    slide.measures = true;
    const MadeDeck compared = makeDeck(deck, making);
    EXPECT_EQ(compared.incident, "");
    EXPECT_TRUE(compared.compared.starts_with("slide '01-ball': ")) << compared.compared;
    EXPECT_NE(compared.compared.find("[9999,0,0]: ball: step 60"), std::string::npos)
        << compared.compared;
    const MadeTable& table = compared.slides.front().tables.front();
    EXPECT_EQ(table.rows[0][0].find("(diverged)"), std::string::npos);
    EXPECT_NE(table.rows[1][0].find("(diverged)"), std::string::npos);
    deck.slides.front().text = "@{1.speed}";
    EXPECT_EQ(made().slide.text, "0\u00a0m/s");
    deck.slides.front().text = "@{2.speed}";
    EXPECT_EQ(made().slide.text, "10\u00a0km/s");
    deck.slides.front().text = "@{3.speed}";
    EXPECT_NE(std::string(stopped().what()).find("run 3; the slide has 2 runs"), std::string::npos);
}

TEST_F(MakeDeck, ARunIsGoodUntilItDivergesOnWhicheverSlide) {
    Slide& early = add(Exhibit::none);
    early.runs.settings = {"world.gravity=[0,0,0]"};
    early.runs.vary = {"body.ball.velocity=[9999,0,0],[1,0,0]"};
    early.until = 1.0;
    early.text = "@{1.speed}";
    Slide late = early;
    late.until = 12.0;  // 100 km are passed at 10 s
    late.text.clear();
    late.measures = true;
    deck.slides.push_back(late);
    const MadeDeck made = makeDeck(deck, making);
    EXPECT_EQ(made.slides[0].slide.text, "10\u00a0km/s");
    EXPECT_NE(made.slides[1].tables.front().rows[0][0].find("(diverged)"), std::string::npos);
}

/// Also by a signal that comes while nothing checks for it, as between a page and its PDF.
TEST_F(MakeDeck, AChildProgramEndsWithAnInterruption) {
    watchSignals();
    std::raise(SIGTERM);
    try {
        runChild({"sleep", "1000"}, folder / "words", std::chrono::minutes(10));
        ADD_FAILURE() << "it was not interrupted";
    } catch (const Stop& stop) {
        EXPECT_EQ(stop.code(), Exit::interrupted);
    }
    watchSignals();
}

TEST_F(MakeDeck, AnInterruptedFilmLeavesNothing) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    Slide& slide = add(Exhibit::film);
    const Options options = optionsOf(slide, deck, making);
    const auto plan = planSlide(slide, deck, loadRuns(slide, options), options, true);
    Progress progress(making.options, static_cast<int>(plan->frames.size()), 0);
    watchSignals();
    std::raise(SIGTERM);
    try {
        std::string incident;
        madeFilm(*plan, folder / "film.mp4", {1, progress, incident});
        ADD_FAILURE() << "it was not interrupted";
    } catch (const Stop& stop) {
        EXPECT_EQ(stop.code(), Exit::interrupted);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
    watchSignals();
}

}  // namespace
}  // namespace demos::test
