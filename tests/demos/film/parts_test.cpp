// The parts of a film in a folder, whose records may be damaged or come from elsewhere.
#include <gtest/gtest.h>

#include <fstream>

#include "demos/film/parts.h"
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
    write("003-of-003", 900'000, "impulse render a --shard 3/3");
    const Parts parts = partsIn(folder_.path());
    EXPECT_EQ(parts.whole.frames.size(), 9u);
    EXPECT_EQ(parts.wanted, std::vector<int>{3});
    EXPECT_EQ(commandOf(parts, 3), "impulse render a --shard 3/3");
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

}  // namespace
}  // namespace demos::test
