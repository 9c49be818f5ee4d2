/// Deliberate damage, which shows whether a scene's tolerances and gate would notice it before a
/// real defect does.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "demos/film/film_plan.h"
#include "demos/play/stage.h"
#include "render/difference.h"
#include "render/renderer.h"

namespace demos {

/// A scene at one time: what is drawn, and where its bodies are.
struct Sight {
    render::Frame frame;
    std::vector<engine::Pose> poses;  // by index in the scene
    double gamma = 1.0;               // every value v of the picture, 0..1, becomes v^(1 / gamma)
};

/// What mutants are made from.
struct Specimen {
    Sight now, late;  // late: one step ahead, shown as if at the same time
    int body = -1;    // index of the moving body that covers most of the picture; -1: none moves
    Vec3 across{0, 0, 0};  // unit vector to the right of the picture
};

struct Mutant {
    const char* name;
    const char* what;  // what it changes
    Sight (*damaged)(const Specimen& specimen);  // a picture; null: what is simulated
    void (*changed)(const Stage& stage, SceneDescription& scene) = nullptr;  // `stage`: unchanged
};

/// In the order in which they are tried.
std::span<const Mutant> mutants();

/// One mutant at one time.
struct MutantVerdict {
    const Mutant* mutant = nullptr;
    double time = 0.0;              // s, as [snapshot] lists it
    bool unchanged = false;         // the same loads, pixels and poses but for rounding: nothing to notice
    bool state = false;             // a body or its load is beyond the scene's tolerance
    bool picture = false;           // the scene's gate rejects the picture
    render::Difference difference;  // from the undamaged picture

    bool caught() const { return state || picture; }
};

/// The results of one mutant of a scene at all times.
struct MutantSummary {
    const Mutant* mutant = nullptr;
    int times = 0, state = 0,
        picture = 0;        // number of times, and at how many of them each level noticed it
    bool unchanged = true;  // at all of them
    int window = 0;         // pixels, the largest
    double ssim = 1.0;      // the lowest

    bool caught() const { return state + picture > 0; }
    bool missed() const { return !caught() && !unchanged; }
};

/// Index in the scene of the moving body with the most pixels; if none is visible, of the first
/// that moves; -1 if none moves. `map`: of `frame`.
int mostSeenBody(const Stage& stage, const render::Frame& frame, const render::SurfaceMap& map);

/// Tries every mutant at every time that the plan's scene lists, by time. Throws what Player and
/// Renderer throw.
std::vector<MutantVerdict> selfTest(const FilmPlan& plan, render::Renderer& renderer);

/// In the order of mutants().
std::vector<MutantSummary> summaries(const std::vector<MutantVerdict>& verdicts);

}  // namespace demos
