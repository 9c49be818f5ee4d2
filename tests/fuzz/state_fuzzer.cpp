// A world's state with arbitrary bytes changed, cut or added, as if someone had sealed it so. The
// engine refuses it, or goes on for two steps: no crash, and no number is read outside of its list.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "tests/support/golden_worlds.h"

namespace {

using Bytes = std::vector<std::uint8_t>;
using support::World;

/// Contacts, a tree of joints, one outside, a drive, a force, a sensor that sees touches, and
/// sleep.
World small() {
    engine::Settings settings;
    settings.sleeping = true;
    World world(settings);
    world.add(support::floorPlane());
    const engine::BodyId hook = world.add(support::hook({0, 3, 0}));
    const engine::BodyId box = world.add(support::body(engine::Shape::box({1, 1, 1}), {0, 0.5, 0}));
    const engine::BodyId ball = world.add(support::body(engine::Shape::sphere(0.2), {0.5, 3, 0}));
    world.add(support::body(engine::Shape::box({1, 1, 1}), {3, 0.5, 0}));
    engine::JointDef hinge =
        support::jointAt(world, engine::JointType::hinge, hook, ball, {0, 3, 0}, {0, 0, 1});
    hinge.free[0].limits = {-1.0, 0.5};
    world.add(hinge);
    engine::JointDef soft =
        support::jointAt(world, engine::JointType::ball, box, ball, {0.2, 1.5, 0}, {0, 0, 1});
    soft.spring.hz = 2.0;
    world.add(soft);
    world.add(engine::ForceDef{engine::Drag{5.0, 1.0}, {ball}});
    world.watchTouches(true);
    return world;
}

const Bytes& saved() {
    static const Bytes bytes = [] {
        World world = small();
        support::run(world, 50);
        Bytes state;
        world.saveState(state);
        return state;
    }();
    return bytes;
}

/// Every three bytes of the input: a place and what is written there; a rest of two: how much is
/// cut off.
Bytes changed(const std::uint8_t* data, std::size_t size) {
    Bytes bytes = saved();
    for (; size >= 3; data += 3, size -= 3)
        bytes[(data[0] + 256u * data[1]) % bytes.size()] = data[2];
    if (size == 2) bytes.resize(bytes.size() - data[0] % bytes.size());
    return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    World world = small();
    if (!world.restoreState(changed(data, size))) return 0;
    for (int i = 0; i < 2; ++i) world.step(1.0 / 60);
    return 0;
}
