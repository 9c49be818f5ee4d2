/// A scene's baseline: NAME.snapshots/ with a picture per listed time and baseline.json.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "demos/regression/trajectory.h"
#include "demos/scene/description.h"

namespace demos {

/// In the order in which they are reported.
using Settings = std::vector<std::pair<std::string, std::string>>;

struct BaselinePicture {
    double time = 0.0;         // s
    std::uint64_t state = 0;   // hash of the world
    std::uint64_t png = 0;     // TextHash of the file
};

struct Baseline {
    std::string scene;             // its name
    std::string version;           // of the program
    std::string renderer, pixels;  // as in run.json
    int width = 0, height = 0;     // pixels
    Settings settings;             // what may make another run differ
    std::vector<BaselinePicture> pictures;  // by time
    Trajectory trajectory;
    std::string trajectoryText;  // as it was read: not rounded again when it is written again
};

/// A baseline that cannot be used; one line.
class BaselineError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

inline constexpr const char* kBaselineFile = "baseline.json";
inline constexpr const char* kSnapshotsEnding = ".snapshots";

/// The picture of a time (s) in a baseline, constant or not; null: it has none.
auto* pictureAt(auto& baseline, double time) {
    for (auto& picture : baseline.pictures)
        if (picture.time == time) return &picture;
    return static_cast<decltype(baseline.pictures.data())>(nullptr);
}

/// "t2.5.png"
std::string pictureFile(double time);

/// Sealed: the text holds a hash of itself, so that a change by hand is seen. `tolerance`: decides
/// how finely the trajectory is kept.
std::string jsonOf(const Baseline& baseline, const Tolerance& tolerance);
/// Throws BaselineError; `name`: the file's.
Baseline baselineFrom(const std::string& text, const std::string& name);

/// Nothing where there is no such file. Throws BaselineError.
std::optional<Baseline> readBaseline(const std::filesystem::path& folder);

/// A picture's file, when it is the one that the baseline is of. Throws BaselineError.
std::vector<std::uint8_t> readPicture(const std::filesystem::path& folder,
                                      const BaselinePicture& picture);

/// PNG files in it that are of none of these times, sorted.
std::vector<std::string> orphansOf(const std::filesystem::path& folder,
                                   const std::vector<double>& times);

}  // namespace demos
