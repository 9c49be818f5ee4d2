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

/// A body that could not continue as it was, or an energy jump (snapshot/player.h).
struct BaselineIncident {
    long long step = 0;
    std::string body;     // empty: no single body
    std::string trouble;  // "too fast"
};

struct Baseline {
    std::string scene;             // its name
    std::string home;              // the folder of the scene's file, from NAME.snapshots;
                                   // kBuiltinHome; empty: not known
    std::string version;           // of the program
    std::string renderer, pixels;  // as in run.json
    int width = 0, height = 0;     // pixels
    Settings settings;             // that may make another run differ
    Settings inputs;               // the scene's values (scene_inputs.h); none: not known
    std::vector<BaselinePicture> pictures;  // by time
    Trajectory trajectory;
    std::string trajectoryText;  // as it was read, so that writing it does not round it again
    std::vector<BaselineIncident> incidents;  // in the order of the steps
};

/// A baseline cannot be used; the message is one line.
class BaselineError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

inline constexpr std::uintmax_t kMostPictureBytes = 256u << 20;
inline constexpr const char* kBuiltinHome = "built-in";
inline constexpr const char* kBaselineFile = "baseline.json";
inline constexpr const char* kSnapshotsEnding = ".snapshots";

/// The picture at a time (s) in a const or non-const baseline; null: there is none.
auto* pictureAt(auto& baseline, double time) {
    for (auto& picture : baseline.pictures)
        if (picture.time == time) return &picture;
    return static_cast<decltype(baseline.pictures.data())>(nullptr);
}

/// "t2.5.png"
std::string pictureFile(double time);

/// Sealed: the text holds a hash of itself, so that an edit is detected. `tolerance` decides how
/// finely the trajectory is kept.
std::string jsonOf(const Baseline& baseline, const Tolerance& tolerance);
/// Throws BaselineError; `name`: of the file.
Baseline baselineFrom(const std::string& text, const std::string& name);

/// Nothing if the folder has no baseline.json. Throws BaselineError.
std::optional<Baseline> readBaseline(const std::filesystem::path& folder);

/// The bytes of a picture's file. Throws BaselineError if the file does not match the baseline.
std::vector<std::uint8_t> readPicture(const std::filesystem::path& folder,
                                      const BaselinePicture& picture);

/// PNG files in the folder that belong to none of these times, sorted.
std::vector<std::string> orphansOf(const std::filesystem::path& folder,
                                   const std::vector<double>& times);

}  // namespace demos
