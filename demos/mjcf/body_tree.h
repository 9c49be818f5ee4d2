/// <worldbody>: the tree of <body>s as rigid links, all at their places in the world. A <body>
/// without a joint is welded to the one around it and is a part of its link.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/geoms.h"

namespace demos::mjcf {

/// A <joint> in its place; where it holds and what acts on it is read by joints.h.
struct JointElement {
    const Element* element = nullptr;
    std::string childclass;
};

constexpr int kWorld = -1;

struct Link {
    std::string name;                    // of its <body>; may be empty
    int parent = kWorld;                 // its number
    Pose pose;                           // of its <body>, world axes, y up
    std::vector<Geom> geoms;             // in the axes of `pose`
    std::vector<MassProperties> masses;  // likewise: one of each <body>
    std::vector<JointElement> joints;    // none: it is free
    bool ownInertia = false;             // by an <inertial>
    std::string lacking;                 // an element that would give it mass and is not supported
    bool refused = false;                // what of it is wrong is reported: its mass is not known
    Spot spot;
};

/// Where a <body> of the file is.
struct Whereabouts {
    int link = kWorld;
    Pose pose;  // world axes, y up
};

struct BodyTree {
    std::vector<Link> links;
    std::vector<Geom> fixed;                    // in world axes: what no joint lets move
    std::map<std::string, Whereabouts> bodies;  // by name; "world" too
    std::map<std::string, Whereabouts> sites;   // by name
    std::string lacking;  // an element that would make bodies and is not supported
};

/// `root`, which has to outlive the tree: <mujoco>.
BodyTree readBodies(const Element& root, const Context& context);

}  // namespace demos::mjcf
