// What a draft's files show after drafts that were given up, in an earlier session's folder, and
// after some were removed.
#include "demos/watch/draft_film.h"

#include <gtest/gtest.h>

#include <fstream>

#include "demos/text/file_content.h"
#include "render/encode/png.h"
#include "tests/support/planted_report.h"
#include "tests/support/temporary_folder.h"

namespace {

using namespace demos;
namespace fs = std::filesystem;

constexpr int kWidth = 96, kHeight = 54;  // pixels
using Grays = std::vector<std::uint8_t>;  // a frame has one gray, which is also its sum

render::Image pictureOf(std::uint8_t gray) { return support::flatImage(kWidth, kHeight, gray); }

/// Drafts as PNG files, without ffmpeg.
class DraftFrames : public testing::Test {
protected:
    DraftFrames() {
        plan_.panels.resize(1);
        plan_.layout.width = kWidth;
        plan_.layout.height = kHeight;
        plan_.fps = 15;
    }

    /// Not closed: given up after its last frame.
    DraftFilm begun(const Grays& grays) {
        DraftFilm film(places_, plan_, store_, files_);
        for (int frame = 0; frame < static_cast<int>(grays.size()); ++frame) {
            const render::Image image = pictureOf(grays[frame]);
            store_.put(frame, image);
            film.add(frame, &image, grays[frame]);
        }
        return film;
    }
    /// Whether something was written.
    bool make(const Grays& grays) {
        files_.look(places_);
        begun(grays).close(static_cast<int>(grays.size()));
        return std::exchange(files_.untold, false);
    }
    void expectFiles(const Grays& grays) const {
        for (int frame = 0; frame < static_cast<int>(grays.size()); ++frame)
            EXPECT_EQ(contentOf(places_.frame(frame)), render::encodePng(pictureOf(grays[frame])))
                << frame;
        EXPECT_FALSE(fs::exists(places_.frame(static_cast<int>(grays.size()))));
    }
    std::vector<std::uint8_t> strip() const { return contentOf(places_.strip()); }

    support::TemporaryFolder folder_;
    DraftPlaces places_{folder_.path(), false};
    FilmPlan plan_;
    FrameStore store_{places_.film(), kWidth, kHeight};
    DraftFiles files_;
};

TEST_F(DraftFrames, TheSameDraftTwiceWritesNothing) {
    EXPECT_TRUE(make({10, 20, 30}));
    expectFiles({10, 20, 30});
    EXPECT_FALSE(make({10, 20, 30}));
}

TEST_F(DraftFrames, WhatAnAbandonedDraftWroteIsWrittenAgain) {
    make({10, 20, 30});
    const std::vector<std::uint8_t> first = strip();
    begun({90, 20});
    EXPECT_TRUE(make({10, 20, 30}));
    expectFiles({10, 20, 30});
    EXPECT_EQ(strip(), first);
}

/// All its frames were written before it was given up: only the strip is older.
TEST_F(DraftFrames, TheStripShowsWhatTheFramesDo) {
    make({10, 20, 30});
    const std::vector<std::uint8_t> first = strip();
    begun({90, 20});
    EXPECT_TRUE(make({90, 20, 30}));
    EXPECT_NE(strip(), first);
}

TEST_F(DraftFrames, ALongerOneLeavesNoFrames) {
    make({10, 20, 30});
    begun({10, 20, 30, 40, 50});
    EXPECT_TRUE(make({10, 20, 30}));
    expectFiles({10, 20, 30});
    EXPECT_FALSE(fs::exists(places_.frame(4)));
}

TEST_F(DraftFrames, AnEarlierSessionLeavesNoFrames) {
    fs::create_directories(places_.frame(0).parent_path());
    for (const fs::path& file : {places_.frame(1), places_.frame(7)})
        std::ofstream(file) << "an earlier session's";
    const fs::path other = places_.frame(0).parent_path() / "notes.png";
    std::ofstream(other) << "somebody's";
    make({10, 20});
    expectFiles({10, 20});
    EXPECT_FALSE(fs::exists(places_.frame(7)));
    EXPECT_TRUE(fs::exists(other));
}

TEST_F(DraftFrames, WhatWasRemovedComesBack) {
    make({10, 20, 30});
    fs::remove(places_.frame(1));
    EXPECT_TRUE(make({10, 20, 30}));
    expectFiles({10, 20, 30});
    fs::remove(places_.strip());
    EXPECT_TRUE(make({10, 20, 30}));
    EXPECT_FALSE(strip().empty());
}

}  // namespace
