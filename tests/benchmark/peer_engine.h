/// The interface of a driver: one engine that builds a scene and steps it. Each driver
/// (peer_impulse.cpp, peer_bullet.cpp, peer_ode.cpp) is linked with peer_main.cpp into one program.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tests/benchmark/peer_scenes.h"

namespace peers {

/// A body's state after a step: all that an engine reports; the rest is measured from it.
struct BodyState {
    Pose pose;
    Vec3 velocity{0, 0, 0};  // m/s, of the centre of mass
    Vec3 spin{0, 0, 0};      // rad/s, world axes
};

class Engine {
public:
    virtual ~Engine() = default;
    /// False: its driver cannot build this scene.
    virtual bool supports(const Scene&) const { return true; }
    /// Called once, before anything else; the scene outlives the engine.
    virtual void build(const Scene& scene) = 0;
    /// False: the engine gave up; the bodies stay where they are.
    virtual bool step(double dt) = 0;
    /// The state of the scene's body of this number.
    virtual BodyState state(int body) const = 0;
    /// Contact points after the last step, as the engine counts them.
    virtual int contactPoints() const = 0;
};

// Each driver defines these three.
std::string engineName();
std::vector<std::string> presetNames();  // the first is the default
/// Nothing if the engine has no such preset or does not support so many threads.
std::unique_ptr<Engine> makeEngine(const std::string& preset, int threads);

}  // namespace peers
