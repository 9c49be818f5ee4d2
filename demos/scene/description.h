/// A scene file as plain data: every value checked, in SI units and radians, every default filled
/// in, [[repeat]] unrolled. See shared format 1; the reader makes it, the stage plays it.
#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "demos/scene/kinematic_path.h"
#include "demos/text/place.h"
#include "engine/body.h"
#include "engine/force.h"
#include "engine/joint.h"
#include "engine/settings.h"

namespace demos {

using engine::Quat;
using engine::Vec3;

struct BodyDescription {
    std::string name;
    engine::BodyDef def;            // material values are already in def.material
    std::optional<unsigned> color;  // 0xRRGGBB
    std::optional<std::vector<engine::ShapePart>> looks;  // drawn in place of def.shape, body axes
    std::optional<KinematicPath> path;
    std::vector<std::string> groups, ignores;  // numbered in def
    Place place, ignoresPlace;
};

/// The bodies of `def` by their place in `bodies`; -1: the world, its anchor in world axes.
struct JointDescription {
    std::string name;  // given, or "a-b" of its bodies
    engine::JointDef def;
    Place place;
};

/// The bodies of `def` likewise.
struct ForceDescription {
    engine::ForceDef def;
    Place place;
};

/// How the camera moves to a key; `cut`: not at all until the key's time.
enum class Ease { smooth, linear, in, out, cut };

/// Where the camera is at a time; what the file leaves out is as in the key before.
struct CameraKey {
    double at = 0.0;  // s
    Vec3 from{8, 5, 14}, lookAt{0, 2, 0};
    double fovDegrees = 35.0;
    Ease ease = Ease::smooth;  // of the way to here
};

struct CameraDescription {
    Vec3 from{8, 5, 14}, lookAt{0, 2, 0};
    double fovDegrees = 35.0;
    double orbitDegreesPerSecond = 0.0;
    std::string follow;           // a body, or empty
    double followLag = 0.0;       // s, the time constant with which it comes after; 0: glued
    double aperture = 0.0;        // m, the lens's radius
    double focus = 0.0;           // m along the view axis; 0: at lookAt
    std::string focusBody;        // in place of `focus`: a body, or empty
    std::vector<CameraKey> keys;  // later and later; none: the camera stays
};

struct LookDescription {
    std::string theme = "studio";     // studio | dark | print | transparent
    std::vector<std::string> show;    // overlays
    std::vector<std::string> trails;  // bodies
    std::string colorBy = "body";     // body | speed | impulse | island | group | material | id
    double colorMax = 0.0;            // m/s or N s, the scale's end; 0: the largest so far
    double ghostEvery = 0.25;         // s
    std::string plot = "energy";      // of the overlay 'plot': a chart's name
};

/// What a section's slide shows besides the film. Kept as it is written: who makes slides of it
/// checks it, and says where it stands.
struct SectionSlide {
    std::string title, text;                      // CommonMark
    std::vector<std::string> formulas;            // LaTeX
    std::vector<std::string> plots;               // of measureNames()
    bool measures = false, expectations = false;  // tables
    Place titlePlace, textPlace, notesPlace;
    std::vector<Place> formulaPlaces;
};

/// A chapter of the film.
struct Section {
    double at = 0.0;  // s
    std::string name, caption, notes, poster;
    double slow = 1.0;
    bool pause = false, loop = false;
    SectionSlide slide = {};
    std::string file = {};  // as complaints call it
    Place place = {};
};

/// A line of the scene's physics contract.
struct Expectation {
    enum class What {
        drift,
        penetration,
        separation,
        energy,
        speed,
        position,
        angle,
        period,
        count,
        height,
        spread
    };
    What what = What::drift;
    std::string of = "*";  // bodies or joints, with *; several: "box*,ball"
    std::optional<double> below, above, near;
    std::optional<Vec3> nearPoint;  // position
    double within = 0.0;
    double after = 0.0;           // s
    std::optional<double> until;  // s; else the end of the film
    std::string why;
    Place place;
};

/// How far a run may be from its baseline before its physics counts as changed.
struct Tolerance {
    double position = 1e-4;      // m
    double angleDegrees = 0.01;  // deg
    std::string why;             // of other numbers than these
};

/// How far a picture may be from its baseline: render::Gate.
struct PictureGate {
    int levels = 4;        // of 255
    int windowPixels = 8;  // in any window of 16x16
    double ssim = 0.90;    // of every block of 8x8
    std::string why;       // of other numbers than these
};

struct Snapshot {
    std::vector<double> times;      // s
    int width = 640, height = 360;  // pixels
    Tolerance tolerance;
    PictureGate gate;
};

struct SceneDescription {
    std::string name;  // built-in name or the file's stem
    std::optional<std::filesystem::path> folder;  // of the file: for those it names
    std::uint64_t contents = 0;  // hash of the points and triangles that came from such files
    std::string title;
    std::string purpose;        // what it shows, a line for `impulse list`
    std::string group;          // under which it is listed
    double seconds = 5.0;       // length of the film
    Vec3 gravity{0, -9.81, 0};  // m/s^2
    int hz = 60;                // physics steps a second
    std::uint64_t seed = 1;
    std::string preset = "steady";
    engine::Settings settings;
    std::vector<BodyDescription> bodies;
    std::vector<JointDescription> joints;
    std::vector<ForceDescription> forces;
    CameraDescription camera;
    LookDescription look;
    std::vector<Section> sections;
    std::vector<Expectation> expectations;
    Snapshot snapshot;
    std::vector<std::string>
        notes;  // what of a model of other making is not supported, a line each
    std::vector<std::string> files;  // that were read besides the scene's own: included, meshes, buffers
};

}  // namespace demos
