#include "demos/regression/mutants.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "demos/film/framing.h"
#include "demos/regression/divergence.h"
#include "demos/regression/judge.h"
#include "demos/regression/trajectory_recorder.h"
#include "demos/snapshot/player.h"
#include "render/surface_map.h"

namespace demos {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr float kSunTurn = static_cast<float>(5.0 * kDegree);
constexpr float kColorShift = 0.05f;  // of 1: 13 levels of a body's own colour
// Changes a value by at most 5 levels: not visible in a single picture. A real mistake, such as a
// second sRGB curve, changes ten times as much.
constexpr double kGamma = 1.05;
constexpr double kMoon = 1.62 / 9.81;

template <class Change>
void changeBody(const Specimen& specimen, render::Frame& frame, Change change) {
    for (render::Solid& solid : frame.solids)
        if (solid.id == specimen.body) change(solid);
}

/// Moves only the body: its joints and contacts stay where they are.
Sight moved(const Specimen& specimen, double distance) {
    Sight sight = specimen.now;
    if (specimen.body < 0) return sight;
    const Vec3 way = distance * specimen.across;
    sight.poses[static_cast<std::size_t>(specimen.body)].position += way;
    changeBody(specimen, sight.frame,
               [&way](render::Solid& solid) { solid.position += way.cast<float>(); });
    return sight;
}

Sight movedLittle(const Specimen& specimen) { return moved(specimen, 0.001); }
Sight movedMore(const Specimen& specimen) { return moved(specimen, 0.01); }

Sight hidden(const Specimen& specimen) {
    Sight sight = specimen.now;
    std::erase_if(sight.frame.solids,
                  [&](const render::Solid& solid) { return solid.id == specimen.body; });
    return sight;
}

/// A wrong colour: red gains what blue loses, which an SSIM of luma hardly notices.
Sight recolored(const Specimen& specimen) {
    Sight sight = specimen.now;
    changeBody(specimen, sight.frame, [](render::Solid& solid) {
        solid.color.r = std::min(solid.color.r + kColorShift, 1.0f);
        solid.color.b = std::max(solid.color.b - kColorShift, 0.0f);
    });
    return sight;
}

/// Turns the sun about an axis perpendicular to its rays, so that the whole angle counts.
Sight otherLight(const Specimen& specimen) {
    Sight sight = specimen.now;
    render::Vec3& sun = sight.frame.look.sunDirection;
    sun = Eigen::AngleAxisf(kSunTurn, sun.unitOrthogonal()) * sun;
    return sight;
}

Sight withoutShadow(const Specimen& specimen) {
    Sight sight = specimen.now;
    sight.frame.look.shadows = false;
    return sight;
}

Sight late(const Specimen& specimen) { return specimen.late; }

Sight brighter(const Specimen& specimen) {
    Sight sight = specimen.now;
    sight.gamma = kGamma;
    return sight;
}

void doubleMasses(const Stage& stage, SceneDescription& scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (stage.world.mass(stage.bodies[i]) == 0.0) continue;
        const engine::BodyDef& def = stage.world.def(stage.bodies[i]);
        scene.bodies[i].def.mass = 2.0 * *def.mass;
        scene.bodies[i].def.inertia = 2.0 * *def.inertia;
    }
}

void useMoonGravity(const Stage&, SceneDescription& scene) { scene.gravity *= kMoon; }

constexpr Mutant kMutants[] = {
    {"1 mm", "the moving body that covers most of the picture is 1 mm to the right", movedLittle},
    {"1 cm", "the same body is 1 cm to the right", movedMore},
    {"hidden", "the same body is not drawn", hidden},
    {"color", "the same body has 5 % more red and 5 % less blue", recolored},
    {"light", "the sun has moved by 5 degrees", otherLight},
    {"no shadow", "the sun casts no shadows", withoutShadow},
    {"late", "the world is one step ahead", late},
    {"gamma", "the whole picture is brighter by a gamma of 1.05", brighter},
    {"mass x2", "every body has twice its mass", nullptr, doubleMasses},
    {"gravity", "gravity is that of the Moon, 0.165 of the Earth's", nullptr, useMoonGravity},
};

