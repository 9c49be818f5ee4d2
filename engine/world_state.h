/// The state of a World, and the work before and after the six steps of the loop.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/base/hash.h"
#include "engine/base/slots.h"
#include "engine/collision/contacts.h"
#include "engine/dynamics/energy.h"
#include "engine/dynamics/sleep.h"
#include "engine/solver/prepare_joints.h"
#include "engine/solver/paces.h"
#include "engine/solver/substeps.h"
#include "engine/world.h"
#include "engine/world_touches.h"

namespace engine {

struct WorldState {
    Settings settings;
    Vec3 gravity{0.0, -9.81, 0.0};
    Bodies bodies;
    std::vector<Joint> joints;
    Slots bodySlots, jointSlots, forceSlots;
    std::vector<int> untreed;  // bodies outside the tree: planes, and those that do not collide
    ContactFinder finder;
    Solver solver;
    Substeps substeps;
    Paces paces;
    std::vector<std::pair<int, int>> linked;      // bodies whose forces depend on each other
    std::vector<double> scales;                   // by body: its sub-step over its previous one
    Sleep sleep;
    StepReport report;
    std::function<void(const World&, std::span<Load>)> field;
    std::vector<std::optional<ForceDef>> forces;  // by number; removed: empty
    int forceCount = 0;                           // not counting removed ones
    std::vector<Load> fieldLoads;                 // from field and forces, in this sub-step
    std::vector<int> badlyLoaded;                 // bodies that got the first non-finite velocities by a force
    std::vector<int> tooFast;                     // bodies slowed down in this step, ascending
    std::vector<int> springs;                     // number of spring forces, by body
    std::function<void(Phase, int)> observer;
    bool calling = false;                         // one of the caller's functions
    TouchLog touches;

    enum class Listed { none, solved, found, kept };
    Listed listed = Listed::none;  // which contacts World::contacts() lists
    std::vector<ContactState> kept;  // those of a state, until the next step
    bool contactsStale = true;  // bodies were added, removed or moved by the caller
    bool jointsStale = true;
    bool treesStale = false;    // joints fell asleep or woke
    double startOfPace = 0.0;   // s, when steps got this length, and how many since:
    long long stepsAtPace = 0;  // time is multiplied, not added up
    double lastDt = 0.0;        // s

    bool again = false;         // the step is repeated, with fewer bodies
    int substepsALook = 1;      // sub-steps between two contact detections, at most (world_looks.h)
    std::vector<int> lookedAt;  // by body: sub-step of the last contact detection
    std::vector<char> looks;       // by body: takes part in those of this step
    std::vector<int> fast, turned; // bodies that need them; that have turned far
    std::vector<int> everTurned;   // the latter, since the step began
    // Kept for their memory only: by set of Paces, and sets.
    std::vector<char> reached;
    std::vector<Bounds> bounds;
    std::vector<int> next, open;
    std::vector<std::tuple<int, Pose, Velocity>> keepers;  // bodies that keep their contacts
    std::vector<ContactState> solvedBefore;  // of this step, before the last contact detection

    std::vector<Pose> posesBefore;           // to undo a failed step
    std::vector<Velocity> velocitiesBefore;
    std::vector<double> spansBefore;
    std::vector<Acceleration> accelerationsBefore;

    /// Whether there are forces to evaluate in every sub-step.
    bool hasForces() const { return field || forceCount > 0; }
    BodyId bodyId(int i) const { return {i, bodySlots.generation(i)}; }
    JointId jointId(int i) const { return {i, jointSlots.generation(i)}; }
    void phase(Phase which, int substep) {
        if (observer) call(observer, which, substep);
    }
    /// Calls one of the caller's functions, which may only read the world (world_checks.h).
    template <class Function, class... Values>
    void call(const Function& function, Values&&... values) {
        struct End {
            bool& calling;
            ~End() { calling = false; }  // also if the function throws
        } const end{calling};
        calling = true;
        function(std::forward<Values>(values)...);
    }
};

/// Updates contacts and joints after the caller's changes, and makes the solver's rows. False: the world has
/// stopped.
bool beginStep(WorldState& s, double dt);

/// Evaluates the caller's force field and the forces for a sub-step of length h (s).
void evaluateForces(const World& world, WorldState& s, int substep, double h);

/// Finds the contacts for the coming dt (s).
void findContacts(WorldState& s, double dt);
/// Stores the states of the contacts solved so far, before they are found again within the step.
void keepSolved(WorldState& s);

/// Like World::remove.
void removeBody(WorldState& s, BodyId id);

/// Undoes the step up to now.
void goBack(WorldState& s);

/// True: joints turned so fast that they needed more sub-steps (solver/substeps.h). Then the step is undone.
bool turnedTooFast(WorldState& s, double dt);

/// Step 6 and the report.
bool endStep(WorldState& s, double dt);

/// The energy of bodies, joints and forces.
Energy energyNow(const WorldState& s);

/// Finds the present contacts without a step.
void findContactsNow(WorldState& s);

/// For World::contacts() and World::errors(): computed only on request.
void listContacts(const WorldState& s, std::vector<ContactState>& states);
ErrorReport errorsOf(const WorldState& s);

}  // namespace engine
