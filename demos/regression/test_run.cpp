#include "demos/regression/test_run.h"

#include <cmath>
#include <memory>

#include "demos/film/exposure.h"
#include "demos/regression/trajectory_recorder.h"
#include "render/renderer.h"

namespace demos {
namespace {

/// The renderer is created for the first picture: many scenes of users have none.
class Camera {
public:
    explicit Camera(const FilmPlan& plan) : plan_(plan) {}

    void shoot(double time, Player& player, TestRun& played) {
        if (!renderer_) renderer_ = std::make_unique<render::Renderer>(plan_.picture);
        played.renderer = renderer_->describe();
        const std::uint64_t state = player.stage().world.hash();
        played.pictures.push_back(
            {time, state, exposed(playTo(time, 0, plan_, player), time, plan_, *renderer_)});
    }

private:
    const FilmPlan& plan_;
    std::unique_ptr<render::Renderer> renderer_;
};

}  // namespace

TestRun runForTest(const FilmPlan& plan) {
    const SceneDescription& scene = plan.scene();
    const int steps = static_cast<int>(std::max(std::lround(scene.seconds * scene.hz), 1L));
    Player player(scene, plan.panels.front().overlays);
    TrajectoryRecorder recorder(player.stage(), steps);
    ExpectationChecker checker(player.stage());
    Camera camera(plan);
    TestRun played;
    std::size_t due = 0;
    for (int step = 0; step <= steps; ++step) {
        if (step > 0) player.step();
        recorder.look(player.stage());
        checker.look(player.stage());
        for (; due < scene.snapshot.times.size() &&
               std::lround(scene.snapshot.times[due] * scene.hz) <= step;
             ++due)
            camera.shoot(scene.snapshot.times[due], player, played);
    }
    played.trajectory = recorder.trajectory();
    played.expectations = checker.results();
    played.incidents = player.incidents();
    return played;
}

}  // namespace demos