Sight sightOf(const Player& player, const FilmPlan& plan, double time) {
    Sight sight{player.frame(time), {}};
    fitCamera(plan.picture.width, plan.picture.height, sight.frame);
    for (const engine::BodyId body : player.stage().bodies)
        sight.poses.push_back(player.stage().world.pose(body));
    return sight;
}

/// A scene that is simulated and recorded.
class RecordedPlayer {
public:
    RecordedPlayer(const SceneDescription& scene, const FilmPlan& plan)
        : player(scene, plan.panels.front().overlays),
          recorder_(player.stage(), static_cast<int>(std::lround(scene.seconds * scene.hz))) {
        recorder_.look(player.stage());
    }

    void playTo(int step) {
        for (; step_ < step; ++step_) {
            player.step();
            recorder_.look(player.stage());
        }
    }
    int step() const { return step_; }
    const Trajectory& trajectory() const { return recorder_.trajectory(); }

    Player player;

private:
    TrajectoryRecorder recorder_;
    int step_ = 0;
};

/// The run of a scene that a mutant has changed.
struct ChangedRun {
    const Mutant* mutant;
    std::unique_ptr<RecordedPlayer> run;
};

std::vector<ChangedRun> changedRuns(const Stage& stage, const FilmPlan& plan) {
    std::vector<ChangedRun> runs;
    for (const Mutant& mutant : mutants()) {
        if (!mutant.changed) continue;
        SceneDescription scene = plan.scene();
        mutant.changed(stage, scene);
        runs.push_back({&mutant, std::make_unique<RecordedPlayer>(scene, plan)});
    }
    return runs;
}

/// Advances the player by one step. The late sight keeps the camera and the texts: only the world
/// has advanced.
Specimen specimenAt(double time, const FilmPlan& plan, RecordedPlayer& truth,
                    render::Renderer& renderer) {
    const Player& player = truth.player;
    Specimen specimen;
    specimen.now = sightOf(player, plan, time);
    const render::Frame& frame = specimen.now.frame;
    specimen.body = mostSeenBody(player.stage(), frame, renderer.surfaces(frame));
    const render::Camera& camera = frame.camera;
    specimen.across = (camera.lookAt - camera.from).cross(camera.up).normalized().cast<double>();
    truth.playTo(truth.step() + 1);
    specimen.late = sightOf(player, plan, time);
    return specimen;
}

render::Image drawn(const Sight& sight, render::Renderer& renderer) {
    render::Image image = renderer.draw(sight.frame);
    if (sight.gamma == 1.0) return image;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (i % 4 != 3)  // not alpha
            image.pixels[i] = static_cast<std::uint8_t>(
                std::lround(255.0 * std::pow(image.pixels[i] / 255.0, 1.0 / sight.gamma)));
    return image;
}

/// A run of a single moment, so that a mutant is compared as tests compare runs.
Trajectory trajectoryOf(const Sight& sight, const SceneDescription& scene, std::uint32_t hash) {
    Trajectory trajectory;
    trajectory.hz = scene.hz;
    for (const BodyDescription& body : scene.bodies) trajectory.bodies.push_back(body.name);
    trajectory.hashes = {hash};
    trajectory.moments.resize(1);
    trajectory.moments.front().poses = sight.poses;
    return trajectory;
}

/// The share of a tolerance that the poses use.
double used(const Sight& truth, const Sight& sight, const SceneDescription& scene, const Tolerance& tolerance) {
    return diverge(trajectoryOf(truth, scene, 0), trajectoryOf(sight, scene, 1), tolerance).used;
}

/// A body at rest trembles by less than a thousandth of the usual tolerance.
bool samePoses(const Sight& truth, const Sight& sight, const SceneDescription& scene) {
    return used(truth, sight, scene, {}) < 1e-3;
}

/// But for rounding.
bool looksSame(const render::Difference& difference) { return difference.largest <= 1; }

MutantVerdict judged(const Mutant& mutant, const Specimen& specimen, const render::Image& truth,
                     const SceneDescription& scene, render::Renderer& renderer) {
    const PictureGate& gate = scene.snapshot.gate;
    const Sight sight = mutant.damaged(specimen);
    MutantVerdict verdict;
    verdict.mutant = &mutant;
    verdict.difference = render::compare(truth, drawn(sight, renderer), gate.levels);
    verdict.unchanged = samePoses(specimen.now, sight, scene) && looksSame(verdict.difference);
    verdict.state = used(specimen.now, sight, scene, scene.snapshot.tolerance) > 1.0;
    verdict.picture = !letsPass(gate, verdict.difference);
    return verdict;
}

