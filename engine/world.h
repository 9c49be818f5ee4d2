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

/// Does not throw; wrong calls stop the program (base/check.h). Same calls, same bits.
class World {
public:
    /// An empty world with gravity (0, -9.81, 0) m/s^2.
    explicit World(const Settings& settings = Settings::steady());
    ~World();
    /// Worlds move and are not copied; of one that was moved from, only destruction is left.
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;  // as the constructor

    /// A dynamic body needs a positive mass, its own or by volume and density, and is no plane or mesh; an
    /// inertia that is given has to be one that a body has (isInertia), a rotation not zero.
    BodyId add(const BodyDef& def);
    /// Between two different bodies of this world, one of them dynamic. A distance joint needs a
    /// positive length, a hinge an axis that is not zero, a spring no negative numbers.
    JointId add(const JointDef& def);
    /// While it acts, its bodies do not sleep.
    ForceId add(const ForceDef& def);
    /// The body's joints, contacts and cached impulses go with it. Until its number is used again, its
    /// definition and its last pose can be read.
    void remove(BodyId id);
    void remove(JointId id);  // which has to be there
    void remove(ForceId id);  // as well

    /// Settings may change between two steps; whoever sleeps wakes, as with another gravity.
    void setSettings(const Settings& settings);
    const Settings& settings() const;  // as set
    /// m/s^2
    void setGravity(const Vec3& gravity);
    const Vec3& gravity() const;  // m/s^2

    /// Moves the world on by dt (s), which has to be positive. Bodies that cannot go on are slowed down
    /// or taken out, and reported (StepReport::incidents). False: no step could be done at all;
    /// report().trouble says why, and further steps do nothing.
    bool step(double dt);

    int bodyCount() const;   // removed bodies included
    int jointCount() const;  // removed joints included
    bool has(BodyId id) const;  // and it was not removed
    const BodyDef& def(BodyId id) const;  // as added; mass and inertia filled in
    const Pose& pose(BodyId id) const;  // m; of a removed body the last one
    const Vec3& velocity(BodyId id) const;  // m/s
    const Vec3& spin(BodyId id) const;      // rad/s, world axes
    bool isAsleep(BodyId id) const;         // never unless Settings::sleeping
    double mass(BodyId id) const;           // kg; 0 unless dynamic
    const Mat3& inertia(BodyId id) const;   // kg m^2, body axes
    JointState joint(JointId id) const;  // as the last step left it
    /// Other limits, motor and spring of one coordinate of a joint, from the next step on.
    void setFreedom(JointId id, int coordinate, const Freedom& freedom);

    /// Contacts are found again before the next step. A rotation is normalised.
    void setPose(BodyId id, const Pose& pose);
    /// m/s and rad/s, world axes; of a dynamic or kinematic body.
    void setVelocity(BodyId id, const Vec3& velocity, const Vec3& spin);
    /// N and N m, for the next step only.
    void applyForce(BodyId id, const Vec3& force, const Vec3& torque = Vec3::Zero());
    /// N s, at a point in world axes.
    void applyImpulse(BodyId id, const Vec3& impulse, const Vec3& at);

    /// The first body on the straight way between two points (m), of those that are `wanted`; an
    /// empty function wants all that collide. A body that holds `from` is passed through; of two
    /// that are met at once, the one with the lower number.
    std::optional<RayHit> castRay(const Vec3& from, const Vec3& to,
                                  const std::function<bool(BodyId)>& wanted = {}) const;

    /// Contacts as the bodies are now, for a look at them before the first step, which will solve them,
    /// or after bodies were added, moved or removed. Steps find their contacts themselves.
    void findContacts();
    /// The contacts that the last step solved, with their impulses, in the order of pairs; after
    /// findContacts() those that were found.
    std::vector<ContactState> contacts() const;
    /// Of the contacts that were found last and of the joints, as the bodies are now.
    ErrorReport errors() const;
    /// Whether every step is to tell who began to touch and who has parted; off at first. Who
    /// touches already begins in the next step.
    void watchTouches(bool watch);
    /// Of the last step, in the order of pairs.
    std::span<const TouchEvent> touches() const;
    const StepReport& report() const;  // of the last step
    Energy energy() const;             // J, now
    /// Poses and velocities of all bodies, bit for bit.
    std::uint64_t hash() const;

    /// Forces that depend on where the bodies are, asked for in every sub-step: adds to one Load per
    /// body. An empty function takes them away. While there are any, nothing sleeps.
    void setForceField(std::function<void(const World&, std::span<Load>)> field);

    /// Called at the beginning of every phase with the number of the sub-step.
    void observe(std::function<void(Phase, int)> observer);

private:
    std::unique_ptr<WorldState> state_;
};

}  // namespace engine
