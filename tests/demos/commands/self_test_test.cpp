// impulse test --self-test, run as by a user.
#include <sstream>

#include "tests/demos/program.h"

namespace demos::test {
namespace {

class SelfTestCommand : public testing::Test {
protected:
    SelfTestCommand() { write(folder / "ball.toml", kBall + "[snapshot]\ntimes = [0, 0.5]\n"); }
    Ended selfTest(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"test", "--self-test", "--size", "320x180"});
        return run(folder.path(), arguments);
    }
    TemporaryFolder folder;
};

const std::vector<std::string> kLax = {
    "--set", "snapshot.gate={levels=255,window=256,ssim=-1,why='to miss'}", "--set",
    "snapshot.tolerance={position=1e5,angle_deg=180,why='to miss'}"};

TEST_F(SelfTestCommand, PrintsATableAndHowManyWereCaught) {
    const Ended ended = selfTest({"ball.toml"});
    EXPECT_EQ(ended.code, 0) << ended.out << ended.err;
    EXPECT_NE(ended.out.find("ball: 320x180 at 0, 0.5 s;"), std::string::npos) << ended.out;
    for (const char* mutant :
         {"1 mm", "1 cm", "hidden", "color", "light", "no shadow", "late", "gamma",
          "mass x2", "gravity"})
        EXPECT_NE(ended.out.find(std::string("  ") + mutant + " "), std::string::npos) << mutant;
    EXPECT_NE(ended.out.find("9 of 9 mutants caught\n"), std::string::npos) << ended.out;
    EXPECT_FALSE(fs::exists(folder / "ball.snapshots"));  // it makes no baseline
    EXPECT_FALSE(fs::exists(folder / "output"));
}

TEST_F(SelfTestCommand, FailsWhereOneIsMissed) {
    std::vector<std::string> arguments = {"ball.toml"};
    arguments.insert(arguments.end(), kLax.begin(), kLax.end());
    const Ended ended = selfTest(arguments);
    EXPECT_EQ(ended.code, 1) << ended.out;
    EXPECT_NE(ended.out.find("MISSED: the same body is not drawn"), std::string::npos) << ended.out;
    EXPECT_NE(ended.err.find("0 of 9 mutants caught\n"), std::string::npos) << ended.err;
}

TEST_F(SelfTestCommand, FailsWhereThereIsNothingToDamage) {
    write(folder / "ball.toml", kBall);
    const Ended ended = selfTest({"ball.toml"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.out.find("ball: [snapshot] lists no times"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("0 of 0 mutants caught\n"), std::string::npos) << ended.out;
}

TEST_F(SelfTestCommand, AProblemOfOneSceneDoesNotEndTheOthers) {
    write(folder / "tall.toml", kTooTall + "[snapshot]\ntimes = [0.95]\n");
    const Ended ended = selfTest({"tall.toml", "ball.toml"});
    EXPECT_EQ(ended.code, 1);
    EXPECT_NE(ended.err.find("impulse: tall: tall: step "), std::string::npos) << ended.err;
    EXPECT_NE(ended.out.find("9 of 9 mutants caught\n"), std::string::npos) << ended.out;
}

TEST_F(SelfTestCommand, SaysInJsonWhatEveryTimeHasShown) {
    const Ended ended = selfTest({"ball.toml", "--json"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    std::istringstream lines(ended.out);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    ASSERT_EQ(all.size(), 2u * 10u + 1u) << ended.out;
    EXPECT_EQ(all.front().find(R"({"event":"mutant","scene":"ball","time":0,"mutant":"1 mm",)"
                               R"("unchanged":false,"state":true,)"),
              0u)
        << all.front();
    EXPECT_EQ(all.back(), R"({"event":"done","caught":9,"missed":0,"problems":0})");
}

}  // namespace
}  // namespace demos::test
