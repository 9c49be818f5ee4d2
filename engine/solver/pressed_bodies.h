/// A light body pressed between heavy ones counts for more than it weighs:
///   m <- max(m, M / 100),   I likewise
/// M being the heaviest that presses it. A sweep passes on a blow through a light body only as far as
/// that can carry it: a gram between two tonnes would need a million sweeps, and until then it is
/// squeezed through the floor, or the load is thrown back. What a pressed body does with its own
/// momentum does not show: its neighbours have a hundred times as much. Free bodies, those that lie on
/// one side only, and those with a joint keep their mass.
#pragma once
#include <span>
#include <vector>

#include "engine/constraints/contact.h"
#include "engine/constraints/joint_constraint.h"
#include "engine/dynamics/bodies.h"

namespace engine {

class PressedBodies {
public:
    /// Of a step: the bodies of these contacts.
    void load(std::span<const Contact> contacts, std::span<const Joint> joints, Bodies& bodies);
    /// At its end: everybody weighs what it weighs.
    void unload(Bodies& bodies);

private:
    void forget(int body);

    struct Press {
        int body = -1;
        double mass = 0.0;            // kg, of the heaviest
        Vec3 normal = Vec3::Zero();   // towards the body
    };
    std::vector<int> slot_;    // of every body; -1: nothing heavy touches it
    std::vector<Press> presses_;
    std::vector<int> pressed_;
};

}  // namespace engine
