/// 'impulse slides': the files that are written, what is refused, and a browser that is missing,
/// hangs or prints too little.
#include <sys/syscall.h>

#include "render/encode/program_path.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

const std::string kDeck = R"(format = 1
title = "Falling"
size = [160, 90]
fps = 10
[[slide]]
title = "It falls"
scene = "ball.toml"
until = 0.5
notes = "Look at @{body.ball.height}."
[[slide]]
title = "Words"
text = "A row: $J v + b = 0$"
)";

class SlidesCommand : public testing::Test {
protected:
    SlidesCommand() {
        write(folder / "ball.toml", kBall);
        write(folder / "talk.toml", kDeck);
    }
    Ended slides(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "slides");
        return run(folder.path(), std::move(arguments));
    }
    /// Makes this shell script the only browser in PATH; empty: no browser.
    Ended slidesWithBrowser(const std::string& script, std::vector<std::string> arguments) {
        const fs::path programs = folder / "programs";
        fs::create_directory(programs);
        if (const auto ffmpeg = render::programPath("ffmpeg"))
            fs::create_symlink(*ffmpeg, programs / "ffmpeg");
        if (!script.empty()) {
            write(programs / "chromium", "#!/bin/sh\n" + script + "\n");
            fs::permissions(programs / "chromium", fs::perms::owner_all);
        }
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = std::move(arguments);
        launch.arguments.insert(launch.arguments.begin(), "slides");
        launch.beforeExec = [this, path = programs.string()] {
            setenv("PATH", path.c_str(), 1);
            setenv("IMPULSE_CHROMIUM_PATIENCE_MS", patience_.c_str(), 1);
        };
        return run(launch);
    }
    TemporaryFolder folder;
    std::string patience_ = "300";  // ms
};

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST_F(SlidesCommand, MakesAPageOfADeck) {
    if (!render::programPath("ffmpeg")) GTEST_SKIP() << "no ffmpeg: install it";
    const Ended ended = slides({"talk.toml"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(has(ended.out, "wrote output/talk.html (3 slides, 1 film, ")) << ended.out;
    EXPECT_TRUE(has(ended.out, "next: open output/talk.html in a browser; ? shows the keys"));
    const std::string page = contentOf(folder / "output/talk.html");
    EXPECT_TRUE(has(page, "<title>Falling</title>"));
    EXPECT_TRUE(has(page, "data:video/mp4;base64,"));
    EXPECT_TRUE(has(page, "data-fps=\"10\" data-frames=\"6\" data-first=\"0\" data-step=\"0.1\""));
    EXPECT_TRUE(has(page, "Look at 1.7"));  // 3 m - g t^2 / 2, and half a step's fall
    EXPECT_TRUE(has(page, "<math"));
}

TEST_F(SlidesCommand, MakesAPageOfScenesAndSaysSoInJson) {
    const Ended ended = slides({"ball.toml", "-o", "deep/a.html", "--size", "160x90", "--fps", "10",
                                "--seconds", "0.5", "--theme", "dark", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(has(ended.out, R"({"event":"slides","file":"deep/a.html","slides":)")) << ended.out;
    EXPECT_TRUE(has(contentOf(folder / "deep/a.html"), "<body data-theme=\"dark\">"));
}

TEST_F(SlidesCommand, AFolderIsReplacedWhenAskedTo) {
    EXPECT_EQ(slides({"talk.toml", "-o", "talk/", "--quiet"}).code, 0);
    const std::string first = contentOf(folder / "talk/sections.json");
    EXPECT_TRUE(has(first, "\"index.html\""));
    write(folder / "talk/mine.txt", "mine");
    const Ended refused = slides({"talk.toml", "-o", "talk"});
    EXPECT_EQ(refused.code, 5);
    EXPECT_EQ(refused.err,
              "impulse: 'talk' has files already; --overwrite replaces those that impulse slides "
              "made\n");
    const Ended again = slides({"talk.toml", "-o", "talk/", "--overwrite"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_TRUE(has(again.out, "next: open talk/index.html in a browser"));
    EXPECT_EQ(contentOf(folder / "talk/sections.json"), first);
    EXPECT_EQ(contentOf(folder / "talk/mine.txt"), "mine");
    fs::remove(folder / "talk/sections.json");
    EXPECT_EQ(slides({"talk.toml", "-o", "talk/", "--overwrite"}).code, 5);
}

TEST_F(SlidesCommand, NothingTakesThePlaceOfWhatIsThere) {
    write(folder / "a.html", "mine");
    EXPECT_EQ(slides({"talk.toml", "-o", "a.html"}).code, 5);
    fs::create_hard_link(folder / "ball.toml", folder / "b.html");
    const Ended ended = slides({"talk.toml", "-o", "b.html", "--overwrite"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(has(ended.err, "the deck reads this file")) << ended.err;
    EXPECT_EQ(contentOf(folder / "a.html"), "mine");
    EXPECT_EQ(contentOf(folder / "b.html"), kBall);
}

TEST_F(SlidesCommand, RefusesWhatCannotBeMeant) {
    const std::pair<std::vector<std::string>, std::string> cases[] = {
        {{"talk.toml", "-o", "a.odp"}, "known are: .html .pdf .pptx and / of a folder"},
        {{"talk.toml", "-o", "a.html", "-o", "./a.html"}, "another --output goes there already"},
        {{"talk.toml", "-o", "a/", "-o", "a/../a//"}, "another --output goes there already"},
        {{"talk.toml", "stack"}, "'talk.toml' is a deck; it takes no other scene or deck"},
        {{"talk.toml", "--set", "world.hz=120"}, "--set is for scenes"},
        {{"talk.toml", "--seconds", "1"}, "--seconds is for scenes"},
        {{"stack", "talk.toml"}, "'talk.toml' is a deck; it takes no other scene or deck"},
        {{"talk.toml", "-o", "fold.pdf"}, "a folder is there; write to another name"},
        {{"talk.toml", "-o", "fold.html"}, "a folder is there; write to another name"},
        {{"talk.toml", "--size", "63x10"}, "must be even, 64 to 8192 pixels"},
        {{"talk.toml", "--size", "1281x720"}, "must be even, 64 to 8192 pixels"},
        {{"talk.toml", "--size", "16384x720"}, "must be even, 64 to 8192 pixels"},
        {{"talk.toml", "--theme", "blue"}, "studio, dark, print\n"},
        {{"stack", "--theme", "transparent"}, "slides need a ground"}};
    fs::create_directory(folder / "fold.pdf");
    fs::create_directory(folder / "fold.html");
    for (const auto& [arguments, why] : cases) {
        const Ended ended = slides(arguments);
        EXPECT_EQ(ended.code, 2) << why;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_TRUE(has(ended.err, why)) << ended.err;
    }
    EXPECT_TRUE(fs::is_empty(folder / "fold.pdf") && fs::is_empty(folder / "fold.html"));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 4);
}

TEST_F(SlidesCommand, ADryRunWritesNothing) {
    const Ended ended = slides({"talk.toml", "-n", "-o", "a.html", "-o", "a/"});
    EXPECT_EQ(ended.out,
              "talk: 3 slides, 1 film, 0 pictures\nwould write a.html\nwould write a/\n");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST_F(SlidesCommand, WithoutABrowserTheRestIsWritten) {
    const Ended ended = slidesWithBrowser("", {"talk.toml", "-o", "a.pdf", "-o", "a.html"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_TRUE(ended.err.ends_with(
        "\nimpulse: chromium is needed for a PDF; install it (apt install chromium)\n"))
        << ended.err;
    EXPECT_TRUE(
        ended.err.starts_with("no chromium to print PDFs (apt install chromium): "
                              "'a.pdf' will not be made, all other outputs will\n"))
        << ended.err;
    EXPECT_TRUE(has(ended.out, "wrote a.html (3 slides"));
    EXPECT_FALSE(fs::exists(folder / "a.pdf"));
}

TEST_F(SlidesCommand, WithoutABrowserAPdfAloneIsReportedBeforeAnythingIsPlayed) {
    const Ended ended = slidesWithBrowser("", {"talk.toml", "-o", "a.pdf", "-o", "b.pdf"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_EQ(ended.err,
              "impulse: chromium is needed for a PDF; install it (apt install chromium); "
              "-o talk.html and -o talk/ work without it\n");
    EXPECT_EQ(ended.out, "");
}

/// Chromium gets its page as a URL, in which % and # have a meaning.
TEST_F(SlidesCommand, APptxNeedsABrowserThatMeasures) {
    Ended ended = slidesWithBrowser("", {"talk.toml", "-o", "a.pptx", "-o", "b.pptx"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_TRUE(has(ended.err, "impulse: chromium is needed for a .pptx; install it")) << ended.err;
    patience_ = "30000";
    fs::remove_all(folder / "programs");
    ended = slidesWithBrowser("echo '<pre id=\"measured\">e30=</pre>'",
                              {"talk.toml", "-o", "a.pptx"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_TRUE(has(ended.err, "no 'a.pptx': chromium did not say where the parts of the slides"))
        << ended.err;
    EXPECT_FALSE(fs::exists(folder / "a.pptx"));
}

TEST_F(SlidesCommand, ABrowserFindsItsPageWhateverTheTemporaryFolderIsCalled) {
    const fs::path place = folder / "100 % of #1?";
    fs::create_directory(place);
    const std::string script = "for a; do last=$a; done; echo \"$last\" > '" +
                               (folder / "asked").string() + "'; echo no luck; exit 3";
    setenv("TMPDIR", place.c_str(), 1);
    const Ended ended = slidesWithBrowser(script, {"talk.toml", "-o", "a.pdf", "-o", "b.pdf"});
    unsetenv("TMPDIR");
    const std::string asked = contentOf(folder / "asked");
    EXPECT_TRUE(has(asked, "/100%20%25%20of%20%231%3F/impulse_")) << asked;
    EXPECT_TRUE(asked.starts_with("file:///") && asked.ends_with("/talk.html\n")) << asked;
    EXPECT_TRUE(ended.err.ends_with(
        "\nimpulse: no 'a.pdf': chromium stopped with status 3: no luck; no 'b.pdf': chromium "
        "stopped with status 3: no luck\n"))
        << ended.err;
}

TEST_F(SlidesCommand, ABrowserThatFailsIsReportedAndLeavesNothing) {
    const std::pair<std::string, std::string> cases[] = {
        {"exit 3", "no 'a.pdf': chromium stopped with status 3"},
        {"exit 0", "no 'a.pdf': chromium printed nothing"},
        {"for a; do case $a in --print-to-pdf=*) echo '/Type /Page' > ${a#*=};; esac; done",
         "no 'a.pdf': chromium printed 1 page of 3 slides"},
        {"while :; do :; done", "no 'a.pdf': chromium took more than 0.3 s and was killed"}};
    for (const auto& [script, line] : cases) {
        const Ended ended = slidesWithBrowser(script, {"talk.toml", "-o", "a.pdf"});
        EXPECT_EQ(ended.code, 4);
        EXPECT_TRUE(ended.err.ends_with("\nimpulse: " + line + "\n")) << ended.err;
        EXPECT_FALSE(fs::exists(folder / "a.pdf"));
        fs::remove_all(folder / "programs");
    }
}

/// Processes that a browser started end with it.
TEST_F(SlidesCommand, AHangingBrowserIsEndedWithItsChildren) {
    const Ended ended = slidesWithBrowser("(while :; do :; done) & echo $! > child\nwait",
                                          {"talk.toml", "-o", "a.pdf"});
    EXPECT_EQ(ended.code, 4);
    const std::string number = contentOf(folder / "child");
    ASSERT_FALSE(number.empty());
    const auto child = static_cast<int>(syscall(SYS_pidfd_open, std::stoi(number), 0));
    if (child < 0) return;  // gone already
    pollfd end = {child, POLLIN, 0};
    EXPECT_EQ(poll(&end, 1, 10'000), 1) << "it still runs";
    close(child);
}

TEST_F(SlidesCommand, AnInterruptedPrintSaysHowToMakeTheDeckAgain) {
    patience_ = "600000";
    const Ended ended = slidesWithBrowser("kill -TERM $PPID; while :; do :; done",
                                          {"talk.toml", "-o", "a/", "-o", "a.pdf"});
    EXPECT_EQ(ended.code, 130);
    EXPECT_TRUE(
        ended.err.ends_with("impulse: interrupted while printing 'a.pdf'; to make the deck "
                            "again: impulse slides talk.toml -o a/ -o a.pdf\n"))
        << ended.err;
    EXPECT_TRUE(fs::exists(folder / "a/index.html"));
    EXPECT_FALSE(fs::exists(folder / "a.pdf"));
}

TEST_F(SlidesCommand, PrintsAPageASlide) {
    if (!render::programPath("chromium")) GTEST_SKIP() << "no chromium: install it";
    const Ended ended = slides({"talk.toml", "-o", "deep/a.pdf"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(has(ended.out, "wrote deep/a.pdf (3 slides, "));
    EXPECT_TRUE(has(ended.out, "next: open deep/a.pdf\n"));
    EXPECT_TRUE(contentOf(folder / "deep/a.pdf").starts_with("%PDF-"));
}

TEST_F(SlidesCommand, AnIncidentIsCode6AndTheDeckIsWhole) {
    write(folder / "ball.toml", kFastBall);
    const Ended ended = slides({"talk.toml", "-o", "talk.html"});
    EXPECT_EQ(ended.code, 6) << ended.err;
    EXPECT_TRUE(has(ended.err, "impulse: slide '02-it-falls': ball: step 1 (t = 0.017 s): body"))
        << ended.err;
    EXPECT_TRUE(has(ended.out, "wrote talk.html (3 slides")) << ended.out;
}

}  // namespace
}  // namespace demos::test
