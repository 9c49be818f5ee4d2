/// All switches of the solver: each method can be turned off to see its effect. `demos/scene` reads the same
/// names from a scene's [solver] table.
#pragma once

namespace engine {

/// How the constraints of a step are solved. All methods take the same rows and give the same kind of
/// impulses, so the method may be changed between two steps.
///   impulses   sequential impulses: one constraint after the other, velocities at once (the default)
///   pgs        projected Gauss-Seidel on forces, a = B lambda updated incrementally (Catto 2005)
///   pgsMatrix  the same with an explicit A = J M^-1 J^T: what the first seed argues against
///   direct     exact, by factoring A, with an active set for contacts; small scenes only
enum class Method { impulses, pgs, pgsMatrix, direct };

/// gravity: contacts from the top down, so that one sweep carries weight to the floor. pairs: in the order of
/// body numbers.
enum class Order { gravity, pairs };

/// direct: trees of joints are solved exactly, one tree at a time. rows: like any other constraint.
enum class JointSolving { direct, rows };

/// How the spin of a free body is integrated (dynamics/rotation.h).
enum class Gyroscope { momentum, implicitEuler, none };

/// Which velocity a bounce is based on. impacts: a separate pass before the sweeps, one pair after the other,
/// so that an impact travels through a row of balls. bias: b = e (J v1), computed once before solving
/// (Eberly's formula).
enum class Bounce { impacts, bias };

/// How soft rows and springs of joints swing (constraints/soft.h).
enum class Springs { symplectic, implicit };

/// The instruction set of the wide contact solver; the bits are the same.
enum class Instructions { best, baseline };

/// The settings of a World, which may be changed between two steps. Invalid values stop the program: not 1 to
/// 10000 sub-steps or 1 to 256 threads, values that are negative or not finite, Baumgarte together with nudges.
struct Settings {
    Method method = Method::impulses;
    int substeps = 4;         // repetitions of velocities, impulses, positions and nudges per step
    int maxSubsteps = 128;    // limit of substeps where joints or masses need more (solver/substeps.h)
    int sweeps = 20;          // velocity sweeps per sub-step, at most; four times as many where bodies would sink
                              // into each other by a tenth of their thickness in a step
    int minSweeps = 2;        // velocity sweeps per sub-step, at least; more for tall structures at rest
    int movingSweeps = 4;     // velocity sweeps at most for a moving island (wide/groups.h), if islands are solved one by one
    double tolerance = 1e-3;  // m/s: sweeps end when no correction is larger; 0 = all sweeps
    int restFactor = 1;       // a small island at rest has this many times the sweeps, at most, and a
                              // tolerance smaller by it: what remains of every sub-step adds up there
    int nudges = 1;           // position sweeps per sub-step; 0 = off
    double nudgeFactor = 0.5; // beta: the share of the error C that one nudge removes
    double depenetrationSpeed = 1.0; // m/s: fastest separation of overlapping bodies by nudges
    double slop = 5e-4;       // m: penetration not corrected, so that a resting contact persists
    double baumgarte = 0.0;   // beta of b = beta C / h instead of nudges; never both
    Order order = Order::gravity;
    bool block = true;        // solve a manifold's normal rows, and a joint's point, together
    JointSolving joints = JointSolving::direct;  // see JointSolving
    bool warmStart = true;    // start from the impulses of the last step
    bool accumulate = true;   // clamp the total; false = clamp the correction (wrong)
    Gyroscope gyroscope = Gyroscope::momentum;
    Bounce bounce = Bounce::impacts;
    Springs springs = Springs::symplectic;
    double bounceSpeed = 0.25;       // m/s: slower approaches do not bounce, so that bodies come to rest
    double speculativeMargin = 0.02; // m: contacts are made this far ahead of touching
    bool lanes = true;        // solve contacts eight at a time in single precision; needs block and
                              // accumulate, and method impulses
    Instructions instructions = Instructions::best;
    bool sleeping = false;    // islands at rest fall asleep until something touches or changes
                              // them (dynamics/sleep.h): they cost next to nothing
    double sleepAfter = 0.5;  // s, at rest; if too short, a pendulum stops where it reverses
    int threads = 1;          // share the contacts of large groups; the bits are the same
    bool compareExact = false; // report every sweep's distance to the direct solution; slow

    /// Whether islands are solved one after the other, each until it is satisfied.
    bool solvesByIsland() const {
        return block && accumulate && method == Method::impulses && !compareExact;
    }
    /// Whether contacts are solved in lanes.
    bool usesLanes() const { return lanes && solvesByIsland(); }

    /// The default: the most stable settings with the best energy conservation in experiments.
    static Settings steady() { return {}; }

    /// For many bodies: half the sub-steps and usually at most eight sweeps, whatever error remains, except for small
    /// islands at rest. Stacks, walls and card houses stand; large piles sink by some centimetres at first.
    static Settings fast() {
        Settings s;
        s.substeps = 2;
        s.sweeps = 8;
        s.minSweeps = 1;
        s.movingSweeps = 3;
        s.tolerance = 2e-3;
        s.restFactor = 4;
        return s;
    }

    /// The two seed documents as printed: one sub-step, ten sweeps over single points in pair
    /// order, then four nudges.
    static Settings seed() {
        Settings s;
        s.substeps = 1;
        s.maxSubsteps = 1;
        s.sweeps = 10;
        s.minSweeps = 10;
        s.tolerance = 0.0;
        s.nudges = 4;
        s.nudgeFactor = 0.2;
        s.depenetrationSpeed = 1e4;
        s.slop = 5e-3;
        s.order = Order::pairs;
        s.block = false;
        s.lanes = false;
        s.joints = JointSolving::rows;
        s.gyroscope = Gyroscope::implicitEuler;
        s.bounce = Bounce::bias;
        s.springs = Springs::implicit;
        return s;
    }
};

}  // namespace engine
