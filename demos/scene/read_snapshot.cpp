// [snapshot]

#include <algorithm>
#include <cmath>

#include "demos/scene/table_readers.h"

namespace demos {
namespace {

constexpr std::size_t kMostSnapshots = 100;
constexpr double kMostSnapshotPixels = 134'217'728.0;  // 512 MB of RGBA

/// Numbers other than the defaults need a reason, which reports repeat.
void readReason(Keys& keys, const char* of, std::string& why) {
    set(why, keys.text("why"));
    if (why.empty())
        keys.complain("why", std::string("a ") + of + " needs a reason: why = \"...\"");
    keys.done();
}

void readTolerance(Keys& snapshot, Tolerance& tolerance) {
    const Value* table = snapshot.any("tolerance");
    if (!table) return;
    Keys keys = snapshot.inner(*table, "a tolerance");
    set(tolerance.position, keys.number("position", {1e-9, 1e5, "m"}));
    set(tolerance.angleDegrees, keys.number("angle_deg", {1e-6, 180.0, "deg"}));
    set(tolerance.load, keys.number("load", {1e-3, 1e9}));
    readReason(keys, "tolerance", tolerance.why);
}

void readGate(Keys& snapshot, PictureGate& gate) {
    const Value* table = snapshot.any("gate");
    if (!table) return;
    Keys keys = snapshot.inner(*table, "a gate");
    set(gate.levels, keys.whole("levels", {0, 255, "of 255"}));
    set(gate.windowPixels, keys.whole("window", {0, 256, "pixels of a 16x16 window"}));
    set(gate.ssim, keys.number("ssim", {-1.0, 1.0}));
    readReason(keys, "gate", gate.why);
}

void readSize(Keys& keys, Snapshot& snapshot) {
    constexpr Range kPixels{1.0, 16384.0, "pixels"};
    const auto isWhole = [](double pixels) { return pixels == std::floor(pixels); };
    const auto size = keys.numbers("size", kPixels);
    if (!size) return;
    if (size->size() != 2 || !std::all_of(size->begin(), size->end(), isWhole))
        return keys.complain("size", "size should be two whole numbers [width, height] in pixels");
    snapshot.width = static_cast<int>((*size)[0]);
    snapshot.height = static_cast<int>((*size)[1]);
}

/// All pictures of a test are kept until the last is compared.
void checkPictures(Keys& keys, const Snapshot& snapshot) {
    const double pixels = static_cast<double>(snapshot.times.size()) * snapshot.width *
                          snapshot.height;
    if (snapshot.times.size() > kMostSnapshots)
        keys.complain("times", std::to_string(snapshot.times.size()) +
                                   " times; a snapshot should have at most " +
                                   std::to_string(kMostSnapshots));
    else if (pixels > kMostSnapshotPixels)
        keys.complain("times", std::to_string(snapshot.times.size()) + " pictures of " +
                                   std::to_string(snapshot.width) + "x" +
                                   std::to_string(snapshot.height) +
                                   "; they should have at most 134217728 pixels in all");
}

/// Pictures are identified by their times, so no two may have the same.
void readTimes(Keys& keys, const SceneDescription& scene, std::vector<double>& times) {
    set(times, keys.numbers("times", {0.0, scene.seconds, "s"}));
    if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end())
        keys.complain("times", "times should be in rising order");
}

}  // namespace

void readSnapshot(Keys& top, SceneDescription& scene) {
    const Value* table = top.any("snapshot");
    if (!table) return;
    Keys keys = top.inner(*table, "[snapshot]");
    readTimes(keys, scene, scene.snapshot.times);
    readSize(keys, scene.snapshot);
    checkPictures(keys, scene.snapshot);
    readTolerance(keys, scene.snapshot.tolerance);
    readGate(keys, scene.snapshot.gate);
    keys.done();
}

}  // namespace demos
