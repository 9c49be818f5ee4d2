/// A scene as plain data: every value checked, in SI units and radians, every default filled in,
/// [[repeat]] unrolled. The reader makes it from a file, the stage builds a world from it.
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
#include "render/formula.h"

namespace render {
enum class Material;
}

namespace demos {

using engine::Quat;
using engine::Vec3;

struct BodyDescription {
    std::string name;
    engine::BodyDef def;            // with the material's values in def.material
    std::optional<unsigned> color;  // 0xRRGGBB
    render::Material look{};        // of its surface
    std::optional<std::vector<engine::ShapePart>> looks;  // drawn instead of def.shape, body axes
    std::optional<KinematicPath> path;
    std::vector<std::string> groups, ignores;  // as bits in def
    Place place, ignoresPlace;
};

/// `def` names bodies by their index in `bodies`; -1: the world, with its anchor in world axes.
struct JointDescription {
    std::string name;  // given, or "a-b" of its bodies
    engine::JointDef def;
    Place place;
};

/// `def` names bodies in the same way.
struct ForceDescription {
    engine::ForceDef def;
    Place place;
};

/// How the camera moves to a key; `cut`: it jumps at the key's time.
enum class Ease { smooth, linear, in, out, cut };

/// The camera at one time; values missing in the file are those of the key before.
struct CameraKey {
    double at = 0.0;  // s
    Vec3 from{8, 5, 14}, lookAt{0, 2, 0};
    double fovDegrees = 35.0;
    Ease ease = Ease::smooth;  // of the motion towards this key
};

/// A slow motion of the camera over the whole film: towards lookAt, around it, or with the bodies.
enum class CameraMove { none, push, orbit, follow };

struct CameraDescription {
    Vec3 from{8, 5, 14}, lookAt{0, 2, 0};
    bool fitsMotion = true;  // neither was given: pictures take them from the motion of the run
    double fovDegrees = 35.0;
    CameraMove move = CameraMove::none;
    double orbitDegreesPerSecond = 0.0;
    std::string follow;           // a body, or empty
    double followLag = 0.0;       // s, time constant of following; 0: no lag
    double aperture = 0.0;        // m, the lens's radius
    double focus = 0.0;           // m along the view axis; 0: at lookAt
    std::string focusBody;        // a body to focus on instead of `focus`, or empty
    std::vector<CameraKey> keys;  // in rising order of time; may be empty
};

struct LookDescription {
    std::string theme = "studio";     // studio | dark | print | transparent
    std::vector<std::string> show;    // overlays
    std::vector<std::string> trails;  // bodies
    std::string colorBy = "body";     // body | speed | impulse | island | group | material | id
    double colorMax = 0.0;            // m/s or N s, upper end of the scale; 0: the largest so far
    double ghostEvery = 0.25;         // s
    double reflection = 0.0;          // 0..1, of the bodies in the floor
    bool dither = false;              // no bands in smooth gradients
    std::optional<Vec3> light;        // towards it, of any length; none: beside the camera
    std::string plot = "energy";      // the chart of the overlay 'plot'
};

/// What a section's slide shows besides the film. The texts are kept as written: the maker of
/// slides checks them and uses the places in its messages.
struct SectionSlide {
    std::string title, text;                      // CommonMark
    std::vector<std::string> formulas;            // LaTeX
    std::vector<std::string> plots;               // of measureNames()
    bool measures = false, expectations = false;  // tables
    Place titlePlace, textPlace, notesPlace;
    std::vector<Place> formulaPlaces;
};

/// A caption with formulas.
struct FormulaCaption {
    std::string line;  // formulas are characters, as in render::Text
    std::vector<render::Formula> formulas;
    std::vector<std::string> markup;  // of each: LaTeX between dollars; empty: it belongs to the one before
};

/// A chapter of the film.
struct Section {
    double at = 0.0;  // s
    std::string name, caption, notes, poster;  // the caption's formulas in ordinary letters
    double slow = 1.0;
    bool pause = false, loop = false;
    SectionSlide slide = {};
    std::string file = {};  // its name in messages
    Place place = {};
    FormulaCaption formulaCaption = {};  // empty: the caption has no formulas
};

inline constexpr int kMostExpectations = 1000;  // of a scene

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
    std::string of = "*";  // pattern of bodies or joints; several: "box*,ball"
    std::optional<double> below, above, near;
    std::optional<Vec3> nearPoint;  // position
    double within = 0.0;
    double after = 0.0;           // s
    std::optional<double> until;  // s; default: the end of the film
    std::string why;
    Place place;
};

/// The deviation from the baseline above which a run's physics counts as changed.
struct Tolerance {
    double position = 1e-4;      // m
    double angleDegrees = 0.01;  // deg
    double load = 0.1;           // of a body's load: the impulses of its contacts and joints
    std::string why;             // the reason for other numbers than these
};

/// The allowed difference of a picture from its baseline: render::Gate.
struct PictureGate {
    int levels = 4;        // of 255
    int windowPixels = 8;  // in any window of 16x16
    double ssim = 0.90;    // of every block of 8x8
    std::string why;       // the reason for other numbers than these
};

struct Snapshot {
    std::vector<double> times;      // s
    int width = 640, height = 360;  // pixels
    Tolerance tolerance;
    PictureGate gate;
};

struct SceneDescription {
    // Defined in description.cpp: inline, every file that has a scene would compile them.
    SceneDescription();
    SceneDescription(const SceneDescription&);
    SceneDescription(SceneDescription&&) noexcept;
    SceneDescription& operator=(const SceneDescription&);
    SceneDescription& operator=(SceneDescription&&) noexcept;
    ~SceneDescription();

    std::string name;  // built-in name or the file's stem
    std::optional<std::filesystem::path> folder;  // of the file; files it names are relative to it
    std::uint64_t contents = 0;  // hash of the points and triangles read from such files
    std::string title;
    std::string purpose;        // what it shows, a line for `impulse list`
    std::string group;          // its heading in that list
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
        notes;  // unsupported features of a foreign model, a line each
    std::vector<std::string> files;  // further files that were read: included, meshes, buffers
};

}  // namespace demos
