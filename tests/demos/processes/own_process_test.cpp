// Work in a process of its own ends here as it ended there.
#include "demos/processes/own_process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <stdexcept>

#include "demos/text/stop.h"
#include "render/context.h"
#include "render/error.h"

namespace demos {
namespace {

std::string errorOf(const std::function<std::string()>& work) {
    try {
        return "returned " + inOwnProcess("the process that works", work);
    } catch (const render::Error& error) {
        return error.what();
    }
}

TEST(OwnProcess, ReturnsWhatItsWorkReturned) {
    const pid_t here = getpid();
    const std::string bytes("a\0b", 3);
    EXPECT_EQ(inOwnProcess("it", [&] { return bytes; }), bytes);
    EXPECT_EQ(inOwnProcess("it", [] { return std::string(); }), "");
    EXPECT_NE(inOwnProcess("it", [] { return std::to_string(getpid()); }), std::to_string(here));
}

TEST(OwnProcess, ThrowsWhatItsWorkThrew) {
    for (const Exit code : {Exit::diverged, Exit::interrupted, Exit::usage}) {
        try {
            inOwnProcess("it", [code]() -> std::string { throw Stop(code, "why"); });
            FAIL() << "returned";
        } catch (const Stop& stop) {
            EXPECT_EQ(stop.code(), code);
            EXPECT_STREQ(stop.what(), "why");
        }
    }
    EXPECT_EQ(errorOf([]() -> std::string { throw render::Error("no OpenGL"); }), "no OpenGL");
    EXPECT_EQ(errorOf([]() -> std::string { throw std::runtime_error("other"); }), "other");
}

TEST(OwnProcess, SaysHowItWasKilled) {
    EXPECT_EQ(errorOf([]() -> std::string { raise(SIGKILL); return {}; }),
              "the process that works was killed by signal 9 (Killed)");
}

/// The next processes that draw are forked from this one.
TEST(OwnProcess, LeavesNoContextHere) {
    const auto draw = [] {
        render::ContextSettings settings;
        settings.width = settings.height = 16, settings.threads = 0;
        return render::makeContext(settings)->describe();
    };
    EXPECT_NE(inOwnProcess("it", draw), "");
    EXPECT_NO_THROW(render::preloadContext(render::ContextKind::automatic));
    EXPECT_EQ(errorOf([&] {
                  draw();
                  render::preloadContext(render::ContextKind::automatic);
                  return std::string();
              }),
              "processes that draw are forked before the first context is made");
}

}  // namespace
}  // namespace demos
