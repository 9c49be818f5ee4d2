/// MuJoCo models from a few lines of text, for the tests of their reader.
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/model_reader.h"
#include "demos/play/stage.h"
#include "demos/scene/reader.h"
#include "tests/demos/reading.h"

namespace demos::test {

using Files = std::map<std::string, std::string>;  // text by path

/// The model `a.xml` in the folder of `files`.
inline SceneDescription readModelText(const std::string& text, const Files& files = {},
                                      const std::vector<std::string>& overrides = {}) {
    return mjcf::readModel(text, "a.xml", "a", overrides, [&](const std::filesystem::path& path) {
        const auto found = files.find(path.string());
        if (found == files.end()) throw SceneError({path.string() + ": there is no such file"});
        return found->second;
    });
}

/// `inside` begins at line 2.
inline SceneDescription readMujoco(const std::string& inside, const Files& files = {}) {
    return readModelText("<mujoco>\n" + inside + "</mujoco>\n", files);
}

inline SceneDescription readWorldBody(const std::string& inside) {
    return readMujoco("<worldbody>\n" + inside + "</worldbody>\n");
}

inline std::vector<std::string> modelErrors(const std::string& text, const Files& files = {},
                                            const std::vector<std::string>& overrides = {}) {
    try {
        readModelText(text, files, overrides);
    } catch (const SceneError& error) {
        return error.lines();
    }
    return {};
}

inline void expectNear(const Vec3& a, const Vec3& b, double within = 1e-12) {
    EXPECT_LE((a - b).norm(), within) << a.transpose() << " and " << b.transpose();
}

/// Simulates the given number of seconds.
inline void playFor(double seconds, Stage& stage) {
    for (int i = 0; i < static_cast<int>(seconds * stage.scene.hz + 0.5); ++i)
        ASSERT_TRUE(stage.step());
}

}  // namespace demos::test
