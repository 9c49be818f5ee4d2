/// A run as plain values, sampled at the frames of its film and once more at its end: the source of
/// every file of `impulse export`.
#pragma once
#include <string>
#include <vector>

#include "demos/film/event_log.h"
#include "demos/film/film_plan.h"
#include "demos/measures/measures.h"
#include "demos/play/solids.h"
#include "demos/snapshot/joint_bars.h"
#include "demos/snapshot/player.h"
#include "render/frame.h"

namespace demos {

/// A body's properties that do not change.
struct RecordedBody {
    std::string name;
    render::Color color;  // as drawn at time 0; translucent: a sensor or glass
    render::Material look{};
    std::vector<DrawnPart> parts;  // empty: a plane, which is also in Recording::grounds
    Vec3 plane{0, 0, 0};           // unit, in its axes: a plane's normal
    double mass = 0.0;             // kg; 0: not dynamic
};

/// A joint's two anchors.
struct RecordedJoint {
    std::string name;
    int a = -1, b = -1;               // indices of bodies; -1: the world
    Vec3 atA{0, 0, 0}, atB{0, 0, 0};  // m, in a's and in b's body axes
    int frames = 0;                   // for which it exists; later it is removed or broken
};

/// A body's state at one time.
struct BodyMotion {
    engine::Pose pose;             // m
    Vec3 velocity = Vec3::Zero();  // m/s
    Vec3 spin = Vec3::Zero();      // rad/s, world axes
};
BodyMotion motionOf(const Stage& stage, std::size_t body);

struct RecordedFrame {
    double time = 0.0;                           // s
    std::vector<BodyMotion> bodies;              // by index in Recording::bodies
    std::vector<engine::ContactState> contacts;  // of the step that ends here; none at time 0
    std::vector<JointBar> bars;                  // of the joints that exist, as they are here
    Measures measures;
    render::Camera camera;
    int shot = 0;              // frames of the same number have no cut between them
    double impulsePeak = 0.0;  // N s: History::impulsePeak
};

struct Recording {
    std::string name, title;
    double framesASecond = 30.0;
    double seconds = 0.0;        // of the film, even if frames are left out
    double aspect = 16.0 / 9.0;  // of the film: width over height
    double viewHeight = 1.0;     // m, of the view where the camera looks
    double thinnest = 0.0;       // m: half the thickness of the thinnest dynamic body
    std::vector<RecordedBody> bodies;
    std::vector<render::Ground> grounds;
    render::Look look;           // of the scene's theme
    std::vector<JointBar> bars;  // of all joints; a slider's rail is as long as its way
    std::vector<RecordedJoint> joints;
    std::vector<int> trails;  // indices of bodies
    std::vector<Section> sections;
    Overlays overlays;
    std::vector<RecordedFrame> frames;
    StageEvents events;  // of all steps
};

/// Refuses a run of more poses than an export holds. `instead`: how to do without it, "": not at
/// all. Throws Stop (usage).
void checkLength(const FilmPlan& plan, const std::string& instead = "");

/// Must see a player before its first step and after every step.
class RunRecorder {
public:
    /// `plan`: the player simulates its first panel.
    explicit RunRecorder(const FilmPlan& plan);
    void look(const Player& player, long step);
    /// The recording; it has events of contacts if the stage's world watches touches.
    const Recording& finished(const Stage& stage);

private:
    void begin(const Player& player);
    void addBodies(const Player& player);
    void addFrame(const Player& player, long step);

    int stepsPerFrame_;
    EventLog events_;
    std::vector<SlideRange> slides_;  // by joint, in the frames so far
    Recording recording_;
};

/// Simulates the plan's first panel to its end. Its cameras must be fitted (fitCameras). Throws
/// Stop (diverged) if a step fails.
Recording recordingOf(const FilmPlan& plan);

}  // namespace demos
