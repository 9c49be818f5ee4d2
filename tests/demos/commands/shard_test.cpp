// A film in parts, drawn in any order, repeatedly, with kills in between: joined, it equals the
// film of one run.
#include <nlohmann/json.hpp>

#include "tests/demos/small_film.h"

namespace demos::test {
namespace {

class Shards : public SmallFilm {
protected:
    static std::string numbered(int number, int count) {
        return std::to_string(number) + "/" + std::to_string(count);
    }
    Ended join(std::vector<std::string> more) {
        more.insert(more.begin(), "join");
        return run(folder.path(), more);
    }
    /// A hash of every decoded frame.
    std::string frameHashes(const std::string& film) {
        const std::string command =
            "cd '" + folder.path().string() + "' && for f in " + film +
            "; do ffmpeg -v error -i $f -f framemd5 - | grep -v '#' | sed 's/.*,//'; done > hashes";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return contentOf(folder / "hashes");
    }
};

TEST_F(Shards, PngFramesAreThoseOfOneRunInAnyOrder) {
    ASSERT_EQ(film({"-o", "one"}).code, 0);
    for (const int number : {3, 1, 2}) {
        const Ended part = film({"-o", "parts", "--shard", numbered(number, 3)});
        ASSERT_EQ(part.code, 0) << part.err;
    }
    EXPECT_EQ(framesIn(folder / "parts"), framesIn(folder / "one"));
    const Ended joined = join({"parts"});
    EXPECT_EQ(joined.code, 0) << joined.err;
    const Ended again = film({"-o", "parts"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("10 kept"), std::string::npos) << again.out;
}

TEST_F(Shards, AFilmIsItsPartsFrameByFrame) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    for (const int number : {2, 3, 1})
        ASSERT_EQ(film({"-o", "film.mp4", "--shard", numbered(number, 3)}).code, 0);
    const Ended joined = join({"film.parts"});
    ASSERT_EQ(joined.code, 0) << joined.err;
    EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames);
    EXPECT_EQ(frameHashes("film.mp4"), frameHashes("film.parts/*.mp4"));
    EXPECT_EQ(join({"film.parts"}).code, 5);
    EXPECT_EQ(join({"film.parts", "--overwrite"}).code, 0);
    EXPECT_EQ(join({"film.parts", "-o", "film.webm"}).code, 2);
}

TEST_F(Shards, PngFramesBecomeTheFilmOfOneRun) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    write(folder / "ball.toml", std::string(kBall) + "[[section]]\nat = 0.0\nname = 'fall'\n"
                                                     "caption = 'It falls.'\nposter = 'last'\n");
    ASSERT_EQ(film({"-o", "one.gif", "-o", "one.mp4", "--poster", "one.png", "--captions", "one.vtt"}).code, 0);
    for (const int number : {2, 1}) ASSERT_EQ(film({"-o", "p", "--shard", numbered(number, 2)}).code, 0);
    const Ended gif = join({"p", "-o", "all.gif", "--poster", "all.png", "--captions", "all.vtt"});
    ASSERT_EQ(gif.code, 0) << gif.err;
    ASSERT_EQ(join({"p", "-o", "all.mp4"}).code, 0);
    for (const char* ending : {".gif", ".mp4", ".png", ".vtt"})
        EXPECT_EQ(contentOf(folder / (std::string("all") + ending)),
                  contentOf(folder / (std::string("one") + ending)))
            << ending;
    EXPECT_EQ(join({"p", "-o", "small.gif", "--max-size", "1K"}).code, 4);
    EXPECT_FALSE(fs::exists(folder / "small.gif"));
    for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{
             {"-o", "all.avi"}, {"--max-size", "1M"}, {"--poster", "all.jpg"}, {"--captions", "all.srt"}}) {
        std::vector<std::string> words = wrong;
        words.insert(words.begin(), "p");
        EXPECT_EQ(join(words).code, 2) << wrong[1];
    }
    EXPECT_EQ(join({"p", "-o", "all.gif"}).code, 5);
}

TEST_F(Shards, PartsOfAFilmHaveNoPosterAndNoLimit) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    ASSERT_EQ(film({"-o", "film.mp4", "--shard", "1/1"}).code, 0);
    for (const char* option : {"--max-size=1M", "--poster=all.png"}) {
        const Ended joined = join({"film.parts", option});
        EXPECT_EQ(joined.code, 2);
        EXPECT_NE(joined.err.find("need parts of PNG frames"), std::string::npos) << joined.err;
    }
}

