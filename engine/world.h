/// Rigid bodies, joints between them, and the step that moves them.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/body.h"
#include "engine/force.h"
#include "engine/joint.h"
#include "engine/ray.h"
#include "engine/settings.h"
#include "engine/step_report.h"
#include "engine/touch_event.h"

namespace engine {

struct WorldState;  // world_state.h

/// Does not throw; invalid calls stop the program (base/check.h). The same calls give the same bits.
class World {
public:
    /// An empty world with gravity (0, -9.81, 0) m/s^2.
    explicit World(const Settings& settings = Settings::steady());
    ~World();
    /// A World can be moved but not copied; a moved-from World may only be destroyed.
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;  // like the constructor

    /// A dynamic body needs a positive mass, given or by volume and density, and must not be a plane or mesh.
    /// A given inertia must be physically possible (isInertia), a rotation nonzero, a restitution within 0
    /// and 1, and every value finite.
    BodyId add(const BodyDef& def);
    /// Joins two different bodies of this world, at least one of them dynamic. A distance joint needs a
    /// positive length, a hinge a nonzero axis; springs must not have negative values.
    JointId add(const JointDef& def);
    /// While a force acts, its bodies do not sleep.
    ForceId add(const ForceDef& def);
    /// Also removes the body's joints, contacts and cached impulses. Until its number is used again, its
    /// definition and its last pose can be read.
    void remove(BodyId id);
    void remove(JointId id);  // must exist
    void remove(ForceId id);  // must exist

    /// Settings may change between two steps. All bodies wake, as after a change of gravity.
    void setSettings(const Settings& settings);
    const Settings& settings() const;  // as set
    /// m/s^2
    void setGravity(const Vec3& gravity);
    const Vec3& gravity() const;  // m/s^2

    /// Advances the world by dt (s), which must be positive. Bodies with too large or non-finite values are
    /// slowed down or removed, and reported (StepReport::incidents). False: no step could be done;
    /// report().trouble says why, and further steps do nothing.
    bool step(double dt);

    int bodyCount() const;   // removed bodies included
    int jointCount() const;  // removed joints included
    bool has(BodyId id) const;  // added and not removed
    const BodyDef& def(BodyId id) const;  // as added; mass and inertia filled in
    const Pose& pose(BodyId id) const;  // m; for a removed body, its last pose
    const Vec3& velocity(BodyId id) const;  // m/s
    const Vec3& spin(BodyId id) const;      // rad/s, world axes
    bool isAsleep(BodyId id) const;         // only if Settings::sleeping
    double mass(BodyId id) const;           // kg; 0 unless dynamic
    const Mat3& inertia(BodyId id) const;   // kg m^2, body axes
    JointState joint(JointId id) const;  // after the last step
    /// Sets limits, motor and spring of one coordinate of a joint, from the next step on.
    void setFreedom(JointId id, int coordinate, const Freedom& freedom);

    /// Contacts are found again before the next step. The rotation is normalised.
    void setPose(BodyId id, const Pose& pose);
    /// m/s and rad/s, world axes; for dynamic and kinematic bodies.
    void setVelocity(BodyId id, const Vec3& velocity, const Vec3& spin);
    /// N and N m, for the next step only.
    void applyForce(BodyId id, const Vec3& force, const Vec3& torque = Vec3::Zero());
    /// N s, at a point in world axes.
    void applyImpulse(BodyId id, const Vec3& impulse, const Vec3& at);

    /// The first body on the line between two points (m), of those that are `wanted`; an empty function means
    /// all that collide. A body that contains `from` is ignored; of two hit at once, the one with the lower
    /// number is returned.
    std::optional<RayHit> castRay(const Vec3& from, const Vec3& to,
                                  const std::function<bool(BodyId)>& wanted = {}) const;

    /// Finds the contacts of the present poses, to read them before the first step, or after bodies were
    /// added, moved or removed. Steps find their contacts themselves.
    void findContacts();
    /// The contacts that the last step solved, with their impulses, in the order of pairs; after
    /// findContacts(), those it found.
    std::vector<ContactState> contacts() const;
    /// The errors of the last contacts found and of the joints, at the present poses.
    ErrorReport errors() const;
    /// Whether every step records which bodies began or ceased to touch; initially off. Bodies that touch
    /// already begin in the next step.
    void watchTouches(bool watch);
    /// The events of the last step, in the order of pairs.
    std::span<const TouchEvent> touches() const;
    const StepReport& report() const;  // of the last step
    Energy energy() const;             // J, now
    /// A hash of the poses and velocities of all bodies, bit for bit.
    std::uint64_t hash() const;

    /// All that the next steps depend on, and what can be read of the last one, as bytes. They hold neither
    /// shapes, materials and settings nor functions. They replace those of `bytes` from `at` on.
    void saveState(std::vector<std::uint8_t>& bytes, std::size_t at = 0) const;
    /// Goes on from there, to the same bits, with any number of threads. The world must have got the same
    /// bodies, joints, forces and settings as the saved one, by the same calls. False: these bytes are not
    /// the state of such a world; then it may only be destroyed.
    bool restoreState(std::span<const std::uint8_t> bytes);

    /// A function called in every sub-step that adds forces depending on the state to one Load per body. An
    /// empty function removes it. While it is set, nothing sleeps. It may only read the world.
    void setForceField(std::function<void(const World&, std::span<Load>)> field);

    /// Sets a function called at the beginning of every phase with the number of the sub-step. It may only
    /// read the world. A step that is undone and repeated, with more sub-steps or without a body, calls it again
    /// from sub-step 0; so it calls the force field.
    void observe(std::function<void(Phase, int)> observer);

private:
    std::unique_ptr<WorldState> state_;
};

}  // namespace engine
