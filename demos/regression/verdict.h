/// The results of a test of scenes against their baselines: plain values, shown by the command, the
/// report, JSON and JUnit.
///
/// Three levels, in this order:
///   1  the same state and the same pixels                          nothing to report
///   2  the same state, different pixels: a rendering difference    the gate decides
///   3  a different state: a physics difference, reported as the first step, body, field and
///      constraint that differ, even if no picture shows it; one that stays within the scene's
///      tolerances is a change of bits, and passes
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "demos/film/frame_choice.h"
#include "demos/play/expect.h"
#include "demos/scene/description.h"
#include "render/difference.h"

namespace demos {

/// A setting in which baseline and actual differ; an empty value: that run has no such key.
struct SettingChange {
    std::string key, baseline, actual;
};

/// How two runs of a scene diverge.
struct PhysicsVerdict {
    enum class Kind {
        unknown,  // there is no baseline to compare with
        same,     // bit for bit, in every step
        bits,     // different bits, within the tolerances
        changed   // beyond the tolerances
    };
    Kind kind = Kind::unknown;
    int firstBits = -1;       // first step whose bits differ; -1: none
    int step = -1;            // first recorded step beyond a tolerance; -1: none
    int every = 1;            // number of steps since the recorded step before it
    std::string body, field;  // farthest beyond in that step: "box9", "y", "turn" or "load"
    double difference = 0.0;  // actual - baseline, m; of a turn: deg, of a load: N
    std::string constraint;   // whose impulse differs most in that step; empty: none
    double before = 0.0, after = 0.0;  // N s since the recorded step before, baseline and actual
    double used = 0.0;                 // largest difference of all as a share of its tolerance
    std::vector<std::string> lines;    // the same as text for people, empty if `same`

    bool passes() const { return kind == Kind::same || kind == Kind::bits; }
};

/// One picture of a scene.
struct PictureVerdict {
    enum class Kind {
        same,     // pixel for pixel
        within,   // different pixels, which the gate passes
        changed,  // different pixels, which the gate rejects
        added,    // it has no baseline
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
    std::string name;   // of its baseline, also for `impulse approve`
    std::string scene;  // as given on the command line: a built-in name or a file
    std::string title;
    State state = State::passed;
    bool cached = false;  // nothing has changed since it passed: it was not run
    std::string problem;
    std::string folder;  // of its baseline
    Snapshot snapshot;   // the tolerances and gate used
    std::vector<ExpectationResult> expectations;
    PhysicsVerdict physics;
    std::vector<PictureVerdict> pictures;  // by time
    std::vector<SettingChange> settings;
    std::vector<std::string> orphans;  // pictures that no listed time uses

    /// Whether every expectation passed.
    bool keepsContract() const;
    /// The same bits, the same pixels, and the same scene.
    bool isAsItWas() const;
    /// The settings that differ and belong to the scene, not to the program or the renderer.
    std::vector<SettingChange> changedScene() const;
    /// Whether everything passes except pictures at times that were added to the scene's list.
    bool onlyAddsPictures() const;
};

/// Which part of a test a verdict is of, for `impulse test --merge`.
struct TestPart {
    Shard shard;
    int scenes = 0;                     // of the whole test
    std::uint64_t run = 0;              // hash of all scenes and of the options
    std::string program;                // of one build; empty: not known
    std::vector<std::string> settings;  // KEY=VALUE of the command line
};

struct TestVerdict {
    std::vector<SceneVerdict> scenes;
    std::vector<std::string> orphans;  // folders of baselines without a scene
    std::string baselines;  // the folder given with --baselines; empty: next to each scene
    std::string renderer, pixels, command;  // as in run.json
    std::optional<TestPart> part;           // nothing: of the whole test

    /// Number of scenes in this state.
    int count(SceneVerdict::State state) const;
    bool passed() const;
};

/// "passed", "failed", ...; "same", "within", ...; "unknown", "same", "bits", "changed"
const char* nameOf(SceneVerdict::State state);
const char* nameOf(PictureVerdict::Kind kind);
const char* nameOf(PhysicsVerdict::Kind kind);

/// The name that `impulse approve` takes: "stack@2.5", with the time as short as possible.
std::string pictureName(const std::string& scene, double time);

}  // namespace demos
