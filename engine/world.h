/// Rigid bodies, joints between them, and the step that moves them.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "engine/body.h"
#include "engine/joint.h"
#include "engine/ray.h"
#include "engine/settings.h"
#include "engine/step_report.h"

namespace engine {

struct WorldState;  // world_state.h

/// Does not throw; wrong calls stop the program (base/check.h). Same calls, same bits.
class World {
public:
    explicit World(const Settings& settings = Settings::steady());
    ~World();
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;

    BodyId add(const BodyDef& def);
    JointId add(const JointDef& def);
    /// The body's joints, contacts and cached impulses go with it.
    void remove(BodyId id);
    void remove(JointId id);

    /// Settings may change between two steps; whoever sleeps wakes, as with another gravity.
    void setSettings(const Settings& settings);
    const Settings& settings() const;
    /// m/s^2
    void setGravity(const Vec3& gravity);
    const Vec3& gravity() const;

    /// Moves the world on by dt (s). False: the state would not have been finite or sane; the world
    /// is back at the step's beginning, report() says why, and further steps do nothing.
    bool step(double dt);

    int bodyCount() const;   // removed bodies included
    int jointCount() const;
    bool has(BodyId id) const;
    const BodyDef& def(BodyId id) const;  // as added; mass and inertia filled in
    const Pose& pose(BodyId id) const;
    const Vec3& velocity(BodyId id) const;  // m/s
    const Vec3& spin(BodyId id) const;      // rad/s, world axes
    bool isAsleep(BodyId id) const;         // never unless Settings::sleeping
    double mass(BodyId id) const;           // kg; 0 unless dynamic
    const Mat3& inertia(BodyId id) const;   // kg m^2, body axes
    JointState joint(JointId id) const;
    /// Other limits, motor and spring of one coordinate of a joint, from the next step on.
    void setFreedom(JointId id, int coordinate, const Freedom& freedom);

    /// Contacts are found anew before the next step.
    void setPose(BodyId id, const Pose& pose);
    void setVelocity(BodyId id, const Vec3& velocity, const Vec3& spin);
    /// N and N m, for the next step only.
    void applyForce(BodyId id, const Vec3& force, const Vec3& torque = Vec3::Zero());
    /// N s, at a point in world axes.
    void applyImpulse(BodyId id, const Vec3& impulse, const Vec3& at);

    /// The first body on the straight way between two points (m), of those that are `wanted`; an
    /// empty function wants all that collide. A body that holds `from` is passed through; of two
    /// that are met at once, the one added first. Looks at every body; changes nothing.
    std::optional<RayHit> castRay(const Vec3& from, const Vec3& to,
                                  const std::function<bool(BodyId)>& wanted = {}) const;

    /// The contacts that the last step solved, with their impulses; before the first step, those it
    /// will solve.
    std::span<const ContactState> contacts() const;
    const StepReport& report() const;
    Energy energy() const;
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
