/// What a World holds, and what happens before and after the six steps of the loop.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/hash.h"
#include "engine/collision/contacts.h"
#include "engine/dynamics/energy.h"
#include "engine/dynamics/sleep.h"
#include "engine/solver/prepare_joints.h"
#include "engine/solver/substeps.h"
#include "engine/world.h"
#include "engine/world_touches.h"

namespace engine {

struct WorldState {
    Settings settings;
    Vec3 gravity{0.0, -9.81, 0.0};
    Bodies bodies;
    std::vector<Joint> joints;
    ContactFinder finder;
    Solver solver;
    SubstepChooser substeps;
    Sleep sleep;
    StepReport report;
    std::vector<ContactState> contactStates;
    std::function<void(const World&, std::span<Load>)> field;
    std::vector<std::optional<ForceDef>> forces;  // by number; removed: empty
    std::vector<Load> fieldLoads;                 // of the field and the forces, in this sub-step
    std::function<void(Phase, int)> observer;
    TouchLog touches;

    bool statesStale = false;   // contactStates are those of an earlier step
    bool separationsStale = false;  // so are the report's worst penetration and separation
    bool contactsStale = true;  // bodies came, went or were moved by the caller
    bool jointsStale = true;
    bool treesStale = false;    // joints fell asleep or woke
    double startOfPace = 0.0;   // s, when steps began to be of this length, and how many since:
    long long stepsAtPace = 0;  // time is counted, not added up
    double lastDt = 0.0;        // s; impulses are kept per sub-step of this length
    int lastSubsteps = 0;

    std::vector<Velocity> velocitiesBefore;  // to go back to when a step turns out wrong

    /// Whether forces depend on where bodies are: they are looked at in every sub-step.
    bool hasForces() const { return field || !forces.empty(); }
    void phase(Phase which, int substep) const {
        if (observer) observer(which, substep);
    }
};

/// Contacts and joints up to date with what the caller did; rows for the solver. False: the world
/// has stopped.
bool beginStep(WorldState& s, double dt);

/// What the caller's force field and the forces say of a sub-step of length h (s).
void evaluateForces(const World& world, WorldState& s, int substep, double h);

/// Step 6, the report, and the last look at whether the new state is one to pass on.
bool endStep(WorldState& s, double dt);

/// Of the bodies, and of the springs between them.
Energy energyNow(const WorldState& s);

/// Contacts and report as of now, without a step.
void refresh(WorldState& s);

/// What the report says of contacts and separations, and contactStates of the last step: nothing pays
/// for them until they are asked for.
void reportSeparations(WorldState& s);
void listContacts(WorldState& s);

}  // namespace engine
