/// A run as plain values, sampled at the frames of its film and once more at its end: what every
/// file of `impulse export` is made of.
#pragma once
#include <vector>

#include "demos/film/event_log.h"
#include "demos/player.h"

namespace demos {

/// How a body is and goes on at one time.
struct BodyMotion {
    engine::Pose pose;             // m
    Vec3 velocity = Vec3::Zero();  // m/s
    Vec3 spin = Vec3::Zero();      // rad/s, world axes
};
BodyMotion motionOf(const Stage& stage, std::size_t body);

struct TrajectoryFrame {
    double time = 0.0;                           // s
    std::vector<BodyMotion> bodies;              // by place in scene.bodies
    engine::Energy energy;                       // J
    std::vector<engine::ContactState> contacts;  // of the step that ends here; none at time 0
    render::Camera camera;
    std::vector<render::Rod> bars;  // of joints, numbered as in pictures
};

struct Trajectory {
    std::vector<TrajectoryFrame> frames;
    std::vector<render::Color> colors;  // by body, as drawn at time 0; sensors are see-through
    render::Look look;                  // of the scene's theme
    StageEvents events;                 // of all steps
};

/// Has to see a player before its first step and after every one.
class TrajectoryRecorder {
public:
    TrajectoryRecorder(int stepsPerFrame, Overlays overlays)
        : stepsPerFrame_(stepsPerFrame), overlays_(std::move(overlays)) {}
    void look(const Player& player, long step);
    /// What it has seen; contacts begin and end in it where the stage's world watches touches.
    const Trajectory& finished();

private:
    void begin(const Player& player);
    void addFrame(const Player& player, long step);

    int stepsPerFrame_;
    Overlays overlays_;
    EventLog events_{0};
    Trajectory trajectory_;
};

}  // namespace demos
