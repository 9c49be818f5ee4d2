// The parts of a film in a folder, whose records may be damaged or come from elsewhere.
#include <gtest/gtest.h>

#include <fstream>

#include "demos/film/part_review.h"
#include "demos/film/parts.h"
#include "demos/film/state_files.h"
#include "demos/text/file_content.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"
#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

class PartsOfAFilm : public testing::Test {
protected:
    void write(const std::string& name, int frames, const std::string& command) {
        const std::filesystem::path film = folder_ / (name + ".mp4");
        std::ofstream(film) << name;
        RunRecord record;
        record.command = command;
        record.frames.assign(static_cast<std::size_t>(frames), {true, 1, 1, 0});
        writePartRecord(film, record);
    }

    support::TemporaryFolder folder_;
};

// A record with more frames than the others has no place for them in the whole.
TEST_F(PartsOfAFilm, HaveTheSameNumberOfFrames) {
    write("001-of-003", 9, "impulse render a --shard 1/3");
    write("002-of-003", 9, "impulse render a --shard 2/3");
    write("003-of-003", 9'000, "impulse render a --shard 3/3");
    const Parts parts = partsIn(folder_.path());
    EXPECT_EQ(parts.whole.frames.size(), 9u);
    EXPECT_EQ(parts.wanted, std::vector<int>{3});
    EXPECT_EQ(commandOf(parts, 3), "impulse render a --shard 3/3 --overwrite");
}

TEST_F(PartsOfAFilm, PrintNoCommandThatRunsAnotherProgram) {
    for (const char* command :
         {"impulse render a; true --shard 1/2", "impulse render $(true) --shard 1/2",
          "impulse render 'a' `true` --shard 1/2", "true --shard 1/2",
          "impulse render a\ntrue --shard 1/2", "impulse render 'a --shard 1/2"}) {
        write("001-of-002", 9, command);
        EXPECT_EQ(commandOf(partsIn(folder_.path()), 2), "") << command;
    }
    write("001-of-002", 9, "impulse render 'it'\\''s; a' --shard 1/2");
    EXPECT_EQ(commandOf(partsIn(folder_.path()), 2), "impulse render 'it'\\''s; a' --shard 2/2");
}

TEST(PartsOfMany, HaveEachItemOnce) {
    for (std::size_t item = 0; item < 40; ++item) {
        int parts = 0;
        for (int number = 1; number <= 16; ++number) parts += isIn({number, 16}, item);
        EXPECT_EQ(parts, 1) << item;
    }
    EXPECT_THROW(checkShard({1, 17}, 16, "runs"), Stop);
    EXPECT_NO_THROW(checkShard({1, 16}, 16, "runs"));
}

TEST(PartsOfMany, HaveTheCommandOfTheWholeToo) {
    EXPECT_EQ(commandOfWhole("impulse test a --shard 2/3 -j 1", "impulse test "),
              "impulse test a -j 1");
    EXPECT_EQ(commandOfWhole("impulse test a --shard=2/3", "impulse test "), "impulse test a");
    EXPECT_EQ(commandOfWhole("impulse test a; true --shard 2/3", "impulse test "), "");
}

/// Without the whole run's own hash most parts decide which is odd.
TEST(PartsOfMany, MostPartsDecideUnlessTheRunIsKnown) {
    const std::vector<PartSeen> parts = {{{1, 3}, true, true, 7, "p", ""},
                                         {{2, 3}, true, true, 8, "p", ""},
                                         {{3, 3}, true, true, 8, "p", ""}};
    EXPECT_EQ(reviewed(parts, "here").wanted, (std::vector<int>{1}));
    EXPECT_EQ(reviewed(parts, "here", 7).wanted, (std::vector<int>{2, 3}));
    EXPECT_EQ(reviewed(parts, "here", 9).troubles.front(), "of another run: 1 2 3");
}

TEST_F(PartsOfAFilm, HaveTheCameraOfTheWholeRunFromItsStates) {
    SceneDescription scene;
    scene.seconds = 2.0;
    CameraDescription camera;
    camera.from = Vec3(1, 2, 3), camera.lookAt = Vec3(4, 5, 6);
    const StateKind kind{"1.0", 7, "a", 8};
    writeCamera(folder_.path(), kind, scene, camera);
    const auto isRead = [&](const StateKind& its, SceneDescription into) {
        readCamera(folder_.path(), its, into);
        return !into.camera.fitsMotion && into.camera.from == camera.from && into.camera.lookAt == camera.lookAt;
    };
    EXPECT_TRUE(isRead(kind, scene));
    EXPECT_FALSE(isRead({"1.0", 7, "a", 9}, scene));
    SceneDescription longer = scene, placed = scene;
    longer.seconds = 3.0, placed.camera.fitsMotion = false;
    EXPECT_FALSE(isRead(kind, longer));
    EXPECT_FALSE(isRead(kind, placed));
    std::vector<std::uint8_t> bytes = contentOf(folder_ / "camera.state");
    bytes.back() ^= 1;
    render::writeFileAtomically(folder_ / "camera.state", bytes);
    EXPECT_FALSE(isRead(kind, scene));
    std::filesystem::remove(folder_ / "camera.state");
    EXPECT_FALSE(isRead(kind, scene));
}

}  // namespace
}  // namespace demos::test
