// impulse test --shard and --merge: a test in parts gives the reports of one test.
#include "tests/demos/commands/ball_snapshots.h"

namespace demos::test {
namespace {

class TestParts : public Snapshots {
protected:
    /// Seven scenes, most of them only with expectations; nothing is drawn for those.
    TestParts() {
        fs::create_directory(folder / "scenes");
        for (const char* name : {"a", "b", "c", "d", "e", "f"})
            write(folder / "scenes" / (std::string(name) + ".toml"),
                  kBall + "[[expect]]\nwhat = 'penetration'\nbelow = 0.05\n");
        write(folder / "scenes/ball.toml", kBallOnABox);
    }
    Ended part(int number, std::vector<std::string> more = {}, int count = 3) {
        more.insert(more.begin(), {"test", "scenes", "-j", "1", "--no-cache", "--shard",
                                   std::to_string(number) + "/" + std::to_string(count)});
        return impulse(more);
    }
    Ended merge(std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"test", "--merge"});
        return impulse(more);
    }
    /// A ball that falls from elsewhere, and a scene that breaks its promise.
    void damageTwoScenes() {
        std::string text = kBallOnABox;
        text.replace(text.find("[0.1, 2, 0]"), 11, "[0.1, 2.1, 0]");
        write(folder / "scenes/ball.toml", text);
        write(folder / "scenes/d.toml",
              kBall + "[[expect]]\nwhat = 'speed'\nbelow = 1e-9\n");
    }
    std::string result(const std::string& file) { return contentOf(folder / "output/test" / file); }
};

TEST_F(TestParts, GiveTheReportsOfOneTest) {
    ASSERT_EQ(impulse({"test", "scenes"}).code, 0);
    damageTwoScenes();
    ASSERT_EQ(impulse({"test", "scenes", "-j", "1", "--no-cache"}).code, 1);
    const std::string page = result("report.html"), json = result("report.json"),
                      junit = result("junit.xml");
    fs::remove_all(folder / "output");
    int scenes = 0;
    for (const int number : {3, 1, 2}) {
        EXPECT_EQ(part(number).code, number == 1 ? 0 : 1) << number;
        scenes += static_cast<int>(
            Json::parse(contentOf(folder / "output/test.parts" / ("00" + std::to_string(number) +
                                                                  "-of-003/report.json")))
                .at("scenes")
                .size());
    }
    EXPECT_EQ(scenes, 7);
    const Ended merged = merge();
    EXPECT_EQ(merged.code, 1);
    EXPECT_NE(merged.out.find("7 scenes: 5 passed, 2 failed"), std::string::npos) << merged.out;
    EXPECT_EQ(result("junit.xml"), junit);
    EXPECT_EQ(result("report.json"), json);
    EXPECT_TRUE(result("report.html") == page);

    EXPECT_EQ(impulse({"approve", "ball"}).code, 0);
    const Ended again = impulse({"test", "scenes/ball.toml"});
    EXPECT_EQ(again.code, 0) << again.err;
}

TEST_F(TestParts, NameWhatIsMissingOrOfAnotherRun) {
    EXPECT_EQ(part(1, {}, 4).code, 0);
    EXPECT_EQ(part(2, {}, 4).code, 0);
    EXPECT_EQ(part(4, {"--update", "none"}, 4).code, 0);
    const Ended missing = merge();
    EXPECT_EQ(missing.code, 7);
    EXPECT_EQ(missing.errorLines(), 1) << missing.err;
    for (const char* said : {"2 of 4 parts are complete", "missing: 3", "of another run: 4"})
        EXPECT_NE(missing.err.find(said), std::string::npos) << missing.err;
    EXPECT_NE(missing.out.find("to do: impulse test scenes -j 1 --no-cache --shard 3/4\n"),
              std::string::npos)
        << missing.out;
    EXPECT_FALSE(has("output/test/report.json"));

    write(folder / "scenes/g.toml", kBall);  // another set of scenes
    for (const int number : {2, 3, 4}) EXPECT_EQ(part(number, {}, 4).code, 0);
    const Ended older = merge();
    EXPECT_EQ(older.code, 7);
    EXPECT_NE(older.err.find("of another run: 1"), std::string::npos) << older.err;
    EXPECT_EQ(part(1, {}, 4).code, 0);
    const std::string parts = "output/test.parts/";
    EXPECT_EQ(merge({parts + "004-of-004", parts + "002-of-004", parts + "001-of-004",
                     parts + "003-of-004"})
                  .code,
              0);

    fs::remove(folder / parts / "002-of-004/report.json");  // as if it was interrupted
    const Ended torn = merge();
    EXPECT_EQ(torn.code, 7);
    EXPECT_NE(torn.err.find("damaged or incomplete: 2"), std::string::npos) << torn.err;
}

TEST_F(TestParts, AreRefusedWhereTheyMakeNoSense) {
    const Ended many = impulse({"test", "scenes", "--shard", "3/16"});
    EXPECT_EQ(many.code, 2);
    EXPECT_NE(many.err.find("there are 7 scenes; make fewer parts"), std::string::npos);
    EXPECT_EQ(impulse({"test", "scenes", "--shard", "4/3"}).code, 2);
    EXPECT_EQ(part(1, {"--self-test"}).code, 2);
    EXPECT_EQ(merge().code, 2);
    EXPECT_EQ(merge({"scenes"}).code, 2);
    EXPECT_EQ(part(1).code, 0);
    const std::string first = "output/test.parts/001-of-003";
    EXPECT_EQ(merge({first, first}).code, 2);
    EXPECT_EQ(part(2).code, 0);
    EXPECT_EQ(part(3).code, 0);
    EXPECT_EQ(merge({"output/test.parts", "-o", first}).code, 2) << "over a part";
    EXPECT_EQ(merge({"output/test.parts", "-o", "scenes"}).code, 2) << "over the baselines";
}

/// A report of elsewhere names no folder outside of the results.
TEST_F(TestParts, ForeignReportsWriteNowhereElse) {
    for (const int number : {1, 2, 3}) ASSERT_EQ(part(number).code, 0);
    const fs::path report = folder / "output/test.parts/001-of-003/report.json";
    Json json = Json::parse(contentOf(report));
    json["scenes"][0]["name"] = "../../scenes/ball";
    write(report, json.dump());
    EXPECT_EQ(merge().code, 7);
    json["scenes"][0]["name"] = "a";
    json["part"]["scenes"] = 2000000000;
    write(report, json.dump());
    EXPECT_EQ(merge().code, 7);
    EXPECT_TRUE(has("scenes/ball.snapshots/baseline.json"));
}

TEST_F(TestParts, ADryRunListsTheScenesOfAPart) {
    EXPECT_EQ(part(2, {"--dry-run"}).out, "scenes/b.toml\nscenes/d.toml\n");
    EXPECT_FALSE(has("output"));
}

}  // namespace
}  // namespace demos::test
