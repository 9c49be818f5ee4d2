// The sections of a scene are chapters of its film, also when it was drawn in parts.
#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

const std::string kSections = "[[section]]\nat = 0.2\nname = 'a = b; #1 \\'\n"
                              "[[section]]\nat = 0.61\ncaption = 'è un balzo'\n"
                              "[[section]]\nat = 1.0\nname = 'after the film'\n";

class Chapters : public SmallFilm {
protected:
    void SetUp() override {
        if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
        write(folder / "ball.toml", kBall + kSections);
    }
    /// "0.000000|0.200000|a ball", a line per chapter.
    std::string chaptersOf(const std::string& film) {
        const std::string command =
            "cd '" + folder.path().string() + "' && ffprobe -v error -show_entries " +
            "chapter=start_time,end_time:chapter_tags=title -of compact=nk=1:p=0:e=none " +
            film + " > chapters";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return contentOf(folder / "chapters");
    }
};

TEST_F(Chapters, AreTheSectionsAndTwoRunsGiveTheSameBytes) {
    const Ended ended = film({"-o", "one.mp4", "-o", "one.webm"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(chaptersOf("one.mp4"), "0.000000|0.200000|a ball\n"
                                     "0.200000|0.700000|a = b; #1 \\ \n"
                                     "0.700000|1.000000|è un balzo\n");
    EXPECT_EQ(chaptersOf("one.webm"), chaptersOf("one.mp4"));
    EXPECT_EQ(playableFrames(folder / "one.mp4"), kFrames);
    ASSERT_EQ(film({"-o", "two.mp4"}).code, 0);
    EXPECT_TRUE(contentOf(folder / "one.mp4") == contentOf(folder / "two.mp4"));
}

TEST_F(Chapters, HaveTheTimesOfTheFilmAndNotOfTheScene) {
    ASSERT_EQ(film({"-o", "some.mp4", "--frames", "4..9:2", "--max-size", "1M"}).code, 0);
    EXPECT_EQ(chaptersOf("some.mp4"), "0.000000|0.200000|a = b; #1 \\ \n"
                                      "0.200000|0.300000|è un balzo\n");
}

TEST_F(Chapters, AreThoseOfTheWholeFilmAfterAJoin) {
    ASSERT_EQ(film({"-o", "one.mp4"}).code, 0);
    for (const char* part : {"1/2", "2/2"})
        ASSERT_EQ(film({"-o", "film.mp4", "--shard", part}).code, 0);
    EXPECT_EQ(chaptersOf("film.parts/002-of-002.mp4"), "");
    const Ended joined = run(folder.path(), {"join", "film.parts"});
    ASSERT_EQ(joined.code, 0) << joined.err;
    EXPECT_EQ(chaptersOf("film.mp4"), chaptersOf("one.mp4"));
    EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames);
    EXPECT_NE(chaptersOf("film.mp4"), "");
}

}  // namespace
}  // namespace demos::test
