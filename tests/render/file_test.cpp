#include "render/encode/file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <vector>

#include "render/error.h"
#include "tests/support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;

/// Every test has its own empty folder.
class AtomicFile : public testing::Test {
protected:
    std::ptrdiff_t filesInFolder() const {
        return std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
    }
    static std::string contentOf(const fs::path& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    support::TemporaryFolder folder_;
};

TEST_F(AtomicFile, HoldsTheBytesAndLeavesNothingBeside) {
    const fs::path path = folder_ / "frame.bin";
    const std::vector<std::uint8_t> bytes = {0, 255, 10, 13, 26, 0};
    render::writeFileAtomically(path, bytes);
    EXPECT_EQ(contentOf(path), std::string(bytes.begin(), bytes.end()));
    EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFile, ReplacesWhatWasThere) {
    const fs::path path = folder_ / "run.json";
    render::writeFileAtomically(path, "a long first version");
    render::writeFileAtomically(path, "second");
    EXPECT_EQ(contentOf(path), "second");
    render::writeFileAtomically(path, "");
    EXPECT_EQ(contentOf(path), "");
    EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFile, NamesAreOnlyNames) {
    for (const char* name : {"-x.png", "a;touch pwned", "%d%n", "a:b", "$(id)", " "}) {
        render::writeFileAtomically(folder_ / name, "x");
        EXPECT_EQ(contentOf(folder_ / name), "x") << name;
    }
    EXPECT_EQ(filesInFolder(), 6);
}

TEST_F(AtomicFile, NeverWritesThroughASymlink) {
    const fs::path victim = folder_ / "victim", link = folder_ / "link.png";
    std::ofstream(victim) << "precious";
    fs::create_symlink(victim, link);
    EXPECT_THROW(render::writeFileAtomically(link, "x"), render::Error);
    EXPECT_EQ(contentOf(victim), "precious");
    EXPECT_TRUE(fs::is_symlink(link));
    EXPECT_EQ(filesInFolder(), 2);
}

TEST_F(AtomicFile, TheTemporaryNameIsNoWayThroughEither) {
    const fs::path victim = folder_ / "victim", path = folder_ / "frame.png";
    std::ofstream(victim) << "precious";
    fs::create_symlink(victim, render::temporaryNameFor(path));
    render::writeFileAtomically(path, "x");
    EXPECT_EQ(contentOf(victim), "precious");
    EXPECT_EQ(contentOf(path), "x");
    EXPECT_FALSE(fs::is_symlink(path));
}

TEST_F(AtomicFile, RefusesFoldersAndDevices) {
    fs::create_directory(folder_ / "frames");
    ASSERT_EQ(::mkfifo((folder_ / "fifo").c_str(), 0600), 0);
    EXPECT_THROW(render::writeFileAtomically(folder_ / "frames", "x"), render::Error);
    EXPECT_THROW(render::writeFileAtomically(folder_ / "fifo", "x"), render::Error);
    EXPECT_EQ(filesInFolder(), 2);
}

TEST_F(AtomicFile, SeveralAreWrittenAllOrNone) {
    const std::vector<std::uint8_t> one = {1}, two = {2, 2};
    const fs::path a = folder_ / "a", b = folder_ / "b";
    const render::NamedBytes both[] = {{a, one}, {b, two}};
    render::writeFilesTogether(both);
    EXPECT_EQ(contentOf(a), "\x01");
    EXPECT_EQ(contentOf(b), "\x02\x02");
    const render::NamedBytes lost[] = {{a, two}, {folder_ / "no folder/b", one}};
    EXPECT_THROW(render::writeFilesTogether(lost), render::Error);
    EXPECT_EQ(contentOf(a), "\x01");
    EXPECT_EQ(filesInFolder(), 2);
}

TEST_F(AtomicFile, WhatHasAppearedIsKeptWhereItIsToBe) {
    const fs::path path = folder_ / "a.glb";
    render::writeFileAtomically(path, "first", render::Existing::kept);
    EXPECT_THROW(render::writeFileAtomically(path, "second", render::Existing::kept),
                 render::AlreadyThere);
    EXPECT_EQ(contentOf(path), "first");
    EXPECT_EQ(filesInFolder(), 1);
}

TEST_F(AtomicFile, LeavingsOfKilledRunsGoWithTheNextWrite) {
    const fs::path path = folder_ / "a.glb";
    std::ofstream(folder_ / "a.glb.tmp4194399") << "torn";
    std::ofstream(folder_ / "a.glb.tmp12x") << "a user's";
    const fs::path other = folder_ / "a.glb.tmp4194398";
    const int held = render::createTemporary(other, other);
    render::writeFileAtomically(path, "whole");
    EXPECT_FALSE(fs::exists(folder_ / "a.glb.tmp4194399"));
    EXPECT_TRUE(fs::exists(folder_ / "a.glb.tmp12x"));
    EXPECT_TRUE(fs::exists(other)) << "another run writes it now";
    ::close(held);
    render::writeFileAtomically(path, "again");
    EXPECT_FALSE(fs::exists(other));
}

TEST_F(AtomicFile, SaysWhichPathAndWhy) {
    const fs::path path = folder_ / "missing" / "frame.png";
    try {
        render::writeFileAtomically(path, "x");
        FAIL() << "the folder does not exist";
    } catch (const render::Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find(path.string()), std::string::npos) << text;
        EXPECT_NE(text.find("No such file or directory"), std::string::npos) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos);
    }
    EXPECT_EQ(render::describeError(ENOSPC), "disk full");
}

/// In a child process: writes 1 MB where only 100 kB are allowed. 0: it throws Error.
int writeTooMuch(const fs::path& path) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {100'000, 100'000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
    try {
        render::writeFileAtomically(path, std::string(1'000'000, 'x'));
        return 1;
    } catch (const render::Error& error) {
        return std::string(error.what()).find("file larger than") != std::string::npos ? 0 : 2;
    }
}

TEST_F(AtomicFile, AFullDiskLeavesTheOldFileAndNoTemporary) {
    const fs::path fresh = folder_ / "new.png", old = folder_ / "old.png";
    std::ofstream(old) << "precious";
    for (const fs::path& path : {fresh, old}) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) ::_exit(writeTooMuch(path));
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 0);
    }
    EXPECT_FALSE(fs::exists(fresh));
    EXPECT_EQ(contentOf(old), "precious");
    EXPECT_EQ(filesInFolder(), 1);
}

}  // namespace