/// Replaces a text of a file.
void edit(const fs::path& file, const std::string& from, const std::string& to) {
    std::string text = contentOf(file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << text;
    write(file, text.replace(at, from.size(), to));
}

TEST_F(Shards, ThePrintedCommandReplacesAPartOfAnotherProcessor) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    for (const std::string output : {"frames", "film.mp4"}) {
        for (const int number : {1, 2, 3})
            ASSERT_EQ(film({"-o", output, "--shard", numbered(number, 3)}).code, 0);
        const bool frames = output == "frames";
        edit(folder / (frames ? "frames/run.002-of-003.json" : "film.parts/002-of-003.json"), "\"pixels\": \"",
             "\"pixels\": \"other ");
        const std::string parts = frames ? "frames" : "film.parts";
        const Ended joined = join({parts});
        ASSERT_EQ(joined.code, 7);
        EXPECT_NE(joined.err.find("of another class of processors"), std::string::npos) << joined.err;
        EXPECT_NE(joined.out.find("--shard 2/3"), std::string::npos) << joined.out;
        EXPECT_NE(joined.out.find(" --overwrite"), std::string::npos) << joined.out;
        EXPECT_EQ(film({"-o", output, "--shard", "2/3"}).code, 0);  // complete: as a job file may ask again
        EXPECT_EQ(join({parts}).code, 7);
        EXPECT_EQ(film({"-o", output, "--shard", "2/3", "--overwrite"}).code, 0);
        EXPECT_EQ(join({parts}).code, 0);
    }
}

TEST_F(Shards, APartThatIsReplacedLeavesTheDataOfOthers) {
    const auto part = [&](int number, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"-o", "p", "--pass", "depth", "--shard", numbered(number, 2)};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(film(words).code, 0);
    };
    part(1, {}), part(2, {});
    ASSERT_EQ(join({"p"}).code, 0);
    part(2, {"--overwrite"});
    EXPECT_EQ(namesIn(folder / "p/depth").size(), static_cast<std::size_t>(kFrames));
    EXPECT_EQ(join({"p"}).code, 0);
    fs::remove(folder / "p/depth" / *namesIn(folder / "p/depth").begin());
    const Ended joined = join({"p"});
    EXPECT_EQ(joined.code, 7);
    EXPECT_NE(joined.err.find("damaged or incomplete: 1"), std::string::npos) << joined.err;
    EXPECT_EQ(joined.out.find("--overwrite"), std::string::npos) << joined.out;
}

TEST_F(Shards, APartIsNotResumedOnAnotherProcessor) {
    ASSERT_EQ(film({"-o", "frames", "--shard", "2/2"}).code, 0);
    const fs::path record = folder / "frames/run.002-of-002.json";
    edit(record, "\"pixels\": \"", "\"pixels\": \"other ");
    edit(record, "\"finished\": true", "\"finished\": false");
    const Ended again = film({"-o", "frames", "--shard", "2/2"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(again.out.find(" kept"), std::string::npos) << again.out;
    EXPECT_EQ(contentOf(record).find("other "), std::string::npos);
}

TEST_F(Shards, APartThatIsThereIsNotDrawnAgain) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    ASSERT_EQ(film({"-o", "film.mp4", "--shard", "1/2"}).code, 0);
    const fs::path part = folder / "film.parts/001-of-002.mp4";
    const auto time = fs::last_write_time(part);
    const Ended again = film({"-o", "film.mp4", "--shard", "1/2"});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("is complete already"), std::string::npos) << again.out;
    EXPECT_EQ(fs::last_write_time(part), time);
    EXPECT_EQ(film({"-o", "film.mp4", "--shard", "1/2", "--theme", "dark"}).code, 5);
    EXPECT_EQ(film({"-o", "film.mp4", "--shard", "1/2", "--theme", "dark", "--overwrite"}).code, 0);
}

TEST_F(Shards, JoinNamesWhatIsMissingTornOrOfAnotherRun) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    for (const int number : {1, 2, 4, 5})
        ASSERT_EQ(film({"-o", "film.mp4", "--shard", numbered(number, 5)}).code, 0);
    ASSERT_EQ(film({"-o", "film.mp4", "--shard", "5/5", "--clean", "--overwrite"}).code, 0);
    fs::resize_file(folder / "film.parts/002-of-005.mp4", 100);
    const Ended joined = join({"film.parts"});
    EXPECT_EQ(joined.code, 7);
    EXPECT_EQ(joined.errorLines(), 1);
    for (const char* said :
         {"2 of 5 parts are complete", "missing: 3", "damaged or incomplete: 2", "of another run: 5"})
        EXPECT_NE(joined.err.find(said), std::string::npos) << joined.err;
    EXPECT_NE(joined.out.find("to do: impulse render ball.toml"), std::string::npos) << joined.out;
    EXPECT_NE(joined.out.find("--shard 3/5"), std::string::npos) << joined.out;
    EXPECT_FALSE(fs::exists(folder / "film.mp4"));
}

