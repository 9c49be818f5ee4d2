/// What a test of scenes against their baselines finds: plain values, told by the command, the
/// report, JSON and JUnit.
///
/// Three levels, in this order:
///   1  the same state and the same pixels                          nothing to say
///   2  the same state, other pixels: a difference of rendering     the gate decides
///   3  another state: a difference of physics, told as the first step, body, field and constraint
///      that differ, whatever the pictures hide; one that stays within the scene's tolerances is a
///      change of bits, and passes
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "demos/play/expect.h"
#include "demos/scene/description.h"
#include "render/difference.h"

namespace demos {

/// What a run was made with, where baseline and actual differ; empty: one of them has no such key.
struct SettingChange {
    std::string key, baseline, actual;
};

/// How two runs of a scene part.
struct PhysicsVerdict {
    enum class Kind {
        unknown,  // there is no baseline to compare with
        same,     // bit for bit, in every step
        bits,     // other bits, within the tolerances
        changed   // beyond them
    };
    Kind kind = Kind::unknown;
    int firstBits = -1;         // step that is the first to differ in its bits; -1: none
    int step = -1;              // first recorded step beyond a tolerance; -1: none
    int every = 1;              // steps from the recorded one before to that one
    std::string body, field;    // of that step, the farthest beyond: "box9", "y" or "turn"
    double difference = 0.0;    // actual - baseline, m; of a turn: deg
    std::string constraint;     // whose impulse differs most in or before that step; empty: none
    double before = 0.0, after = 0.0;  // N s along its normal in one step, baseline and actual
    double used = 0.0;          // largest difference of all in parts of its tolerance
    std::vector<std::string> lines;  // the same for people, nothing where `same`

    bool passes() const { return kind == Kind::same || kind == Kind::bits; }
};

/// One picture of a scene.
struct PictureVerdict {
    enum class Kind {
        same,     // pixel for pixel
        within,   // other pixels, and the gate lets them pass
        changed,  // the gate does not
        added,    // there is no baseline of it
        broken    // the baseline cannot be used: `problem` says why
    };
    double time = 0.0;  // s, as [snapshot] lists it
    Kind kind = Kind::added;
    std::uint64_t baselineState = 0, state = 0;  // hashes of the world; 0: none
    render::Difference difference;               // of the two pictures, where there are two
    std::string problem;
    std::string baseline, actual;  // files; empty: none

    bool passes() const { return kind == Kind::same || kind == Kind::within; }
};

/// Everything about one scene.
struct SceneVerdict {
    enum class State {
        passed,
        failed,   // an expectation, the physics or a picture
        added,    // there was no baseline, and one was written
        updated,  // the baseline was replaced
        error     // the scene could not be tested: `problem` says why
    };
    std::string name;       // under which its baseline is kept and approved
    std::string scene;      // as it was asked for: a built-in name or a file
    std::string title;
    State state = State::passed;
    bool cached = false;    // nothing has changed since it passed: it was not played
    std::string problem;
    std::string folder;     // of its baseline
    Snapshot snapshot;      // tolerances and gate, as they were used
    std::vector<ExpectationResult> expectations;
    PhysicsVerdict physics;
    std::vector<PictureVerdict> pictures;  // by time
    std::vector<SettingChange> settings;
    std::vector<std::string> orphans;  // pictures that no listed time asks for

    /// Whether every expectation passed.
    bool keepsContract() const;
    /// The same bits and the same pixels.
    bool isAsItWas() const;
    /// Whether all but pictures of times that were added to the scene's list passes.
    bool onlyAddsPictures() const;
};

struct TestVerdict {
    std::vector<SceneVerdict> scenes;
    std::vector<std::string> orphans;  // folders of baselines without a scene
    std::string baselines;  // the folder given with --baselines; empty: beside each scene
    std::string renderer, pixels, command;  // as in run.json

    /// Of the scenes in this state.
    int count(SceneVerdict::State state) const;
    bool passed() const;
};

/// "passed", "failed", ...; "same", "within", ...; "unknown", "same", "bits", "changed"
const char* nameOf(SceneVerdict::State state);
const char* nameOf(PictureVerdict::Kind kind);
const char* nameOf(PhysicsVerdict::Kind kind);

/// What `impulse approve` is told to accept it: "stack@2.5", times as short as they can be.
std::string pictureName(const std::string& scene, double time);

}  // namespace demos