bool sameImpulses(const Trajectory& a, const Trajectory& b) {
    const std::size_t moments = std::min(a.moments.size(), b.moments.size());
    for (std::size_t k = 0; k < moments; ++k)
        if (!std::ranges::equal(a.moments[k].impulses, b.moments[k].impulses,
                                [](const TrajectoryImpulse& x, const TrajectoryImpulse& y) {
                                    return x.constraint == y.constraint && x.value == y.value;
                                }))
            return false;
    return true;
}

/// Compares the runs until now. `truth` is one step ahead.
MutantVerdict judged(const ChangedRun& changed, const RecordedPlayer& truth,
                     const Specimen& specimen, const render::Image& image, double time,
                     const FilmPlan& plan, render::Renderer& renderer) {
    const Snapshot& snapshot = plan.scene().snapshot;
    const Sight sight = sightOf(changed.run->player, plan, time);
    const Trajectory& was = truth.trajectory();
    const Trajectory& is = changed.run->trajectory();
    MutantVerdict verdict;
    verdict.mutant = changed.mutant;
    verdict.difference = render::compare(image, drawn(sight, renderer), snapshot.gate.levels);
    verdict.unchanged = samePoses(specimen.now, sight, plan.scene()) && sameImpulses(was, is) &&
                        looksSame(verdict.difference);
    verdict.state = diverge(was, is, snapshot.tolerance).kind == PhysicsVerdict::Kind::changed;
    verdict.picture = !letsPass(snapshot.gate, verdict.difference);
    return verdict;
}

}  // namespace

std::span<const Mutant> mutants() { return kMutants; }

int mostSeenBody(const Stage& stage, const render::Frame& frame, const render::SurfaceMap& map) {
    std::vector<long> pixels(stage.bodies.size(), 0);
    for (const std::int32_t packed : map.packed) {
        const int surface = render::surfaceIn(packed);
        if (surface < 0 || surface >= static_cast<int>(frame.solids.size())) continue;
        ++pixels[static_cast<std::size_t>(frame.solids[surface].id)];
    }
    int most = -1;
    for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
        const bool moves = stage.world.def(stage.bodies[i]).kind != engine::BodyKind::fixed;
        if (moves && (most < 0 || pixels[i] > pixels[most])) most = i;
    }
    return most;
}

std::vector<MutantVerdict> selfTest(const FilmPlan& plan, render::Renderer& renderer) {
    RecordedPlayer player(plan.scene(), plan);
    const std::vector<ChangedRun> changed = changedRuns(player.player.stage(), plan);
    std::vector<MutantVerdict> verdicts;
    std::size_t timed = 0;
    for (const double time : plan.scene().snapshot.times) {
        const int steps = static_cast<int>(std::lround(time * plan.scene().hz));
        if (steps < player.step()) continue;  // two times round to the same step
        player.playTo(steps);
        const Specimen specimen = specimenAt(time, plan, player, renderer);
        const render::Image truth = renderer.draw(specimen.now.frame);
        for (const Mutant& mutant : mutants())
            if (mutant.damaged)
                verdicts.push_back(judged(mutant, specimen, truth, plan.scene(), renderer));
        for (const ChangedRun& run : changed) {
            run.run->playTo(steps);
            verdicts.push_back(judged(run, player, specimen, truth, time, plan, renderer));
        }
        for (; timed < verdicts.size(); ++timed) verdicts[timed].time = time;
    }
    return verdicts;
}

std::vector<MutantSummary> summaries(const std::vector<MutantVerdict>& verdicts) {
    std::vector<MutantSummary> all;
    for (const Mutant& mutant : mutants()) {
        MutantSummary& summary = all.emplace_back();
        summary.mutant = &mutant;
        for (const MutantVerdict& verdict : verdicts) {
            if (verdict.mutant != &mutant) continue;
            ++summary.times;
            summary.state += verdict.state;
            summary.picture += verdict.picture;
            summary.unchanged = summary.unchanged && verdict.unchanged;
            summary.window = std::max(summary.window, verdict.difference.worstWindow);
            summary.ssim = std::min(summary.ssim, verdict.difference.worstSsim);
        }
    }
    return all;
}

}  // namespace demos