TEST_F(Shards, WithoutFramesArePartsOfNothing) {
    for (const int number : {1, 2})
        ASSERT_EQ(film({"-o", "frames", "--shard", numbered(number, 2)}).code, 0);
    fs::resize_file(folder / "frames/frame_000000.png", std::uintmax_t{1} << 40);  // sparse
    const Ended large = join({"frames"});
    EXPECT_EQ(large.code, 7) << large.err;
    EXPECT_NE(large.err.find("damaged or incomplete: 1"), std::string::npos) << large.err;
    for (const int number : {1, 2}) {
        const fs::path record = folder / ("frames/run.00" + std::to_string(number) + "-of-002.json");
        std::string text = contentOf(record);
        const std::size_t at = text.find("\"frames\":");
        ASSERT_NE(at, std::string::npos);
        write(record, text.substr(0, at) + "\"frames\":[]}");
    }
    const Ended empty = join({"frames"});
    EXPECT_EQ(empty.code, 7) << empty.out;
}

TEST_F(Shards, AKilledPartIsDrawnAgain) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    for (const char* output : {"film.mp4", "frames"}) {
        Launch launch =
            small(folder.path(), {"-o", output, "--seconds", "60", "--shard", "2/2", "--json"});
        launch.awaited = "\"frame\":400,";
        launch.signal = SIGKILL;
        EXPECT_EQ(run(launch).signal, SIGKILL);
    }
    EXPECT_EQ(join({"frames"}).code, 7);
    const Ended frames = film({"-o", "frames", "--seconds", "60", "--shard", "2/2"});
    EXPECT_EQ(frames.code, 0) << frames.err;
    EXPECT_NE(frames.out.find(" kept"), std::string::npos) << frames.out;
    const Ended part = film({"-o", "film.mp4", "--seconds", "60", "--shard", "2/2"});
    EXPECT_EQ(part.code, 0) << part.err;
    EXPECT_EQ(playableFrames(folder / "film.parts/002-of-002.mp4"), 300);
}

