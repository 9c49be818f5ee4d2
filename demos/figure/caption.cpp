#include "demos/figure/caption.h"

#include <fmt/format.h>

#include <algorithm>

#include "demos/film/progress.h"
#include "demos/scene/solver_settings.h"
#include "demos/text/complaints.h"
#include "demos/text/version.h"

namespace demos {
namespace {

std::string listOf(const std::vector<PictureFacts>& facts,
                   std::string (*text)(const PictureFacts&)) {
    std::string list;
    for (const PictureFacts& fact : facts) list += (list.empty() ? "" : ", ") + text(fact);
    return list;
}

bool isNowhere(const std::string& name, const std::vector<PictureFacts>& facts) {
    return !facts.empty() && std::all_of(facts.begin(), facts.end(), [&](const PictureFacts& fact) {
        return std::find(fact.leftOut.begin(), fact.leftOut.end(), name) != fact.leftOut.end();
    });
}

/// The overlays that are on and have room in at least one picture.
std::string shownText(const Overlays& shown, const std::vector<PictureFacts>& facts) {
    std::string text;
    for (const std::string& name : overlayNames())
        if (isOn(shown, name) && !isNowhere(name, facts)) text += (text.empty() ? "" : " ") + name;
    return text;
}

}  // namespace

void Caption::add(const std::string& name, const std::string& value) {
    if (!value.empty()) rows_.emplace_back(name, value);
}

std::string Caption::text() const {
    std::string text = printable(sentence_) + ".\n\n";
    for (const auto& [name, value] : rows_)
        text += fmt::format("{}: {}\n", printable(name), printable(value));
    return text;
}

std::string titleOf(const SceneDescription& scene) {
    std::string title = scene.title.empty() ? scene.name : scene.title;
    while (title.ends_with('.') || title.ends_with(' ')) title.pop_back();
    return title;
}

void addFiles(const std::vector<std::string>& files, PictureSize size, const Paper& paper,
              Caption& caption) {
    caption.add("figure", fmt::format("{}", fmt::join(files, " ")));
    if (paper.given())
        caption.add("size on paper",
                    fmt::format("{:g} x {:.1f} mm, {}x{} pixels at {} dpi", paper.width,
                                paper.width * size.height / size.width, size.width, size.height,
                                paper.dpi));
    else
        caption.add("size", fmt::format("{}x{} pixels", size.width, size.height));
}

void addLook(const Overlays& overlays, const std::vector<PictureFacts>& facts, Caption& caption) {
    caption.add("theme", overlays.theme);
    caption.add("shown", shownText(overlays, facts));
    if (overlays.colorBy != "body") caption.add("colours", overlays.colorBy);
}

std::string solverText(const SceneDescription& scene) {
    const std::string beside = besidePreset(scene.settings, scene.preset);
    return "preset " + scene.preset + (beside.empty() ? "" : "; " + beside);
}

void addWorld(const SceneDescription& scene, const Options& options, Caption& caption) {
    const SceneDescription usual;
    caption.add("scene", options.scene());
    caption.add("steps a second", std::to_string(scene.hz));
    if (scene.gravity != usual.gravity)
        caption.add("gravity",
                    fmt::format("{} {} {} m/s^2", numberText(scene.gravity.x()),
                                numberText(scene.gravity.y()), numberText(scene.gravity.z())));
    if (scene.seed != usual.seed) caption.add("seed", std::to_string(scene.seed));
}

void addPhysics(const SceneDescription& scene, const Options& options, Caption& caption) {
    addWorld(scene, options, caption);
    caption.add("solver", solverText(scene));
    caption.add("set", fmt::format("{}", fmt::join(options.overrides, " ")));
}

void addShots(const std::vector<PictureFacts>& facts, Caption& caption) {
    caption.add(facts.size() > 1 ? "times" : "time", listOf(facts, [](const PictureFacts& fact) {
                    return fmt::format("{:.3f} s", fact.time);
                }));
    caption.add(facts.size() > 1 ? "steps" : "step",
                listOf(facts, [](const PictureFacts& fact) { return std::to_string(fact.step); }));
    caption.add(facts.size() > 1 ? "states" : "state",
                listOf(facts, [](const PictureFacts& fact) { return hexText(fact.state); }));
}

void addProgram(const Options& options, Caption& caption) {
    caption.add("program", fmt::format("impulse {}", kVersion));
    caption.add("command", options.commandLine);
}

}  // namespace demos
