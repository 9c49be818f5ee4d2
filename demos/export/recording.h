/// A run as plain values, sampled at the frames of its film and once more at its end: what
/// replay.html shows.
#pragma once
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/report/measures.h"
#include "demos/snapshot/solids.h"
#include "render/frame.h"

namespace demos {

/// What a body looks like as long as it is there.
struct RecordedBody {
    std::string name;
    render::Color color;           // translucent: a sensor
    std::vector<DrawnPart> parts;  // none: a plane, which is in Recording::grounds
    double mass = 0.0;             // kg; 0: not dynamic
};

/// A straight bar or a coil that a joint or a spring is drawn as. Bodies hold its ends.
struct RecordedBar {
    int a = -1, b = -1;               // places in Recording::bodies; -1: the world
    Vec3 atA{0, 0, 0}, atB{0, 0, 0};  // m, in a's and in b's body axes
    double radius = 0.0;              // m, of a bar
    double rest = -1.0;               // m, length of a coil at rest; negative: a bar
    int joint = -1;                   // place in Recording::joints; -1: a spring that stays
};

/// A joint's two anchors.
struct RecordedJoint {
    std::string name;
    int a = -1, b = -1;               // as a bar's
    Vec3 atA{0, 0, 0}, atB{0, 0, 0};  // m
    int frames = 0;                   // that it is there for; later it is removed or broken
};

struct RecordedContact {
    Vec3 position, normal;  // m; unit, from the first body to the second
    double impulse = 0.0;   // N s along the normal, in the last step
    Vec3 friction;          // N s on the second, likewise
};

struct RecordedFrame {
    std::vector<engine::Pose> poses;        // by body
    std::vector<double> speeds;             // m/s, by body
    std::vector<RecordedContact> contacts;  // that the last step solved; none at time 0
    Measures measures;
    render::Camera camera;
    int shot = 0;              // frames of the same number have no cut between them
    double impulsePeak = 0.0;  // N s: History::impulsePeak
};

struct Recording {
    std::string name, title;
    double framesASecond = 30.0;
    double seconds = 0.0;     // of the film, whatever was left out
    double viewHeight = 1.0;  // m, that the camera sees where it looks
    double thinnest = 0.0;    // m: half of the thinnest body that moves
    std::vector<RecordedBody> bodies;
    std::vector<render::Ground> grounds;
    std::vector<RecordedBar> bars;
    std::vector<RecordedJoint> joints;
    std::vector<int> trails;  // places of bodies
    std::vector<Section> sections;
    Overlays overlays;
    std::vector<RecordedFrame> frames;
    std::string trouble;  // why it ends early: the line of a run that diverged; empty: it does not
};

/// Plays the plan's first panel. Throws Stop where the simulation diverges.
Recording recordingOf(const FilmPlan& plan);

}  // namespace demos
