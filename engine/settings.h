/// Every switch of the solver, so that each idea can be turned off and its worth be seen.
/// `demos/scene` reads the same names from a scene's [solver] table.
#pragma once

namespace engine {

/// How the constraints of a step are solved; all of them take the same rows and give the same kind of
/// impulses, so that they can be changed between two steps of a running world.
///   impulses   sequential impulses: one constraint after the other, velocities at once (the default)
///   pgs        projected Gauss-Seidel on forces, a = B lambda carried along (Catto 2005)
///   pgsMatrix  the same with A = J M^-1 J^T written out: what the first seed argues against
///   direct     exact, by factoring A, with an active set for contacts; small scenes only
enum class Method { impulses, pgs, pgsMatrix, direct };

/// gravity: contacts from the top down, so that a sweep carries weight to the floor in one pass.
/// pairs: lower body number first, as the author numbered them.
enum class Order { gravity, pairs };

/// direct: trees of joints are solved exactly, a tree at a time. rows: like any other constraint.
enum class JointSolving { direct, rows };

/// How the spin of a free body is carried on (dynamics/rotation.h).
enum class Gyroscope { momentum, implicitEuler, none };

/// Which velocity a bounce is measured from. impacts: a pass of its own before the sweeps, one pair
/// after the other, so that a blow travels through a row of balls. bias: b = e (J v1), taken once
/// before solving (Eberly's formula).
enum class Bounce { impacts, bias };

/// How soft rows and springs of joints swing (constraints/soft.h).
enum class Springs { symplectic, implicit };

/// What the wide contact solver runs on; the bits are the same.
enum class Instructions { best, baseline };

/// What a World is made with and may be given between two steps. No sub-step, no thread, a negative
/// count, Baumgarte beside nudges: each of them stops the program there.
struct Settings {
    Method method = Method::impulses;
    int substeps = 4;         // velocities, impulses, positions and nudges, this often a step
    int maxSubsteps = 32;     // as often where joints or masses ask for it (solver/substeps.h)
    int sweeps = 20;          // velocity sweeps a sub-step, at most
    int minSweeps = 2;        // and at least
    int movingSweeps = 4;     // at most for an island on the move (wide/groups.h); lanes only
    double tolerance = 1e-3;  // m/s: enough when no row's correction was larger; 0 = all sweeps
    int nudges = 1;           // position sweeps a sub-step; 0 = off
    double nudgeFactor = 0.5; // beta: the share of the error C that one nudge takes away
    double depenetrationSpeed = 1.0; // m/s: at most, bodies that overlap are nudged apart
    double slop = 5e-4;       // m: penetration left alone, so that a resting contact stays a contact
    double baumgarte = 0.0;   // b = beta C / h instead of nudges; never both
    Order order = Order::gravity;
    bool block = true;        // a manifold's normal rows, and a joint's point, solved together
    JointSolving joints = JointSolving::direct;  // as that says
    bool warmStart = true;    // start from the impulses of the last step
    bool accumulate = true;   // clamp the total; false = clamp the correction: the wrong way
    Gyroscope gyroscope = Gyroscope::momentum;
    Bounce bounce = Bounce::impacts;
    Springs springs = Springs::symplectic;
    double bounceSpeed = 0.25;       // m/s: slower approaches do not bounce, so that things rest
    double speculativeMargin = 0.02; // m: contacts are made this far ahead of touching
    bool lanes = true;        // contacts eight side by side, in single precision; needs block and
                              // accumulate, and method impulses
    Instructions instructions = Instructions::best;
    bool sleeping = false;    // islands at rest fall asleep until something touches or changes
                              // them (dynamics/sleep.h): they cost next to nothing
    double sleepAfter = 0.5;  // s, at rest; if short, a pendulum stops where it turns
    int threads = 1;          // that share the contacts of large groups; the bits are the same
    bool compareExact = false; // every sweep's distance to the direct solution in the report; slow

    /// Whether contacts are solved in lanes.
    bool usesLanes() const {
        return lanes && block && accumulate && method == Method::impulses && !compareExact;
    }

    /// The default: what held still and kept its energy best in experiment.
    static Settings steady() { return {}; }

    /// For many bodies: half the sub-steps and eight sweeps at most, whatever is left over. Stacks and
    /// walls stand, large piles sink by some centimetres first.
    static Settings fast() {
        Settings s;
        s.substeps = 2;
        s.sweeps = 8;
        s.minSweeps = 1;
        s.movingSweeps = 3;
        s.tolerance = 2e-3;
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
