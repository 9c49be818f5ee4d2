// impulse render --pass, run as by a user.
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/demos/small_film.h"

namespace demos::test {

using Json = nlohmann::json;

namespace {

const std::string kAll = "depth,depth16,normal,id,flow,camera,poses,contacts,events";

/// All files below a folder except run.json, by path.
std::map<std::string, std::string> filesIn(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename() != "run.json")
            files[fs::relative(entry.path(), folder).string()] = contentOf(entry.path());
    return files;
}

class PassOption : public testing::Test {
protected:
    PassOption() { write(folder / "ball.toml", kBall); }

    Launch small(std::vector<std::string> more) const {
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = {"render", "ball.toml", "--size",    "96x54",
                            "--fps",  "10",        "--samples", "1"};
        launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
        return launch;
    }
    Ended film(std::vector<std::string> more) const { return run(small(std::move(more))); }
    Json json(const std::string& file) const { return Json::parse(contentOf(folder / file)); }

    TemporaryFolder folder;
};

TEST_F(PassOption, WritesAFileAFrameAndPassAndDescribesThem) {
    const Ended ended = film({"--pass", kAll, "-o", "out"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_NE(ended.out.find("wrote out/passes.json: depth depth16 normal id flow camera poses "
                             "contacts events"),
              std::string::npos)
        << ended.out;
    EXPECT_EQ(filesIn(folder / "out").size(), 10u * kFrames + 1u);
    const Json passes = json("out/passes.json");
    EXPECT_EQ(passes["passes"].size(), 9u);
    EXPECT_EQ(passes["passes"]["depth"]["files"], "depth/frame_{frame:6}.pfm");
    EXPECT_EQ(passes["ids"][1]["name"], "ball");
    EXPECT_EQ(passes["ids"][1]["id"], 2);
    EXPECT_EQ(contentOf(folder / "out/depth/frame_000003.pfm").substr(0, 14), "Pf\n96 54\n-1.0\n");
    EXPECT_EQ(contentOf(folder / "out/flow/frame_000009.flo").size(), 12u + 8u * 96 * 54);
}

TEST_F(PassOption, ChangesNoPictureAndCostsNothingUnasked) {
    ASSERT_EQ(film({"-o", "plain"}).code, 0);
    ASSERT_EQ(film({"-o", "data", "--pass", "depth,flow"}).code, 0);
    const auto plain = filesIn(folder / "plain"), data = filesIn(folder / "data");
    EXPECT_EQ(plain.size(), static_cast<std::size_t>(kFrames));
    for (const auto& [name, png] : plain) EXPECT_EQ(data.at(name), png) << name;
}

TEST_F(PassOption, TheNumberOfJobsDoesNotChangeAByte) {
    ASSERT_EQ(film({"-o", "one", "--jobs", "1", "--pass", kAll}).code, 0);
    ASSERT_EQ(film({"-o", "two", "--jobs", "2", "--pass", kAll}).code, 0);
    EXPECT_EQ(filesIn(folder / "one"), filesIn(folder / "two"));
}

TEST_F(PassOption, AFrameWithoutItsDataIsMadeAgain) {
    ASSERT_EQ(film({"-o", "out", "--pass", kAll}).code, 0);
    const auto before = filesIn(folder / "out");
    fs::remove(folder / "out/flow/frame_000004.flo");
    write(folder / "out/depth/frame_000006.pfm", "torn");
    write(folder / "out/contacts/frame_000007.json.tmp4711", "half");
    const Ended again = film({"-o", "out", "--pass", kAll});
    EXPECT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.out.find("8 kept"), std::string::npos) << again.out;
    EXPECT_EQ(filesIn(folder / "out"), before);
}

TEST_F(PassOption, AKilledRunGoesOnToTheSameFiles) {
    const std::vector<std::string> common = {"--seconds", "7", "--pass", "depth16,flow,contacts"};
    const auto with = [&common](std::vector<std::string> more) {
        more.insert(more.end(), common.begin(), common.end());
        return more;
    };
    ASSERT_EQ(film(with({"-o", "calm"})).code, 0);
    Launch killed = small(with({"-o", "torn", "--json"}));
    killed.awaited = "\"frame\":55,";  // the record is written after fifty
    killed.signal = SIGKILL;
    EXPECT_EQ(run(killed).signal, SIGKILL);
    const Ended resumed = film(with({"-o", "torn"}));
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_NE(resumed.out.find("50 kept"), std::string::npos) << resumed.out;
    EXPECT_EQ(filesIn(folder / "torn"), filesIn(folder / "calm"));
}

TEST_F(PassOption, OtherPassesAreAnotherRunAndLeaveNoOldDataBehind) {
    ASSERT_EQ(film({"-o", "out", "--pass", "depth,id"}).code, 0);
    EXPECT_EQ(film({"-o", "out", "--pass", "id"}).code, 5);
    ASSERT_EQ(film({"-o", "out", "--pass", "id", "--overwrite"}).code, 0);
    EXPECT_FALSE(fs::exists(folder / "out/depth"));
    EXPECT_EQ(filesIn(folder / "out/id").size(), static_cast<std::size_t>(kFrames));
    ASSERT_EQ(film({"-o", "out", "--overwrite"}).code, 0);
    EXPECT_EQ(filesIn(folder / "out").size(), static_cast<std::size_t>(kFrames));
}

TEST_F(PassOption, DataOfUnknownOriginIsRefused) {
    fs::create_directories(folder / "mine/depth");
    write(folder / "mine/depth/frame_000003.pfm", "precious");
    EXPECT_EQ(film({"-o", "mine", "--pass", "depth"}).code, 5);
    EXPECT_EQ(contentOf(folder / "mine/depth/frame_000003.pfm"), "precious");
}

TEST_F(PassOption, NothingIsWrittenThroughASymbolicLink) {
    fs::create_directories(folder / "victim");
    fs::create_directories(folder / "out");
    fs::create_directory_symlink(folder / "victim", folder / "out/depth");
    const Ended ended = film({"-o", "out", "--pass", "depth"});
    EXPECT_EQ(ended.code, 4);
    EXPECT_NE(ended.err.find("symbolic link"), std::string::npos) << ended.err;
    EXPECT_TRUE(fs::is_empty(folder / "victim"));
}

TEST_F(PassOption, MistakesAreUsageErrors) {
    const Ended unknown = film({"--pass", "deptj"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("did you mean 'depth'"), std::string::npos) << unknown.err;
    const Ended nowhere = film({"--pass", "depth", "-o", "-"});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_EQ(nowhere.errorLines(), 1);
    EXPECT_NE(nowhere.err.find("-o output/ball"), std::string::npos) << nowhere.err;
    EXPECT_TRUE(nowhere.out.empty());
}

float floatAt(const std::string& bytes, std::size_t at) {
    float value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

// The ball falls freely from (0, 3, 0), far from the camera. The camera file alone gives the pixel
// of its foremost point; depth and flow agree there.
TEST_F(PassOption, PosesCameraDepthAndFlowAgree) {
    ASSERT_EQ(film({"-o", "out", "--pass", "camera,poses,depth,flow", "--seconds", "0.3", "--set",
                    "camera.from=[8,5,14]"})
                  .code,
              0);
    const auto seen = [this](int frame) {
        const std::string number = "/frame_00000" + std::to_string(frame) + ".json";
        const Json camera = json("out/camera" + number), poses = json("out/poses" + number);
        double eye[4] = {0, 0, 0, 0};
        for (int row = 0; row < 4; ++row) {
            const Json& m = camera["view"][row];
            for (int i = 0; i < 3; ++i)
                eye[row] += m[i].get<double>() *
                            poses["bodies"][1]["position"][i].get<double>();
            eye[row] += m[3].get<double>();
        }
        const Json& k = camera["K"];
        const double depth = -eye[2];
        return std::array<double, 3>{
            k[0][0].get<double>() * eye[0] / depth + k[0][2].get<double>(),
            k[1][1].get<double>() * -eye[1] / depth + k[1][2].get<double>(), depth};
    };
    const std::array<double, 3> now = seen(1), next = seen(2);
    const int x = static_cast<int>(now[0]), y = static_cast<int>(now[1]);
    const std::string pfm = contentOf(folder / "out/depth/frame_000001.pfm");
    const std::string flo = contentOf(folder / "out/flow/frame_000001.flo");
    const std::size_t fromBottom = static_cast<std::size_t>(kHeight - 1 - y) * kWidth + x;
    EXPECT_NEAR(floatAt(pfm, 14 + 4 * fromBottom), now[2] - 0.5, 0.02);  // r before the centre
    const std::size_t pixel = static_cast<std::size_t>(y) * kWidth + x;
    EXPECT_NEAR(floatAt(flo, 12 + 8 * pixel), next[0] - now[0], 0.05);
    EXPECT_NEAR(floatAt(flo, 16 + 8 * pixel), next[1] - now[1], 0.05);
    EXPECT_GT(next[1] - now[1], 0.5);  // down
}

TEST_F(PassOption, ContactImpulsesAreThoseOfSim) {
    ASSERT_EQ(film({"-o", "out", "--pass", "contacts"}).code, 0);
    ASSERT_EQ(run(folder.path(), {"sim", "ball.toml", "--contacts", "c.csv"}).code, 0);
    std::vector<double> inSim, inFilm;
    std::ifstream table(folder / "c.csv");
    std::string line;
    for (std::getline(table, line); std::getline(table, line);) {
        std::vector<std::string> cells(1);
        for (const char c : line)
            if (c == ',')
                cells.emplace_back();
            else
                cells.back().push_back(c);
        const double penetration = std::stod(cells.at(9)), impulse = std::stod(cells.at(10));
        if (std::stod(cells[0]) > 0.9 + 1e-9) break;  // the last frame's time
        if (penetration >= 0.0 || impulse > 0.0) inSim.push_back(impulse);
    }
    std::vector<std::string> events;
    for (int frame = 0; frame < kFrames; ++frame) {
        const Json file = json("out/contacts/frame_00000" + std::to_string(frame) + ".json");
        for (const Json& c : file["contacts"]) {
            events.push_back(c["event"]);
            if (c["event"] == "end") continue;
            inFilm.push_back(c["impulse"]);
            EXPECT_EQ(c["ids"][0].get<int>() + c["ids"][1].get<int>(), 3);
        }
    }
    EXPECT_EQ(inFilm, inSim);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.front(), "begin");
    const auto begun = std::count(events.begin(), events.end(), "begin");
    const auto ended = std::count(events.begin(), events.end(), "end");
    EXPECT_EQ(begun - ended, events.back() == "end" ? 0 : 1);  // one pair, which touches or not
}

TEST_F(PassOption, EventsAreThoseOfTheSimulation) {
    ASSERT_EQ(film({"-o", "out", "--pass", "events", "--jobs", "2"}).code, 0);
    ASSERT_EQ(run(folder.path(), {"sim", "ball.toml", "--events", "e.json"}).code, 0);
    const Json inSim = json("e.json");
    Json inFilm = Json::array();
    for (int frame = 0; frame < kFrames; ++frame) {
        const Json file = json("out/events/frame_00000" + std::to_string(frame) + ".json");
        for (const Json& event : file["events"]) inFilm.push_back(event);
    }
    ASSERT_FALSE(inFilm.empty());
    // The last frame is at 0.9 s, the simulation's end at 1 s.
    for (std::size_t i = 0; i < inFilm.size(); ++i) EXPECT_EQ(inFilm[i], inSim[i]);
    EXPECT_EQ(inSim[0]["event"], "begin");
    EXPECT_EQ(inSim[0]["a"], "floor");
    EXPECT_EQ(inSim[0]["b"], "ball");
    EXPECT_NEAR(inSim[0]["time"].get<double>(), 0.714, 0.02);  // sqrt(2 h / g), h = 2.5 m
}

}  // namespace
}  // namespace demos::test
