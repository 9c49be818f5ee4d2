// A talk as a folder: for LaTeX, for Marp, for programs; complete or not at all, and other files
// are not touched.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "demos/processes/folder_lock.h"
#include "demos/slides/deck_files.h"
#include "demos/slides/sections_json.h"
#include "demos/text/file_content.h"
#include "demos/text/stop.h"
#include "render/encode/program_path.h"
#include "render/error.h"
#include "tests/support/planted_deck.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

namespace {

using namespace demos;
namespace fs = std::filesystem;
using support::count;
using support::plantedDeck;
using support::saved;

std::string textOf(const fs::path& path) {
    const std::vector<std::uint8_t> bytes = contentOf(path);
    return {bytes.begin(), bytes.end()};
}

class SlidesFolder : public testing::Test {
protected:
    SlidesFolder() { saved(folder_ / "film", std::string("film")); }
    MadeDeck deck() const { return plantedDeck(folder_ / "film"); }
    fs::path talk() const { return folder_ / "deep/talk"; }
    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_ / "deep"))
            if (!entry.is_directory())
                names.insert(fs::relative(entry.path(), talk()).generic_string());
        return names;
    }
    support::TemporaryFolder folder_;
};

const std::set<std::string> kFiles = {"index.html",
                                      "notes.md",
                                      "talk.tex",
                                      "talk.md",
                                      "sections.json",
                                      "media/02-waits.mp4",
                                      "media/02-waits.png",
                                      "media/03-loops.mp4",
                                      "media/03-loops.png",
                                      "media/03-loops-2.png",
                                      "media/03-loops-2.svg"};

TEST_F(SlidesFolder, WhatAnotherRunHasPutThereMeanwhileIsKept) {
    writeSlidesFolder(deck(), talk(), false);
    EXPECT_THROW(writeSlidesFolder(deck(), talk(), false), Stop);
}

// A run that failed between its list and its last file is finished without --overwrite.
TEST_F(SlidesFolder, AnUnfinishedOneIsFinished) {
    writeSlidesFolder(deck(), talk(), false);
    fs::remove(talk() / "media/02-waits.mp4");
    writeSlidesFolder(deck(), talk(), false);
    EXPECT_EQ(files(), kFiles);
}

TEST_F(SlidesFolder, HoldsWhatItSaysAndNothingElse) {
    const std::vector<fs::path> names = writeSlidesFolder(deck(), talk() / "");
    std::set<std::string> said;
    for (const fs::path& name : names) said.insert(name.generic_string());
    EXPECT_EQ(said, kFiles);
    EXPECT_EQ(files(), kFiles);
    EXPECT_EQ(textOf(talk() / "media/02-waits.mp4"), "film");
    EXPECT_EQ(contentOf(talk() / "media/03-loops-2.png"), deck().slides[2].pictures[0].png);
}

TEST_F(SlidesFolder, SectionsTellProgramsWhatThereIs) {
    writeSlidesFolder(deck(), talk());
    const auto json = nlohmann::json::parse(textOf(talk() / "sections.json"));
    EXPECT_EQ(json["made_by"], "impulse slides");
    EXPECT_EQ(json["files"].size(), kFiles.size());
    ASSERT_EQ(json["slides"].size(), 4u);
    EXPECT_EQ(json["slides"][0]["notes"], "Be **calm**.");
    EXPECT_FALSE(json["slides"][0].contains("file"));
    EXPECT_EQ(json["slides"][1]["file"], "media/02-waits.mp4");
    EXPECT_EQ(json["slides"][1]["pause"], true);
    EXPECT_EQ(json["slides"][2]["loop"], true);
    EXPECT_EQ(json["slides"][2]["poster"], "media/03-loops.png");
}

