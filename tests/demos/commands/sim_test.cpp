#include <sys/stat.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <sstream>

#include "render/encode/ffmpeg.h"
#include "tests/demos/program.h"

namespace demos::test {
namespace {

std::vector<std::vector<std::string>> rowsOf(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream cells(line);
        rows.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
}

double number(const std::string& cell) {
    double value = 0.0;
    const auto got = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    EXPECT_EQ(got.ptr, cell.data() + cell.size()) << cell;
    return value;
}

class Sim : public testing::Test {
protected:
    Sim() { write(folder / "ball.toml", kBall); }
    Ended sim(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"sim", "ball.toml"});
        return run(folder.path(), arguments);
    }
    TemporaryFolder folder;
};

TEST_F(Sim, WritesARowAStepAndOneForTimeZero) {
    const Ended ended = sim({"--csv", "a.csv"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    const auto rows = rowsOf(contentOf(folder / "a.csv"));
    ASSERT_EQ(rows.size(), 62u);  // columns, time 0, sixty steps
    EXPECT_EQ(rows[0].size(), 8u);
    EXPECT_EQ(rows[0][0], "time");
    EXPECT_EQ(rows[1][0], "0");
    EXPECT_EQ(rows[61][0], "1");
    EXPECT_NE(ended.out.find("wrote a.csv (61 rows)"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("next: impulse render ball.toml"), std::string::npos) << ended.out;
}

TEST_F(Sim, WarnsOfABodyThatFallsOutAndOfAGas) {
    write(folder / "lost.toml", "format = 1\nseconds = 4\n[[body]]\nname = 'lost'\n"
                                "shape = { sphere = 0.5 }\ndensity = 2.7\n");
    const Ended ended = run(folder.path(), {"sim", "lost.toml"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.errorLines(), 2) << ended.err;
    EXPECT_NE(ended.err.find("warning: lost: 'lost': a density of 2.7 kg/m^3"), std::string::npos)
        << ended.err;
    EXPECT_NE(ended.err.find("warning: lost: 'lost' falls out of the scene"), std::string::npos)
        << ended.err;
    EXPECT_EQ(sim({}).err, "");
}

TEST_F(Sim, NamesTheBodyAndTheTimeOfAFailedExpectation) {
    write(folder / "low.toml", kBall + "[[expect]]\nwhat = 'height'\nof = 'b*'\nabove = 1\n");
    const Ended ended = run(folder.path(), {"sim", "low.toml"});
    EXPECT_EQ(ended.code, 1) << ended.err;
    EXPECT_NE(ended.err.find("low: failed: least height of b* above 1 m, 0 s to 1 s: 0."),
              std::string::npos)
        << ended.err;
    EXPECT_NE(ended.err.find(" m ('ball' at 0."), std::string::npos) << ended.err;
}

TEST_F(Sim, SaysARunInBriefIfNothingIsExpected) {
    const std::string hash = sim({"--hash", "--quiet"}).out;
    const Ended ended = sim({"--csv", "a.csv"});
    const auto rows = rowsOf(contentOf(folder / "a.csv"));
    double deepest = 0.0;
    for (std::size_t i = 1; i < rows.size(); ++i) deepest = std::max(deepest, number(rows[i][5]));
    std::istringstream out(ended.out.substr(ended.out.find("ball: 60 steps, 1 s\n")));
    std::string word, line;
    double start = 0.0, end = 0.0, penetration = 0.0;
    std::getline(out, line);
    std::getline(out, line);
    EXPECT_EQ(line, "bodies       2");
    out >> word >> start >> word >> word >> word >> word >> end >> line;
    std::getline(out, line);
    out >> word >> penetration;
    std::getline(out, line);
    EXPECT_NEAR(start, number(rows[1][1]), 1e-5 * std::abs(start)) << ended.out;
    EXPECT_NEAR(end, number(rows.back()[1]), 1e-5 * std::abs(end)) << ended.out;
    EXPECT_NEAR(penetration, deepest, 1e-2 * deepest) << ended.out;
    std::getline(out, line);
    ASSERT_TRUE(line.starts_with("state        ")) << ended.out;
    EXPECT_TRUE(hash.ends_with("state " + line.substr(13) + "\n")) << hash << line;
    EXPECT_EQ(run(folder.path(), {"sim", "stack", "--seconds", "0.1", "--no-expect"})
                  .out.find("penetration"),
              std::string::npos);
}

TEST_F(Sim, TheBallFallsAsTheFormulaSays) {
    const Ended ended = sim({"--bodies", "-", "--seconds", "0.5"});
    const auto rows = rowsOf(ended.out);
    ASSERT_EQ(rows.size(), 1u + 31u * 2u);
    EXPECT_EQ(rows[0].size(), 15u);
    EXPECT_EQ(rows.back()[1], "ball");
    // y = y0 - g h^2 n (n + 1) / 2 for n = 30 steps of 4 sub-steps each: h = 1/240 s, 120 of them
    const double h = 1.0 / 240;
    EXPECT_NEAR(number(rows.back()[3]), 3.0 - 9.81 * h * h * 120 * 121 / 2, 1e-9);
}

TEST_F(Sim, EveryThinsTheRows) {
    const auto rows = rowsOf(sim({"--csv", "-", "--every", "20"}).out);
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[4][0], "1");
}

TEST_F(Sim, ContactsHoldTheImpulseThatCarriesTheWeight) {
    const auto rows = rowsOf(
        sim({"--contacts", "-", "--set", "body.ball.at=[0,0.5,0]", "--set", "body.ball.mass=2"})
            .out);
    ASSERT_GT(rows.size(), 30u);
    EXPECT_EQ(rows[0].size(), 12u);
    EXPECT_EQ(rows.back()[1], "floor");
    EXPECT_EQ(rows.back()[2], "ball");
    EXPECT_NEAR(number(rows.back()[10]), 2.0 * 9.81 / 60, 1e-3);  // m g dt
}

TEST_F(Sim, EventsHaveAFileOfTheirOwn) {
    const Ended ended = sim({"--events", "e.json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("wrote e.json (1 events)"), std::string::npos) << ended.out;
    EXPECT_EQ(contentOf(folder / "e.json").substr(0, 20), "[\n {\"event\":\"begin\",");
    const Ended twice = sim({"--events", "x", "--csv", "x"});
    EXPECT_EQ(twice.code, 2);
    EXPECT_NE(twice.err.find("give each its own file"), std::string::npos) << twice.err;
}

TEST_F(Sim, SweepsAndJointsHaveTheirColumns) {
    const auto sweeps = rowsOf(sim({"--sweeps", "-", "--seconds", "0.1"}).out);
    EXPECT_EQ(sweeps.at(0).size(), 4u);
    const Ended ended =
        run(folder.path(), {"sim", "pendulum", "--joints", "-", "--seconds", "0.1", "--no-expect"});
    const auto joints = rowsOf(ended.out);
    ASSERT_GT(joints.size(), 1u);
    EXPECT_EQ(joints.at(0).size(), 8u);
    EXPECT_EQ(joints.at(1).size(), 8u);
    EXPECT_EQ(joints.at(0)[7], "broken");
    EXPECT_EQ(joints.at(1)[7], "0");
}

TEST_F(Sim, TheHashIsTheSameInEveryRunAndOfTheStep) {
    const Ended first = sim({"--hash", "--quiet"});
    EXPECT_EQ(first.out, sim({"--hash", "--quiet"}).out);
    EXPECT_TRUE(first.out.starts_with("step 60  state ")) << first.out;
    const Ended many = sim({"--hash-every", "25", "--quiet"});
    EXPECT_EQ(std::count(many.out.begin(), many.out.end(), '\n'), 3);  // 25, 50 and the last
    EXPECT_TRUE(many.out.ends_with(first.out)) << many.out;
}

TEST_F(Sim, AFailedExpectationIsCode1WithItsValue) {
    write(folder / "ball.toml", kBall + R"([[expect]]
what = "speed"
of = ["ball"]
below = 0.1
why = "it should not fall"
[[expect]]
what = "penetration"
below = 0.1
)");
    const Ended ended = sim({"--seconds", "0.5"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_NE(ended.err.find("4.905 m/s"), std::string::npos) << ended.err;  // g t
    EXPECT_NE(ended.err.find("it should not fall"), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("ok "), std::string::npos) << ended.out;
    EXPECT_EQ(sim({"--seconds", "0.5", "--no-expect"}).code, 0);
}

TEST_F(Sim, DivergenceIsCode6AndNamesStepAndBody) {
    write(folder / "ball.toml", kBall + "velocity = [0, 9999, 0]\n");
    const Ended ended = sim({"--set", "world.gravity=[0,100,0]", "--csv", "a.csv"});
    EXPECT_EQ(ended.code, 6) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1);
    EXPECT_NE(ended.err.find("ball: step "), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("body 'ball': faster than"), std::string::npos) << ended.err;
    EXPECT_TRUE(fs::exists(folder / "a.csv"));  // the results so far are kept
}

TEST_F(Sim, WarnsOfBodiesThatBeginInsideEachOther) {
    write(folder / "ball.toml", kBall +
                                    "[[body]]\nname = \"inside\"\nshape = { sphere = 0.1 }\n"
                                    "at = [0, 50, 0]\n[[body]]\nname = \"too\"\n"
                                    "shape = { sphere = 0.1 }\nat = [0.15, 50, 0]\n");
    const Ended ended = sim({});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.err.find("warning: ball: 'inside' and 'too' overlap by 0.05 m at the start"),
              std::string::npos)
        << ended.err;
}

TEST_F(Sim, JsonIsAnObjectALineAndNothingElse) {
    const Ended ended = sim({"--json", "--hash"});
    EXPECT_EQ(ended.code, 0);
    std::istringstream lines(ended.out);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_EQ(line.front(), '{') << line;
        EXPECT_EQ(line.back(), '}') << line;
    }
    EXPECT_NE(ended.out.find(R"("event":"done")"), std::string::npos);
}

TEST_F(Sim, ClosedOrFullStandardOutputIsCode4) {
    for (const bool closed : {true, false}) {
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {"sim", "ball.toml", "--bodies", "-"};
        launch.beforeExec = [closed] {
            close(STDOUT_FILENO);
            if (!closed) open("/dev/full", O_WRONLY);
        };
        const Ended ended = run(launch);
        EXPECT_EQ(ended.code, 4) << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    }
}

TEST_F(Sim, TakesAwkwardNamesAsTheyAre) {
    for (const char* name : {"a;touch pwned", "%d%n", "sp ace.csv"}) {
        EXPECT_EQ(sim({"--csv", name, "--seconds", "0.1"}).code, 0) << name;
        EXPECT_TRUE(fs::exists(folder / name)) << name;
    }
    EXPECT_FALSE(fs::exists(folder / "pwned"));
}

TEST_F(Sim, BenchSaysItsFieldsAsJson) {
    const Ended ended = run(folder.path(), {"bench", "ball.toml", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    for (const char* field :
         {"scene", "bodies", "joints", "contacts", "steps", "ms_per_step_median", "ms_per_step_min",
          "ms_per_step_max", "ns_per_point", "hash"})
        EXPECT_NE(ended.out.find("\"" + std::string(field) + "\":"), std::string::npos) << field;
}

TEST_F(Sim, BenchGoesOnAfterAnIncident) {
    write(folder / "fast.toml", kFastBall);
    const Ended steps = run(folder.path(), {"bench", "fast.toml", "ball.toml"});
    const Ended film = run(folder.path(), {"bench", "fast.toml", "ball.toml", "--film", "--size", "96x54",
                                           "--seconds", "0.2", "-j", "1"});
    for (const Ended& ended : {steps, film}) {
        EXPECT_EQ(ended.code, 6) << ended.err;
        EXPECT_EQ(ended.errorLines(), 1) << ended.err;
        EXPECT_NE(ended.err.find("fast: step 1 "), std::string::npos) << ended.err;
        EXPECT_NE(ended.out.find("\nfast "), std::string::npos) << ended.out;
        EXPECT_NE(ended.out.find("\nball "), std::string::npos) << ended.out;
    }
}

TEST_F(Sim, BenchOfAFilmAddsUpAllProcessesOfAnMp4) {
    if (!render::haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
    const std::vector<std::string> film = {"bench",  "ball.toml", "--film", "--size",
                                           "192x108", "--seconds", "0.2",   "--json"};
    const Ended ended = run(folder.path(), film);
    ASSERT_EQ(ended.code, 0) << ended.err;
    const nlohmann::json said = nlohmann::json::parse(ended.out);
    double sum = 0.0;
    for (const char* part : {"mp4_ms_workers", "mp4_ms_program", "mp4_ms_encoder"}) {
        const double ms = said[part];
        EXPECT_GT(ms, 0.0) << part;
        sum += ms;
    }
    EXPECT_NEAR(said["mp4_ms"].get<double>(), sum, 1e-4 * sum);  // printed with six digits
    EXPECT_GT(said["mp4_bytes"].get<double>(), 20.0);
    const double drawn = said["drawn_share"];  // the ball falls before a ground that stays
    EXPECT_GT(drawn, 0.0);
    EXPECT_LT(drawn, 0.9);
    const Ended odd = run(folder.path(), {"bench", "ball.toml", "--film", "--size", "95x54",
                                          "--seconds", "0.2", "--whole-frames", "--json"});
    EXPECT_EQ(odd.code, 0) << odd.err;  // no .mp4 has such a size
    const nlohmann::json oddSaid = nlohmann::json::parse(odd.out);
    EXPECT_FALSE(oddSaid.contains("mp4_ms")) << odd.out;
    EXPECT_EQ(oddSaid["drawn_share"].get<double>(), 1.0) << odd.out;
}

TEST_F(Sim, BenchTellsPhasesAndComparesWithAnEarlierRun) {
    const Ended first = run(folder.path(), {"bench", "ball.toml", "--json", "--quiet"});
    write(folder / "before.json", first.out);
    const Ended ended =
        run(folder.path(), {"bench", "ball.toml", "--phases", "--against", "before.json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("same state"), std::string::npos) << ended.out;
    for (const char* phase :
         {"prepare", "forces", "velocities", "impulses", "positions", "nudges", "collisions"})
        EXPECT_NE(ended.out.find(std::string(phase) + " 0."), std::string::npos) << phase;
    write(folder / "bad.json", "no json\n");
    const Ended bad = run(folder.path(), {"bench", "ball.toml", "--against", "bad.json"});
    EXPECT_EQ(bad.code, 2);
    EXPECT_NE(bad.err.find("bad.json:1"), std::string::npos) << bad.err;
    write(folder / "bad.json", R"({"scene":"ball","ms_per_step_median":0,"hash":"0"})");
    EXPECT_EQ(run(folder.path(), {"bench", "ball.toml", "--against", "bad.json"}).code, 2);
    EXPECT_EQ(run(folder.path(), {"bench", "ball.toml", "--against", "none.json"}).code, 4);
    ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
    for (const char* endless : {"/dev/zero", "fifo"}) {
        const Ended refused = run(folder.path(), {"bench", "ball.toml", "--against", endless});
        EXPECT_EQ(refused.code, 4);
        EXPECT_NE(refused.err.find("is not a regular file"), std::string::npos) << refused.err;
    }
}

TEST_F(Sim, WritesOverItsOwnResultsOnly) {
    write(folder / "notes", "all my notes\n");
    for (const char* option : {"--csv", "--bodies", "--joints", "--contacts", "--sweeps", "--events"}) {
        const Ended refused = run(folder.path(), {"sim", "ball.toml", option, "notes"});
        EXPECT_EQ(refused.code, 5) << option;
        EXPECT_NE(refused.err.find("'notes' already exists and is no "), std::string::npos) << refused.err;
        for (int time = 0; time < 2; ++time)
            EXPECT_EQ(run(folder.path(), {"sim", "ball.toml", option, "own"}).code, 0) << option;
        fs::remove(folder / "own");
    }
    write(folder / "notes.svg", "all my notes\n");
    EXPECT_EQ(run(folder.path(), {"sim", "ball.toml", "--plot", "notes.svg"}).code, 5);
    EXPECT_EQ(run(folder.path(), {"plot", "ball.toml", "-o", "notes.svg"}).code, 5);
    EXPECT_EQ(run(folder.path(), {"plot", "ball.toml", "-o", "notes.svg", "--overwrite"}).code, 0);
    for (const char* own : {"own.svg", "own.png"})
        for (int time = 0; time < 2; ++time)
            EXPECT_EQ(run(folder.path(), {"plot", "ball.toml", "-o", own}).code, 0) << own;
    EXPECT_EQ(run(folder.path(), {"sweep", "ball.toml", "--over", "solver.sweeps=1..2", "--csv", "notes"}).code, 5);
}

TEST_F(Sim, DoesNotWriteOverItsScene) {
    write(folder / "own.toml", kBall);
    for (const char* option : {"--csv", "--bodies", "--events", "--plot"}) {
        const Ended ended = run(folder.path(), {"sim", "own.toml", option, "./own.toml"});
        EXPECT_EQ(ended.code, 2) << option;
        EXPECT_EQ(ended.err, "impulse: './own.toml' is the scene itself; write to another file\n");
    }
    EXPECT_EQ(contentOf(folder / "own.toml"), kBall);
    const Ended twice =
        run(folder.path(), {"sim", "own.toml", "--csv", "a.csv", "--bodies", "./a.csv"});
    EXPECT_EQ(twice.code, 2);
    EXPECT_NE(twice.err.find("two tables for './a.csv'"), std::string::npos) << twice.err;
}

TEST_F(Sim, AJointsRowTellsItsFreeCoordinateAndNoForceOnceItIsBroken) {
    write(folder / "joint.toml", R"(format = 1
seconds = 1.0
[[body]]
name = "weight"
shape = { sphere = 0.1 }
at = [0, 5, 0]
mass = 2
[[joint]]
name = "spring"
type = "six-dof"
a = "world"
b = "weight"
anchor = [0, 5, 0]
x = "locked"
z = "locked"
y = { spring = { hz = 0.2, damping = 0.0 } }
break_at = 5
)");
    const Ended ended = run(folder.path(), {"sim", "joint.toml", "--joints", "-", "--quiet"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    double lowest = 0.0, atBreak = 0.0, afterwards = -1.0;
    std::istringstream lines(ended.out);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::vector<double> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            cells.push_back(std::atof(cell.c_str()));
        ASSERT_EQ(cells.size(), 8u);
        lowest = std::min(lowest, cells[5]);
        if (cells[7] == 1.0 && atBreak > 0.0) afterwards = cells[3];
        if (cells[7] == 1.0 && atBreak == 0.0) atBreak = cells[3];
    }
    EXPECT_LT(lowest, -0.5);  // it falls along y, the second coordinate
    EXPECT_GT(atBreak, 5.0);
    EXPECT_EQ(afterwards, 0.0);
}

TEST_F(Sim, PlaysAMujocoModelAndTellsWhatIsLeftOut) {
    write(folder / "arm.xml",
          "<mujoco><worldbody><light/><body><joint axis='0 1 0' margin='1'/>"
          "<geom type='capsule' size='0.1' fromto='0 0 0 1 0 0'/></body></worldbody></mujoco>");
    const Ended ended = run(folder.path(), {"sim", "arm.xml", "--seconds", "0.1"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err,
              "impulse: arm.xml:1:20: <light>: for MuJoCo's viewer and sensors; left out\n"
              "impulse: arm.xml:1:54: <joint margin> is not supported; left out\n");
    EXPECT_EQ(run(folder.path(), {"sim", "arm.xml", "--seconds", "0.1", "--quiet"}).err, "");
    write(folder / "bad.xml", "<mujoco><worldbody><geom sise='1'/></worldbody></mujoco>");
    const Ended bad = run(folder.path(), {"sim", "bad.xml"});
    EXPECT_EQ(bad.code, 3);
    EXPECT_EQ(bad.err,
              "impulse: bad.xml:1:20: a <geom> of type sphere has no size; write "
              "size=\"0.1\" (m; half lengths)\nimpulse: bad.xml:1:26: unknown attribute "
              "'sise' of <geom>; did you mean 'size'?\n");
}

}  // namespace
}  // namespace demos::test
