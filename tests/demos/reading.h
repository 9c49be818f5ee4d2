/// Scenes from a few lines of text, for the tests of the reader.
#pragma once
#include <string>
#include <vector>

#include "demos/scene/description.h"
#include "demos/scene/reader.h"
#include "demos/text/complaints.h"

namespace demos::test {

// Not inline: what a file makes of them at the start is made after them.
const std::string kFloor =
    "[[body]]\nname = 'floor'\nshape = { plane = [0, 1, 0] }\nfixed = true\n";
const std::string kBall =
    "[[body]]\nname = 'ball'\nshape = { sphere = 0.5 }\nat = [0, 2, 0]\n";

/// `text` begins at line 2.
inline SceneDescription read(const std::string& text,
                             const std::vector<std::string>& overrides = {}) {
    return readScene("format = 1\n" + text, "a.toml", "a", overrides);
}

/// `text` is all of the scene.
inline SceneDescription sceneFrom(const std::string& text) {
    return readScene(text, "test", "test");
}

inline std::vector<std::string> errorsOf(const std::string& text,
                                         const std::vector<std::string>& overrides = {}) {
    try {
        readScene(text, "a.toml", "a", overrides);
    } catch (const SceneError& error) {
        return error.lines();
    }
    return {};
}

inline std::string listed(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return all;
}

/// True when one of the lines begins with `place` and holds `text`.
inline bool tells(const std::vector<std::string>& lines, const std::string& place,
                  const std::string& text) {
    for (const std::string& line : lines)
        if (line.starts_with(place) && line.find(text) != std::string::npos) return true;
    return false;
}

}  // namespace demos::test