TEST_F(SlidesFolder, AListOfManyFilesIsReadQuickly) {
    writeSlidesFolder(deck(), talk());
    auto json = nlohmann::json::parse(textOf(talk() / "sections.json"));
    for (int i = 0; i < 90'000; ++i) json["files"].push_back("media/x" + std::to_string(i));
    saved(talk() / "sections.json", json.dump());
    writeSlidesFolder(deck(), talk());  // took minutes
    EXPECT_EQ(files(), kFiles);
}

TEST_F(SlidesFolder, AgainReplacesItsOwnAndTakesAwayWhatIsNotNeededAnyMore) {
    writeSlidesFolder(deck(), talk());
    saved(talk() / "mine.txt", std::string("mine"));
    MadeDeck shorter = deck();
    shorter.slides.erase(shorter.slides.begin() + 1);
    writeSlidesFolder(shorter, talk());
    std::set<std::string> left = kFiles;
    left.erase("media/02-waits.mp4");
    left.erase("media/02-waits.png");
    left.insert("mine.txt");
    EXPECT_EQ(files(), left);
}

TEST_F(SlidesFolder, SomebodyElsesFileStaysAndNothingIsWritten) {
    fs::create_directories(talk() / "media");
    for (const char* name : {"notes.md", "media/02-waits.png"}) {
        saved(talk() / name, std::string("mine"));
        try {
            writeSlidesFolder(deck(), talk());
            ADD_FAILURE() << name;
        } catch (const Stop& stop) {
            EXPECT_EQ(stop.code(), Exit::wouldOverwrite);
            EXPECT_NE(std::string(stop.what()).find(name), std::string::npos);
        }
        EXPECT_EQ(files(), std::set<std::string>{name});
        EXPECT_EQ(textOf(talk() / name), "mine");
        fs::remove(talk() / name);
    }
}

TEST_F(SlidesFolder, AListThatPointsOutsideIsNotFollowed) {
    writeSlidesFolder(deck(), talk());
    saved(folder_ / "deep/outside", std::string("mine"));
    fs::create_directory_symlink(folder_ / "deep", talk() / "link");
    saved(talk() / "sections.json",
          std::string(R"({"made_by":"impulse slides","files":["../outside","/etc/x","",7,"a/./b",)"
                      R"("link/outside","media/../../outside","media/","media/..",".."]})"));
    EXPECT_TRUE(listedFiles(talk()).empty());
    for (const auto& entry : fs::directory_iterator(talk()))
        if (entry.path().filename() != "sections.json" && entry.path().filename() != "link")
            fs::remove_all(entry.path());
    EXPECT_THROW(writeSlidesFolder(deck(), talk()), Stop);  // sections.json is no longer recognized
    fs::remove(talk() / "sections.json");
    writeSlidesFolder(deck(), talk());
    EXPECT_EQ(textOf(folder_ / "deep/outside"), "mine");
    saved(talk() / "sections.json", std::string(R"({"made_by":"me","files":["notes.md"]})"));
    EXPECT_TRUE(listedFiles(talk()).empty());
    saved(talk() / "sections.json", std::string("no JSON"));
    EXPECT_TRUE(listedFiles(talk()).empty());
}

/// Files outside of the folder are not removed, even if the list names them.
TEST_F(SlidesFolder, WhatIsTakenAwayIsOfTheFolder) {
    writeSlidesFolder(deck(), talk());
    saved(folder_ / "deep/outside", std::string("mine"));
    fs::create_directory_symlink(folder_ / "deep", talk() / "link");
    auto json = nlohmann::json::parse(textOf(talk() / "sections.json"));
    json["files"].push_back("link/outside");
    json["files"].push_back("../outside");
    saved(talk() / "sections.json", json.dump());
    writeSlidesFolder(deck(), talk());
    EXPECT_EQ(textOf(folder_ / "deep/outside"), "mine");
}

TEST_F(SlidesFolder, MediaThatIsALinkIsRefused) {
    writeSlidesFolder(deck(), talk());
    fs::rename(talk() / "media", folder_ / "elsewhere");
    fs::create_directory_symlink(folder_ / "elsewhere", talk() / "media");
    MadeDeck shorter = deck();
    shorter.slides.resize(1);
    EXPECT_THROW(writeSlidesFolder(shorter, talk()), render::Error);
    EXPECT_THROW(checkSlidesFolder(talk(), true), render::Error);
    EXPECT_TRUE(fs::exists(folder_ / "elsewhere/02-waits.mp4"));
}

TEST_F(SlidesFolder, MayBeALinkToAnotherDisk) {
    fs::create_directories(folder_ / "disk");
    fs::create_directories(folder_ / "deep");
    fs::create_directory_symlink(folder_ / "disk", talk());
    writeSlidesFolder(deck(), talk());
    EXPECT_TRUE(fs::is_symlink(talk()));
    EXPECT_EQ(textOf(folder_ / "disk/media/02-waits.mp4"), "film");
}

TEST_F(SlidesFolder, DraftsOfKilledRunsGoAndHideNothing) {
    fs::create_directories(talk() / ".impulse-slides.tmp123/media");
    saved(talk() / ".impulse-slides.tmp123/media/02-waits.mp4", std::string("half"));
    EXPECT_NO_THROW(checkSlidesFolder(talk(), false));
    writeSlidesFolder(deck(), talk());
    EXPECT_EQ(files(), kFiles);
    EXPECT_FALSE(fs::exists(talk() / ".impulse-slides.tmp123"));
}

TEST_F(SlidesFolder, IsOfOneRunAtATime) {
    fs::create_directories(talk());
    const FolderLock other(talk());
    try {
        writeSlidesFolder(deck(), talk());
        ADD_FAILURE() << "written";
    } catch (const Stop& stop) {
        EXPECT_EQ(stop.code(), Exit::wouldOverwrite);
    }
    EXPECT_TRUE(fs::is_empty(talk()));
}

TEST_F(SlidesFolder, AFilmThatCannotBeReadLeavesNothingBehind) {
    fs::remove(folder_ / "film");
    EXPECT_THROW(writeSlidesFolder(deck(), talk()), render::Error);
    EXPECT_TRUE(fs::is_empty(folder_ / "deep"));
}

TEST_F(SlidesFolder, WhatCanBeKnownBeforeTheMaking) {
    EXPECT_NO_THROW(checkSlidesFolder(talk(), false));
    writeSlidesFolder(deck(), talk());
    EXPECT_THROW(checkSlidesFolder(talk(), false), Stop);
    EXPECT_NO_THROW(checkSlidesFolder(talk() / "", true));
    fs::remove(talk() / "sections.json");
    EXPECT_THROW(checkSlidesFolder(talk(), true), Stop);
    EXPECT_THROW(checkSlidesFolder(folder_ / "film", true), render::Error);
}

TEST_F(SlidesFolder, NotesAreReadInTheirOrder) {
    const std::string notes = speakerNotesOf(deck());
    EXPECT_EQ(notes,
              "# A talk\n\n## 1. A talk\n\nBe **calm**.\n\n## 2. It waits\n\n    impulse render "
              "stack\n\n## 3. It loops\n\n## 4. Words\n\nThe last.\n");
}

/// Rules separate slides, and no text contains a rule.
TEST_F(SlidesFolder, MarpHasASlideForEach) {
    MadeDeck made = deck();
    made.slides[3].slide.text = "before\n\n---\n\n* * *\n\nafter";
    made.deck.date = "24. 12. 2026";
    made.deck.author = "$-Soft <b>";
    made.slides[3].slide.notes = "a --> b";
    const std::string text = marpOf(made);
    EXPECT_TRUE(text.starts_with("---\nmarp: true\ntitle: \"A talk\"\n"));
    EXPECT_EQ(count(text, "\n---\n"), 1 + 3);
    EXPECT_EQ(count(text, "* * *"), 0);
    EXPECT_EQ(count(text, "\n24\\. 12. 2026\n"), 1);
    EXPECT_EQ(count(text, "\n\\$-Soft \\<b\\>\n"), 1);
    EXPECT_EQ(count(text, "<!--\n"), count(text, "-->\n"));
    EXPECT_EQ(count(text, "a -- > b"), 1);
    EXPECT_EQ(count(text, "$$\n\\lambda = -\\frac{J v + b}{J M^{-1} J^T}\n$$\n"), 1);
    EXPECT_EQ(count(text, "![bg right:55% contain a grey field](media/03-loops-2.svg)"), 1);
    EXPECT_EQ(count(text,
                    "<video src=\"media/03-loops.mp4\" poster=\"media/03-loops.png\" controls "
                    "muted loop></video>"),
              1);
    EXPECT_EQ(count(text, "| case | drift |\n|---|---:|\n| 20 sweeps | 12.3 mm |\n"), 1);
    EXPECT_EQ(count(text, "| a\\_b & c | -0.4 mm |"), 1);
}

/// Raw HTML would be active, and external pictures would need the network.
TEST_F(SlidesFolder, MarpShowsHtmlAsText) {
    const std::string hostile =
        "a <script>x</script> <img src=http://a.b/c> <!-- n --> "
        "![d](http://a.b/e)";
    MadeDeck made = deck();
    const std::string harmless = marpOf(made);
    made.deck.subtitle = hostile;
    for (MadeSlide& slide : made.slides) slide.slide.text = slide.slide.caption = hostile;
    made.slides[1].slide.title = hostile;
    const std::string text = marpOf(made);
    EXPECT_EQ(count(text, "\\<script\\>x\\</script\\>"), 10);
    EXPECT_EQ(count(text, "<script"), 10);
    EXPECT_EQ(count(text, "<img"), count(text, "\\<img"));
    EXPECT_EQ(count(text, "]("), count(harmless, "]("));
    EXPECT_EQ(count(text, "<!--"), count(harmless, "<!--"));
    EXPECT_EQ(count(text, "\\<\\!-- n --\\>"), 10);
}

TEST_F(SlidesFolder, MarpKeepsWhatOnlyLooksLikeARule) {
    MadeDeck made = deck();
    made.slides[3].slide.text = "Head\n---\n\n```\n---\n```\n\n- a\n\n1. b";
    const std::string text = marpOf(made);
    EXPECT_EQ(count(text, "## Head\n"), 1);
    EXPECT_EQ(count(text, "\n---\n```\n"), 1);
    EXPECT_EQ(count(text, "end list"), 0);
    EXPECT_EQ(count(text, "\n[//]: #\n"), 1);
}

TEST_F(SlidesFolder, BeamerHasAFrameForEachAndEscapesWhatLatexReads) {
    MadeDeck steps = deck();
    steps.slides[2].slide.reveal = true;
    EXPECT_EQ(count(beamerOf(steps), "\\begin{itemize}[<+(1)->]"), 1);
    EXPECT_EQ(count(marpOf(steps), "\n  * words\n  * beside\n"), 1);
    const std::string latex = beamerOf(deck());
    EXPECT_EQ(count(latex, "\\begin{frame}"), 4);
    for (const char* what : {"frame", "columns", "tabular", "flushleft", "itemize", "document"})
        EXPECT_EQ(count(latex, std::string("\\begin{") + what + "}"),
                  count(latex, std::string("\\end{") + what + "}"))
            << what;
    int depth = 0;
    for (std::size_t i = 0; i < latex.size(); ++i) {
        if (latex[i] == '\\')
            ++i;
        else
            depth += latex[i] == '{' ? 1 : latex[i] == '}' ? -1 : 0;
        ASSERT_GE(depth, 0) << latex.substr(0, i);
    }
    EXPECT_EQ(depth, 0);
    EXPECT_EQ(count(latex, "\\href{run:media/02-waits.mp4}{\\includegraphics["), 1);
    EXPECT_EQ(count(latex, "]{media/03-loops-2.png}"), 1);
    EXPECT_EQ(count(latex, "\\fit{$\\displaystyle \\lambda = -\\frac{J v + b}{J M^{-1} J^T}$}"), 1);
    EXPECT_EQ(count(latex, "a\\_b \\& c"), 1);
    EXPECT_EQ(count(latex, "\\note{The last."), 1);
}

TEST_F(SlidesFolder, BeamersOpeningHasItsWordsBesideAPicture) {
    MadeDeck made = deck();
    made.slides[0].slide.text = "first words";
    made.slides[0].slide.formulas = {"E = m c^2"};
    made.slides[0].slide.code = "line()";
    made.slides[0].tables = made.slides[3].tables;
    made.slides[0].pictures.push_back(support::plantedDeckPicture(90, 50, 200));
    const std::string all = beamerOf(made);
    const std::string frame = all.substr(all.find("\\titlepage"));
    const std::string latex = frame.substr(0, frame.find("\\end{frame}"));
    for (const char* what : {"first words", "E = m c^2", "line()", "12.3 mm", "media/01-opening"})
        EXPECT_EQ(count(latex, what), 1) << what;
}

TEST_F(SlidesFolder, BeamerDeclaresWhatPdfLatexLacks) {
    MadeDeck made = deck();
    EXPECT_EQ(count(beamerOf(made), "DeclareUnicodeCharacter"), 0);
    made.slides[3].slide.text = "θ א \xe2\x80\x8b é";
    made.slides[3].slide.formulas = {"x = y \\tag{1}",
                                     "\\begin{split} x &= y\\\\ &= z \\end{split}", "x \\in \\R"};
    const std::string latex = beamerOf(made);
    EXPECT_EQ(count(latex, "\\DeclareUnicodeCharacter{03B8}{\\ensuremath{\\theta}}"), 1);
    EXPECT_EQ(count(latex, "\\otherletter{05D0}{א}{?}"), 1);
    EXPECT_EQ(count(latex, "\\otherletter{200B}{\xe2\x80\x8b}{}"), 1);
    EXPECT_EQ(count(latex, "\\[x = y \\tag{1}\\]"), 1);
    EXPECT_EQ(count(latex, "\\[\\begin{split} x &= y\\\\ &= z \\end{split}\\]"), 1);
    EXPECT_EQ(count(latex, "\\providecommand{\\R}{\\mathbb{R}}"), 1);
}

TEST_F(SlidesFolder, LatexTypesetsIt) {
    if (!render::programPath("pdflatex"))
        GTEST_SKIP() << "no pdflatex: install texlive-latex-recommended and lmodern";
    MadeDeck made = deck();
    made.slides[3].slide.text += " µ − × 2² [x] ~ # ^ \\ \"quoted\" & 100%";
    made.slides[3].slide.text += " θ Ж א 😀 \xe2\x80\x8b $θ + \\text{é}$";
    made.slides[3].slide.formulas = {"x \\coloneqq y \\tag{1}",
                                     "\\begin{split} x &= y\\\\ &= z \\end{split}",
                                     "\\lang x \\rang \\colonequals \\argmin \\in \\R"};
    made.slides[0].slide.text = "words";
    made.slides[0].pictures.push_back(support::plantedDeckPicture(90, 50, 200));
    made.slides[3].slide.title = "[Brackets] & 50 % of {it}";
    made.slides[3].slide.code = "[a]\n\n  b = \"x\" \\ % # & ~ ^ _ {}";
    made.slides[3].tables[0].rows.push_back({"[a]", "5 %"});
    writeSlidesFolder(made, talk());
    const std::string command = "cd '" + talk().string() +
                                "' && pdflatex -halt-on-error -interaction=nonstopmode talk.tex"
                                " >log 2>&1 && grep -q '(4 pages' log";
    EXPECT_EQ(std::system(command.c_str()), 0) << textOf(talk() / "log");
}

}  // namespace
