// Temporary folders: those of killed runs are removed, others stay.
#include "demos/slides/scratch_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace demos::test {
namespace {

namespace fs = std::filesystem;

TEST(ScratchFolder, GoesWithItsOwnerAndTakesAKilledOnesAlong) {
    constexpr int kNobody = 4194399;  // above the largest process number
    const support::TemporaryFolder place;
    const fs::path dead = place / ("impulse_" + std::to_string(kNobody) + "_Ab3dEf");
    const fs::path living = place / ("impulse_" + std::to_string(getppid()) + "_Ab3dEf");
    const fs::path stranger = place / "impulse_Ab3dEf",
                   link = dead.string().substr(0, dead.string().size() - 1) + "g";
    for (const fs::path& folder : {dead / "media", living, stranger})
        fs::create_directories(folder);
    fs::create_directory_symlink(stranger, link);
    const char* before = std::getenv("TMPDIR");
    const std::optional<std::string> kept =
        before ? std::optional<std::string>(before) : std::nullopt;
    setenv("TMPDIR", place.path().c_str(), 1);
    fs::path own;
    {
        const ScratchFolder scratch;
        own = scratch.path();
        EXPECT_EQ(own.parent_path(), place.path());
        EXPECT_TRUE(fs::is_directory(own));
        const ScratchFolder another;
        EXPECT_TRUE(fs::is_directory(own));
    }
    kept ? setenv("TMPDIR", kept->c_str(), 1) : unsetenv("TMPDIR");
    EXPECT_FALSE(fs::exists(own));
    EXPECT_FALSE(fs::exists(dead));
    EXPECT_TRUE(fs::exists(living));
    EXPECT_TRUE(fs::exists(stranger));
    EXPECT_TRUE(fs::is_symlink(link));
}

}  // namespace
}  // namespace demos::test
