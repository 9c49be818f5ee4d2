#include "demos/commands/states.h"

#include <fmt/format.h>

#include "demos/commands/shared_options.h"
#include "demos/film/film_plan.h"
#include "demos/text/complaints.h"
#include "demos/text/plural.h"
#include "demos/text/stop.h"
#include "render/encode/file.h"

namespace demos {

void addStates(CLI::App& app, StatesOptions& options, Options& picture, OptionTexts& texts) {
    app.add_option("--states", options.states,
                   "write states into this folder, as DIR/000240.state after step 240: for --from, "
                   "and for impulse render --states; default: not written")
        ->type_name("DIR");
    app.add_option("--from", options.from,
                   "continue from a state, to the same bits; default: from time 0")
        ->type_name("FILE");
    app.add_option("--every", options.every,
                   "write rows and states of every Nth step only; default: rows of every step, "
                   "states once a second")
        ->type_name("N");
    addMemory(app, picture, texts);
}

States::States(const StatesOptions& options, const Options& picture, const SceneDescription& scene)
    : folder_(options.states),
      from_(options.from),
      every_(options.every.value_or(scene.hz)),
      overlays_{.trails = false} {
    if (folder_.empty() && from_.empty()) return;
    overlays_ = overlaysOf(scene, picture);
    overlays_.ghost = overlays_.stats = true;
    kind_ = stateKindOf(scene, picture);
    if (!folder_.empty()) render::makeFolder(folder_);
    if (!folder_.empty() && from_.empty() && scene.camera.fitsMotion) motion_.emplace(scene);
}

void States::goOn(long last, Player& player) const {
    if (from_.empty()) return;
    const long long step = goOnFrom(from_, kind_, overlays_, player);
    if (step > last)
        refuse(
            fmt::format("--from {}: is a state after step {}, and the run ends with step {}; "
                        "--seconds makes it longer",
                        printable(from_), step, last));
}

void States::look(const Player& player, long step) {
    if (motion_) motion_->look(player.stage(), step);
    if (folder_.empty() || step == 0 || step % every_ != 0) return;
    writeState(folder_, kind_, overlays_, player, memory_);
    ++count_;
}

void States::finish(const Player& player) const {
    if (motion_) writeCamera(folder_, kind_, player.stage().scene, motion_->camera());
}

void States::say(const Talk& talk) const {
    if (!folder_.empty())
        talk.say(fmt::format("wrote {} ({})", printable((folder_ / "*.state").string()),
                             plural(count_, "state")));
}

}  // namespace demos
