#include "demos/regression/verdict_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/shell_word.h"

namespace demos {
namespace {

using State = SceneVerdict::State;

const char* wordOf(State state) {
    switch (state) {
        case State::passed:
            return "ok";
        case State::failed:
            return "FAILED";
        case State::added:
            return "new";
        case State::updated:
            return "updated";
        case State::error:
            break;
    }
    return "ERROR";
}

void addPicture(const SceneVerdict& scene, const PictureVerdict& picture,
                std::vector<std::string>& lines) {
    const std::string name = "picture " + pictureName(scene.name, picture.time);
    if (picture.kind == PictureVerdict::Kind::changed)
        lines.push_back(name + ": " + differenceText(picture.difference, scene.snapshot.gate));
    if (picture.kind == PictureVerdict::Kind::broken && !picture.problem.empty())
        lines.push_back(name + ": " + picture.problem);
    if (picture.kind == PictureVerdict::Kind::added && scene.state == State::failed)
        lines.push_back(name + ": there is no baseline of this picture");
}

void addExpectations(const SceneVerdict& scene, std::vector<std::string>& lines) {
    for (const ExpectationResult& result : scene.expectations)
        if (!result.passed)
            lines.push_back(fmt::format("expectation failed: {}: {}{}", result.text, cameOut(result),
                                        result.why.empty() ? "" : " (" + result.why + ")"));
}

/// What was changed on purpose, perhaps: with a difference its cause, or else without an effect.
void addSettings(const SceneVerdict& scene, std::vector<std::string>& lines) {
    constexpr std::size_t kMost = 8;
    const bool wrong = scene.state == State::failed || scene.state == State::updated;
    if (!wrong && scene.state != State::passed) return;
    const std::vector<SettingChange> changes = wrong ? scene.settings : scene.changedScene();
    if (changes.empty()) return;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i)
        texts.push_back(settingText(changes[i]));
    const char* head = wrong ? "made with other settings"
                             : "changed, but no motion, force or picture beyond the tolerances";
    const std::string more =
        changes.size() > kMost ? fmt::format(" (and {} more)", changes.size() - kMost) : "";
    lines.push_back(fmt::format("{}: {}{}", head, fmt::join(texts, ", "), more));
}

/// Whether accepting something would make the scene pass.
bool canApprove(const SceneVerdict& scene) {
    return scene.state == State::failed && scene.keepsContract() && !scene.pictures.empty();
}

}  // namespace

std::string differenceText(const render::Difference& d, const PictureGate& gate) {
    render::Gate limits;
    limits.levels = gate.levels;
    return fmt::format(
        "{} pixels differ, by {} of 255 at most; the worst 16x16 window, at {},{}, has "
        "{} that differ by more than {} ({} allowed); an area of 8x8 changed its colour by {:.1f} "
        "({:.1f} allowed); lowest SSIM {:.3f} ({:.2f} needed)",
        d.differing, d.largest, d.windowX, d.windowY, d.worstWindow, gate.levels, gate.windowPixels,
        d.worstShift, limits.shift(), d.worstSsim, gate.ssim);
}

std::string settingText(const SettingChange& change) {
    if (change.baseline.empty() && change.actual.empty()) return change.key;
    const auto shownValue = [](const std::string& value) { return value.empty() ? "-" : value; };
    return fmt::format("{} {} -> {}", change.key, shownValue(change.baseline),
                       shownValue(change.actual));
}

std::string headline(const SceneVerdict& scene) {
    std::string line = fmt::format("{:<8} {}", wordOf(scene.state), printable(scene.name));
    if (scene.cached) return line + "  (as before)";
    if (!scene.pictures.empty()) line += "  " + plural(scene.pictures.size(), "picture");
    if (!scene.expectations.empty())
        line += (scene.pictures.empty() ? "  " : ", ") +
                plural(scene.expectations.size(), "expectation");
    return line;
}

std::vector<std::string> detailsOf(const SceneVerdict& scene) {
    std::vector<std::string> lines;
    if (!scene.problem.empty()) lines.push_back(scene.problem);
    lines.insert(lines.end(), scene.physics.lines.begin(), scene.physics.lines.end());
    for (const PictureVerdict& picture : scene.pictures) addPicture(scene, picture, lines);
    addExpectations(scene, lines);
    addSettings(scene, lines);
    for (const std::string& orphan : scene.orphans)
        lines.push_back(orphan +
                        " belongs to a time that the scene does not list; impulse approve "
                        "--prune removes it");
    if (canApprove(scene)) lines.push_back("to accept it: impulse approve " + shellWord(scene.name));
    for (std::string& line : lines) line = printable(line);
    return lines;
}

std::string summaryOf(const TestVerdict& verdict) {
    std::vector<std::string> parts;
    for (const State state :
         {State::passed, State::failed, State::error, State::added, State::updated})
        if (const int count = verdict.count(state); count > 0)
            parts.push_back(fmt::format("{} {}", count, nameOf(state)));
    return fmt::format("{}: {}", plural(verdict.scenes.size(), "scene"), fmt::join(parts, ", "));
}

}  // namespace demos
