/// What a World holds, and what happens before and after the six steps of the loop.
#pragma once
#include <functional>
#include <optional>
#include <span>
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
    std::vector<int> untreed;  // bodies that are in no tree: planes, and those that do not collide
    ContactFinder finder;
    Solver solver;
    Substeps substeps;
    Paces paces;
    std::vector<char> everyStep;                  // bodies that move in every sub-step
    std::vector<double> scales;                   // by body: its sub-step over its last one
    Sleep sleep;
    StepReport report;
    std::function<void(const World&, std::span<Load>)> field;
    std::vector<std::optional<ForceDef>> forces;  // by number; removed: empty
    int forceCount = 0;                           // that are not removed
    std::vector<Load> fieldLoads;                 // of the field and the forces, in this sub-step
    std::vector<int> springs;                     // of the forces, that pull at each body
    std::function<void(Phase, int)> observer;
    TouchLog touches;

    enum class Listed { none, solved, found };
    Listed listed = Listed::none;  // which contacts World::contacts() lists
    bool contactsStale = true;  // bodies came, went or were moved by the caller
    bool jointsStale = true;
    bool treesStale = false;    // joints fell asleep or woke
    double startOfPace = 0.0;   // s, when steps began to be of this length, and how many since:
    long long stepsAtPace = 0;  // time is counted, not added up
    double lastDt = 0.0;        // s

    bool again = false;         // the step begins anew, with fewer bodies
    int substepsALook = 1;      // that go by between two looks for contacts, at most
    int lookedAt = 0;           // before this sub-step
    std::vector<ContactState> solvedBefore;  // of this step, before the last look

    std::vector<Pose> posesBefore;           // to go back to when a step turns out wrong
    std::vector<Velocity> velocitiesBefore;

    /// Whether forces depend on where bodies are: they are looked at in every sub-step.
    bool hasForces() const { return field || forceCount > 0; }
    BodyId bodyId(int i) const { return {i, bodySlots.generation(i)}; }
    JointId jointId(int i) const { return {i, jointSlots.generation(i)}; }
    void phase(Phase which, int substep) const {
        if (observer) observer(which, substep);
    }
};

/// Contacts and joints up to date with what the caller did; rows for the solver. False: the world
/// has stopped.
bool beginStep(WorldState& s, double dt);

/// What the caller's force field and the forces say of a sub-step of length h (s).
void evaluateForces(const World& world, WorldState& s, int substep, double h);

/// Where fast bodies meet, or bodies that touch have turned far, contacts are found again within the
/// step (collision/moving_contacts.h): whether before this sub-step, h (s) being the length of one.
bool looksAgain(const WorldState& s, int substep, double h);
void findContactsWithin(WorldState& s, int substep, double h);

/// As World::remove.
void removeBody(WorldState& s, BodyId id);

/// False: some body's place or velocity is no number. Then the world is back where the step began,
/// without those that caused it; with all it was no number for, where nobody knows who did.
bool staysFinite(WorldState& s);

/// Step 6, and the report; bodies that are too fast or too far away do not go on as they were.
bool endStep(WorldState& s, double dt);

/// Of the bodies, and of the springs between them.
Energy energyNow(const WorldState& s);

/// Contacts as of now, without a step.
void findContactsNow(WorldState& s);

/// World::contacts() and World::errors(): nothing is paid for them until they are asked for.
void listContacts(const WorldState& s, std::vector<ContactState>& states);
ErrorReport errorsOf(const WorldState& s);

}  // namespace engine
