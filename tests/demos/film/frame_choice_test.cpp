// --frames and --shard: which frames a run draws.
#include "demos/film/frame_choice.h"

#include <gtest/gtest.h>

#include "demos/text/stop.h"

namespace demos::test {
namespace {

std::vector<int> numbers(const std::vector<bool>& chosen) {
    std::vector<int> all;
    for (std::size_t i = 0; i < chosen.size(); ++i)
        if (chosen[i]) all.push_back(static_cast<int>(i));
    return all;
}

std::vector<int> framesOf(const std::string& list) { return numbers(chosenFrames(list, {}, 30)); }

TEST(FrameChoice, TakesListsOfRanges) {
    EXPECT_EQ(framesOf("").size(), 30u);
    EXPECT_EQ(framesOf("4..7"), (std::vector<int>{4, 5, 6, 7}));
    EXPECT_EQ(framesOf("0..-1").size(), 30u);
    EXPECT_EQ(framesOf("0..9:4,-1"), (std::vector<int>{0, 4, 8, 29}));
    EXPECT_EQ(framesOf("20,3..4,3"), (std::vector<int>{3, 4, 20}));
    EXPECT_EQ(framesOf("-3..-2"), (std::vector<int>{27, 28}));
}

TEST(FrameChoice, RefusesWhatIsNoList) {
    for (const char* list : {",", "1,", "1..", "..2", "1..2:0", "1..2:-1", "1..2:", "30", "-31",
                             "7..4", "0..30", "a", "1-2", "99999999999", "1 2", "1..2..3"})
        EXPECT_THROW(framesOf(list), Stop) << list;
}

TEST(FrameChoice, PartsOfAFilmAreItsFramesEachOnce) {
    for (const int frames : {16, 17, 299, 1'000'000})
        for (const int count : {1, 3, 16}) {
            int next = 0;
            for (int number = 1; number <= count; ++number) {
                const Shard shard{number, count};
                EXPECT_EQ(shard.first(frames), next);
                EXPECT_GT(shard.end(frames), next);
                next = shard.end(frames);
            }
            EXPECT_EQ(next, frames);
        }
    EXPECT_EQ(numbers(chosenFrames("", Shard{2, 3}, 9)), (std::vector<int>{3, 4, 5}));
    EXPECT_THROW(chosenFrames("", Shard{1, 10}, 9), Stop);
}

TEST(FrameChoice, NamesOfPartsReadBack) {
    EXPECT_EQ(shardCalled("3/16").name(), "003-of-016");
    EXPECT_EQ(shardNamed("1234-of-5678")->name(), "1234-of-5678");
    for (const char* text :
         {"0/4", "5/4", "1/0", "1/10001", "1", "1/", "/2", "1/2/3", "a/b", "-1/2"})
        EXPECT_THROW(shardCalled(text), Stop) << text;
    for (const char* name : {"3-of-16", "003-of-16", "run", "003-of-016x", "004-of-003"})
        EXPECT_FALSE(shardNamed(name)) << name;
}

}  // namespace
}  // namespace demos::test
