// Rules for all commands that write a file.
#include "tests/demos/program.h"

namespace demos::test {
namespace {

/// A command on ball.toml; its last word is the file that it writes.
class WritesAFile : public testing::TestWithParam<std::vector<std::string>> {
protected:
    WritesAFile() { write(folder / "ball.toml", kBall); }
    TemporaryFolder folder;
};

TEST_P(WritesAFile, AFullDiskIsCode4AndLeavesNoFile) {
    Launch launch;
    launch.folder = folder.path();
    launch.arguments = GetParam();
    launch.beforeExec = [] {
        const rlimit limit{1000, 1000};  // bytes per file
        setrlimit(RLIMIT_FSIZE, &limit);
    };
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_EQ(ended.errorLines(), 1) << ended.err;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);  // the scene alone
}

TEST_P(WritesAFile, NeverWritesThroughASymlink) {
    write(folder / "victim", "untouched");
    fs::create_symlink(folder / "victim", folder / GetParam().back());
    const Ended ended = run(folder.path(), GetParam());
    EXPECT_EQ(ended.code, 4) << ended.err;
    EXPECT_EQ(contentOf(folder / "victim"), "untouched");
}

// The reader goes away at once; the file is complete nevertheless.
TEST_P(WritesAFile, WithoutAReaderOfItsErrors) {
    Launch launch;
    launch.folder = folder.path();
    launch.arguments = GetParam();
    launch.beforeExec = withoutReader(STDERR_FILENO);
    EXPECT_EQ(run(launch).code, 0);
    EXPECT_TRUE(fs::exists(folder / GetParam().back()));
}

TEST_P(WritesAFile, WithoutAReaderOfItsResults) {
    Launch launch;
    launch.folder = folder.path();
    launch.arguments = GetParam();
    launch.beforeExec = withoutReader(STDOUT_FILENO);
    const Ended ended = run(launch);
    EXPECT_EQ(ended.code, 4);
    EXPECT_EQ(ended.err, "impulse: cannot write to standard output\n");
    EXPECT_TRUE(fs::exists(folder / GetParam().back()));
}

INSTANTIATE_TEST_SUITE_P(
    Commands, WritesAFile,
    testing::Values(std::vector<std::string>{"sim", "ball.toml", "--hash", "--bodies", "a.csv"},
                    std::vector<std::string>{"plot", "ball.toml", "-o", "a.svg"},
                    std::vector<std::string>{"export", "ball.toml", "--overwrite", "-o", "a.glb"},
                    std::vector<std::string>{"export", "ball.toml", "--overwrite", "-o", "a.html"}),
    [](const auto& writer) {
        const std::string& file = writer.param.back();
        return writer.param.front() + "_" + file.substr(file.find('.') + 1);
    });

}  // namespace
}  // namespace demos::test