TEST_F(Shards, ForeignRecordsAreReportedAndNothingIsRead) {
    fs::create_directory(folder / "p");
    EXPECT_EQ(join({"p"}).code, 2);
    EXPECT_EQ(join({"none"}).code, 2);
    write(folder / "p/001-of-002.json", std::string(100'000, '['));
    write(folder / "p/run.002-of-002.json", "{}");
    const Ended joined = join({"p"});
    EXPECT_EQ(joined.code, 7);
    EXPECT_NE(joined.err.find("damaged or incomplete: 1 2"), std::string::npos) << joined.err;
    write(folder / "p/001-of-003.json", "{}");
    EXPECT_EQ(join({"p"}).code, 2);
}

TEST_F(Shards, FramesAreNumberedAsTheFilms) {
    ASSERT_EQ(film({"-o", "all"}).code, 0);
    ASSERT_EQ(film({"-o", "some", "--frames", "2..3,-1"}).code, 0);
    Files expected = framesIn(folder / "all");
    std::erase_if(expected, [](const auto& file) {
        return file.first != "frame_000002.png" && file.first != "frame_000003.png" &&
               file.first != "frame_000009.png";
    });
    EXPECT_EQ(framesIn(folder / "some"), expected);
    const Ended rest = film({"-o", "some"});
    EXPECT_NE(rest.out.find("3 kept"), std::string::npos) << rest.out;
    EXPECT_EQ(framesIn(folder / "some"), framesIn(folder / "all"));
}

TEST_F(Shards, AJobFileDrawsTheFilm) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    fs::create_directories(folder / "bin");
    fs::create_symlink(IMPULSE_BINARY, folder / "bin/impulse");
    const std::vector<std::string> words = {"ball.toml", "-o",       "film.mp4", "--size",
                                            "96x54",     "--fps",    "10",       "--samples",
                                            "1",         "--shards", "3"};
    const std::vector<std::string> withStates = {"--states", "its states", "--show", "trails,com", "--set",
                                                 "body.ball.at=[0, 3, 0]"};
    for (const bool states : {false, true}) {
        const std::string engine = states ? "make" : "commands";
        std::vector<std::string> all = {"farm", engine};
        all.insert(all.end(), words.begin(), words.end());
        if (states) all.insert(all.end(), withStates.begin(), withStates.end());
        const Ended job = run(folder.path(), all);
        ASSERT_EQ(job.code, 0) << job.err;
        write(folder / "job", job.out);
        const std::string start = states ? "make -s -f job" : "sh -e job";
        const std::string command = "cd '" + folder.path().string() +
                                    "' && PATH=\"$PWD/bin:$PATH\" " + start + " > log 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << contentOf(folder / "log");
        EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames) << engine;
        const std::string log = contentOf(folder / "log");
        for (const char* first : {"of step 15", "of step 35"})  // before steps 18 and 36, every fifth
            EXPECT_EQ(log.find(std::string("starts from the state ") + first) != log.npos, states) << log;
        fs::remove_all(folder / "film.parts"), fs::remove_all(folder / "its states");
        fs::remove(folder / "film.mp4");
    }
}

/// For engines that are not run here: parts wait for the states.
TEST_F(Shards, APartOfAJobFileWaitsForItsStates) {
    const std::pair<const char*, const char*> waits[] = {
        {"slurm", "--array=1-3 --dependency=afterany:\"${states%%;*}\""},
        {"parallel", "--quiet || [ $? -eq 6 ]\nseq 3 |"},
        {"openjd", "- name: parts\n  dependencies: [{dependsOn: states}]"}};
    for (const auto& [engine, text] : waits)
        for (const bool states : {false, true}) {
            std::vector<std::string> words = {"farm", engine, "ball.toml", "--shards", "3"};
            if (states) words.insert(words.end(), {"--states", "states"});
            const Ended job = run(folder.path(), words);
            EXPECT_EQ(job.code, 0) << job.err;
            EXPECT_EQ(job.out.find(text) != job.out.npos, states) << job.out;
            EXPECT_EQ(job.out.find("impulse sim") != job.out.npos, states) << job.out;
        }
}

/// The times vary; what follows from them is tested in film/part_forecast_test.cpp.
TEST_F(Shards, APlanTellsWhatPartsCost) {
    const std::vector<std::string> words = {"plan",      "ball.toml", "--size", "96x54", "--fps",
                                            "10",        "--samples", "1",      "-j",    "1",
                                            "--seconds", "1",         "--shards"};
    const auto plan = [&](std::vector<std::string> more) {
        more.insert(more.begin(), words.begin(), words.end());
        return run(folder.path(), more);
    };
    const Ended text = plan({"4"});
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_NE(text.out.find("ball: 10 frames of 96x54, predicted from the first 10"),
              std::string::npos)
        << text.out;
    const Ended json = plan({"4", "--json"});
    ASSERT_EQ(json.code, 0) << json.err;
    const nlohmann::json object = nlohmann::json::parse(json.out);
    EXPECT_EQ(object.at("frames"), 10);
    EXPECT_EQ(object.at("shards"), 4);
    EXPECT_EQ(object.at("workers"), 1);
    for (const char* key : {"measured_frames", "memory", "draw_ms", "alone_s", "in_parts_s",
                            "speed_up", "processor_ratio", "shards_that_pay"})
        EXPECT_GT(object.at(key).get<double>(), 0.0) << key;
    EXPECT_EQ(plan({"11"}).code, 2);
    EXPECT_EQ(plan({"0"}).code, 2);
    EXPECT_FALSE(fs::exists(folder / "output"));
}

/// What is printed for other commands than render.
TEST_F(Shards, AJobFileSweepsAndTests) {
    fs::create_directories(folder / "bin");
    fs::create_symlink(IMPULSE_BINARY, folder / "bin/impulse");
    const auto job = [&](std::vector<std::string> words) {
        words.insert(words.begin(), {"farm", "commands"});
        words.insert(words.end(), {"--shards", "2"});
        const Ended printed = run(folder.path(), words);
        EXPECT_EQ(printed.code, 0) << printed.err;
        write(folder / "job", printed.out);
        const std::string command = "cd '" + folder.path().string() +
                                    "' && PATH=\"$PWD/bin:$PATH\" sh -e job > log 2>&1";
        return WEXITSTATUS(std::system(command.c_str()));
    };
    EXPECT_EQ(job({"sweep", "ball.toml", "--over", "solver.sweeps=1..3", "--csv", "table.csv"}), 0)
        << contentOf(folder / "log");
    const std::string table = contentOf(folder / "table.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);

    fs::create_directory(folder / "scenes");
    write(folder / "scenes/good.toml", kBall);
    write(folder / "scenes/bad.toml",
          kBall + "[[expect]]\nwhat = 'speed'\nbelow = 1e-9\n");
    EXPECT_EQ(job({"test", "scenes", "-o", "results"}), 1);  // the merge's, not the first part's
    EXPECT_TRUE(fs::exists(folder / "results/report.html")) << contentOf(folder / "log");
}

/// Parts with an incident end with 6 and are complete: nothing stops, and the join repeats it.
TEST_F(Shards, AnIncidentStopsNoJobFileAndIsJoined) {
    if (!haveTools()) GTEST_SKIP() << "no ffmpeg";
    write(folder / "ball.toml", kFastBall);
    fs::create_directories(folder / "bin");
    fs::create_symlink(IMPULSE_BINARY, folder / "bin/impulse");
    // As GNU parallel, one after the other: the last of its words is a command with {} in it.
    write(folder / "bin/parallel",
          "#!/bin/sh\nfor word; do :; done\nwhile read n; do\n"
          "  sh -c \"$(echo \"$word\" | sed \"s/{}/$n/g\")\" || exit 1\ndone\n");
    fs::permissions(folder / "bin/parallel", fs::perms::owner_all);
    const std::pair<const char*, const char*> engines[] = {
        {"commands", "sh -e job"}, {"make", "make -s -f job"}, {"parallel", "sh -e job"}};
    for (const auto& [engine, start] : engines) {
        const Ended job =
            run(folder.path(), {"farm", engine, "ball.toml", "-o", "film.mp4", "--size", "96x54",
                                "--fps", "10", "--samples", "1", "--shards", "2"});
        ASSERT_EQ(job.code, 0) << job.err;
        write(folder / "job", job.out);
        const std::string command = "cd '" + folder.path().string() +
                                    "' && PATH=\"$PWD/bin:$PATH\" " + start + " > log 2>&1";
        const int code = WEXITSTATUS(std::system(command.c_str()));
        EXPECT_EQ(code, std::string(engine) == "make" ? 2 : 6) << contentOf(folder / "log");
        EXPECT_EQ(playableFrames(folder / "film.mp4"), kFrames) << engine;
        const Ended joined = join({"film.parts", "--overwrite"});
        EXPECT_EQ(joined.code, 6) << engine;
        EXPECT_EQ(joined.errorLines(), 1) << joined.err;
        EXPECT_NE(joined.err.find("ball: step 1 "), std::string::npos) << joined.err;
        EXPECT_EQ(film({"-o", "film.mp4", "--shard", "2/2"}).code, 6) << "is complete already";
        fs::remove_all(folder / "film.parts");
        fs::remove(folder / "film.mp4");
    }
}

/// The record of the whole, too, keeps an incident that only the last part has seen.
TEST_F(Shards, AnIncidentOfTheLastPartIsThatOfTheWhole) {
    write(folder / "ball.toml", kBall + "velocity = [0, 9950, 0]\n");
    const std::vector<std::string> faster = {"--set", "world.gravity=[0,100,0]", "-o", "parts"};
    const auto part = [&](std::vector<std::string> more) {
        more.insert(more.end(), faster.begin(), faster.end());
        return film(more);
    };
    EXPECT_EQ(part({"--shard", "1/2"}).code, 0);
    const Ended last = part({"--shard", "2/2"});
    EXPECT_EQ(last.code, 6);
    const std::string line = last.err.substr(last.err.find("impulse: "));
    const Ended joined = join({"parts"});
    EXPECT_EQ(joined.code, 6);
    EXPECT_EQ(joined.err, line);
    const Ended whole = part({});
    EXPECT_NE(whole.out.find("10 kept"), std::string::npos) << whole.out;
    EXPECT_EQ(whole.code, 6);
    EXPECT_EQ(whole.err.substr(whole.err.find("impulse: ")), line);
}

TEST_F(Shards, AJobFileIsRefusedAsRenderWould) {
    const auto farm = [&](std::vector<std::string> more) {
        more.insert(more.begin(), "farm");
        return run(folder.path(), more);
    };
    EXPECT_EQ(farm({"slurm", "ball.toml", "--shards", "4", "-q", "best"}).code, 2);
    EXPECT_EQ(farm({"slurm", "none.toml", "--shards", "4"}).code, 3);
    EXPECT_EQ(farm({"slurm", "ball.toml", "--shards", "4000"}).code, 2);
    EXPECT_EQ(farm({"slurm", "ball.toml", "--shards", "4", "-o", "film.gif"}).code, 2);
    EXPECT_EQ(farm({"slurm", "--shards", "4"}).code, 2);
    EXPECT_EQ(farm({"cluster", "ball.toml", "--shards", "4"}).code, 2);
}

}  // namespace
}  // namespace demos::test
