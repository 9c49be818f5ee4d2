/// A film of a falling ball, small enough to be drawn often: what tests of 'impulse render' share.
#pragma once
#include <cstdio>
#include <map>

#include <set>

#include "render/encode/png.h"
#include "tests/demos/program.h"

namespace demos::test {

constexpr int kWidth = 96, kHeight = 54, kFrames = 10;

using Files = std::map<std::string, std::string>;

inline Files framesIn(const fs::path& folder) {
    Files files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".png")
            files[entry.path().filename().string()] = contentOf(entry.path());
    return files;
}

inline bool isWhole(const std::string& png) {
    return render::pngIsWhole({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()},
                              kWidth, kHeight);
}

inline bool haveTools() {
    return std::system("ffmpeg -version > /dev/null 2>&1 && ffprobe -version > /dev/null 2>&1") ==
           0;
}

/// Frames that can be decoded; -1 when the film does not play.
inline int playableFrames(const fs::path& film) {
    const std::string command =
        "ffprobe -v error -count_frames -select_streams v -show_entries stream=nb_read_frames "
        "-of csv=p=0 '" +
        film.string() + "'";
    FILE* pipe = popen(command.c_str(), "r");
    char text[64] = {};
    const bool got = std::fgets(text, sizeof text, pipe) != nullptr;
    return pclose(pipe) == 0 && got ? std::atoi(text) : -1;
}

inline std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

class SmallFilm : public testing::Test {
protected:
    SmallFilm() { write(folder / "ball.toml", kBall); }

    static Launch small(const fs::path& where, std::vector<std::string> more) {
        Launch launch;
        launch.folder = where;
        launch.arguments = {"render", "ball.toml", "--size",    "96x54",
                            "--fps",  "10",        "--samples", "1"};
        launch.arguments.insert(launch.arguments.end(), more.begin(), more.end());
        return launch;
    }
    Ended film(std::vector<std::string> more) { return run(small(folder.path(), std::move(more))); }

    TemporaryFolder folder;
};

}  // namespace demos::test
