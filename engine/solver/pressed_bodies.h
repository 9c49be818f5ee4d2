/// A light body pressed between heavy ones is treated as heavier:
///   m <- max(m, M / 100),   I in proportion
/// where M is the heaviest that presses it. In a sweep, a light body passes on only a small part of an
/// impulse: a gram between two tonnes would need a million sweeps; with fewer it is squeezed through the
/// floor, or the load is thrown back. The error in its own momentum does not matter, because its neighbours
/// have a hundred times as much. Free bodies, those that are touched from one side or by one body only, and those
/// with a joint keep their mass.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class PressedBodies {
public:
    /// At the beginning of a step: sets the mass factors of the pressed bodies of these contacts.
    void load(std::span<const Contact> contacts, std::span<const Joint> joints, Bodies& bodies);
    /// At the end of the step: resets the mass factors.
    void unload(Bodies& bodies);

private:
    void forget(int body);

    struct Press {
        int body = -1, by = -1;
        double mass = 0.0;            // kg, of the heaviest neighbour
        Vec3 normal = Vec3::Zero();   // towards the body
    };
    std::vector<int> slot_;    // by body; -1: nothing heavy touches it
    std::vector<Press> presses_;
    std::vector<int> pressed_;
};

}  // namespace engine
