/// A small scene in a folder of its own, tested and approved as by a user.
#pragma once
#include <nlohmann/json.hpp>

#include "tests/demos/program.h"

namespace demos::test {

using Json = nlohmann::json;

/// A ball that falls on a box; small pictures.
const std::string kBallOnABox = R"(format = 1
title = "a ball on a box"
seconds = 1.0
[[body]]
name = "floor"
shape = { plane = [0, 1, 0] }
fixed = true
[[body]]
name = "box"
shape = { box = [2, 1, 2] }
at = [0, 0.5, 0]
[[body]]
name = "ball"
shape = { sphere = 0.5 }
at = [0.1, 2, 0]
[camera]
from = [3, 2.5, 6]
look_at = [0, 1, 0]
[snapshot]
times = [0.0, 0.5]
size = [160, 90]
[[expect]]
what = "penetration"
below = 0.05
)";

class Snapshots : public testing::Test {
protected:
    Snapshots() { write(folder / "ball.toml", kBallOnABox); }

    /// Runs as if not in CI, wherever these tests run.
    Ended impulse(std::vector<std::string> arguments, bool ci = false) {
        Launch launch;
        launch.folder = folder.path();
        launch.arguments = std::move(arguments);
        launch.beforeExec = [ci] { ci ? setenv("CI", "true", 1) : unsetenv("CI"); };
        return run(launch);
    }
    Ended test(std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"test", "ball.toml"});
        return impulse(more);
    }
    void change(const std::string& from, const std::string& to) {
        std::string text = contentOf(folder / "ball.toml");
        const std::size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        write(folder / "ball.toml", text.replace(at, from.size(), to));
    }
    Json scene() const {
        return Json::parse(contentOf(folder / "output/test/report.json")).at("scenes").at(0);
    }
    std::string baseline(const std::string& file) const {
        return contentOf(folder / "ball.snapshots" / file);
    }
    bool has(const std::string& file) const { return fs::exists(folder / file); }

    TemporaryFolder folder;
};

}  // namespace demos::test
