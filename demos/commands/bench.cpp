#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "demos/commands/commands.h"
#include "demos/film/film_plan.h"
#include "demos/film/progress.h"
#include "demos/film/signals.h"
#include "demos/player.h"
#include "demos/scene/builtin.h"
#include "demos/scene/complaints.h"
#include "render/renderer.h"

namespace demos {
namespace {

constexpr int kStepsASecond = 60;  // of the step that is timed, whatever the scene's own
constexpr int kWindow = 2 * kStepsASecond;

/// s of processor time of this process.
double processorTime() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Timing {
    std::string scene;
    std::size_t bodies = 0, joints = 0;
    int contacts = 0;        // at the end
    int steps = 0;           // that were timed
    std::vector<double> ms;  // a step
    double points = 0.0;     // contact points, added up over the timed steps
    std::uint64_t hash = 0;
    double frameMs = 0.0;  // 0 = not drawn
};

double medianOf(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double pictureTime(const Player& player) {
    render::RendererSettings settings;
    settings.threads = 0;
    render::Renderer renderer(settings);
    std::vector<double> ms;
    for (int i = 0; i < 6; ++i) {
        const double before = processorTime();
        renderer.draw(player.frame(0.0));
        if (i > 0) ms.push_back(1e3 * (processorTime() - before));  // the first compiles shaders
    }
    return medianOf(ms);
}

Timing measure(const SceneDescription& scene, bool picture) {
    Player player(scene, Overlays{.trails = false});
    const int chunks = std::max(static_cast<int>(std::lround(scene.seconds * kStepsASecond)), 1);
    Timing timing;
    long long done = 0;
    for (int chunk = 1; chunk <= chunks; ++chunk) {
        const long long until = static_cast<long long>(chunk) * scene.hz / kStepsASecond;
        const int count = static_cast<int>(until - done);
        done = until;
        const double before = processorTime();
        player.step(count);
        const double after = processorTime();
        if (chunk <= chunks - kWindow) continue;
        timing.ms.push_back(1e3 * (after - before));
        timing.points += player.stage().world.report().contacts;
        if (interrupted()) throw Stop(Exit::interrupted, "interrupted");
    }
    timing.scene = scene.name;
    timing.bodies = scene.bodies.size();
    timing.joints = scene.joints.size();
    timing.contacts = player.stage().world.report().contacts;
    timing.steps = static_cast<int>(timing.ms.size());
    timing.hash = player.stage().world.hash();
    if (picture) timing.frameMs = pictureTime(player);
    return timing;
}

double nanosecondsAPoint(const Timing& timing) {
    double sum = 0.0;
    for (const double ms : timing.ms) sum += ms;
    return timing.points > 0.0 ? 1e6 * sum / timing.points : 0.0;
}

void sayJson(const Timing& t) {
    const auto [least, most] = std::minmax_element(t.ms.begin(), t.ms.end());
    fmt::print(R"({{"scene":{},"bodies":{},"joints":{},"contacts":{},"steps":{},)"
               R"("ms_per_step_median":{:.6g},"ms_per_step_min":{:.6g},"ms_per_step_max":{:.6g},)"
               R"("ns_per_point":{:.6g},"hash":"{}")",
               jsonString(t.scene), t.bodies, t.joints, t.contacts, t.steps, medianOf(t.ms), *least,
               *most, nanosecondsAPoint(t), hexText(t.hash));
    if (t.frameMs > 0.0) fmt::print(R"(,"ms_per_frame_median":{:.6g})", t.frameMs);
    fmt::print("}}\n");
    std::fflush(stdout);
}

void sayRow(const Timing& t) {
    const auto [least, most] = std::minmax_element(t.ms.begin(), t.ms.end());
    fmt::print("{:18} {:6} {:6} {:8}  {:8.3f} {:8.3f} {:8.3f}  {:8.0f}  {}", t.scene, t.bodies,
               t.joints, t.contacts, medianOf(t.ms), *least, *most, nanosecondsAPoint(t),
               hexText(t.hash));
    if (t.frameMs > 0.0) fmt::print("  {:.1f} ms a frame", t.frameMs);
    fmt::print("\n");
    std::fflush(stdout);
}

}  // namespace

Exit benchCommand(const Options& options) {
    std::vector<std::string> scenes = options.scenes;
    if (scenes.empty())
        for (const BuiltinScene& scene : builtinScenes()) scenes.emplace_back(scene.name);
    watchSignals();
    if (!options.json && !options.quiet)
        fmt::print("{:18} {:>6} {:>6} {:>8}  {:>8} {:>8} {:>8}  {:>8}  {}\n", "scene", "bodies",
                   "joints", "contacts", "ms/step", "least", "most", "ns/point", "state");
    for (const std::string& name : scenes) {
        Options one = options;
        one.scenes = {name};
        const Timing timing = measure(sceneOf(one), options.picture);
        options.json ? sayJson(timing) : sayRow(timing);
    }
    const Talk talk(options, false);
    talk.say(fmt::format("next: impulse bench {} --json", printable(scenes.front())));
    return Exit::ok;
}

}  // namespace demos
