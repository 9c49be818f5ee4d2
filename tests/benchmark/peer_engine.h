/// What a driver gives to the benchmark: one engine that builds a scene and steps it. A driver
/// (peer_impulse.cpp, peer_bullet.cpp, peer_ode.cpp) is linked with peer_main.cpp to one program.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tests/benchmark/peer_scenes.h"

namespace peers {

/// What a body does after a step: all that is asked of an engine, the rest is measured.
struct BodyState {
    Pose pose;
    Vec3 velocity{0, 0, 0};  // m/s, of the centre of mass
    Vec3 spin{0, 0, 0};      // rad/s, world axes
};

class Engine {
public:
    virtual ~Engine() = default;
    /// Once, before anything else; the scene outlives the engine.
    virtual void build(const Scene& scene) = 0;
    /// False: the engine has given up, the bodies stay where they are.
    virtual bool step(double dt) = 0;
    /// Of the scene's body of this number.
    virtual BodyState state(int body) const = 0;
    /// Contact points in the engine's care after the last step, as it counts them itself.
    virtual int contactPoints() const = 0;
};

// Each driver defines these three.
std::string engineName();
std::vector<std::string> presetNames();  // the first is the default
/// Nothing where the engine has no such preset or cannot step on so many threads.
std::unique_ptr<Engine> makeEngine(const std::string& preset, int threads);

}  // namespace peers
