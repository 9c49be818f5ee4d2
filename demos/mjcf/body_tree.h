/// <worldbody>: the tree of <body>s as rigid links, with poses in the world. A <body> without a
/// joint is welded to its parent and is a part of the parent's link.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "demos/mjcf/geoms.h"

namespace demos::mjcf {

/// A <joint> of a link; joints.h reads its anchor, axis and forces.
struct JointElement {
    const Element* element = nullptr;
    std::string childclass;
};

constexpr int kWorld = -1;

struct Link {
    std::string name;                    // of its <body>; may be empty
    int parent = kWorld;                 // the parent's number
    Pose pose;                           // of its <body>, world axes, y up
    std::vector<Geom> geoms;             // in the axes of `pose`
    std::vector<MassProperties> masses;  // in the same axes: one per <body>
    std::vector<JointElement> joints;    // none: it is free
    bool ownInertia = false;             // from an <inertial>
    std::string lacking;                 // an unsupported element that would give it mass
    bool refused = false;                // part of it is an error, reported: its mass is unknown
    Spot spot;
};

/// The link and the pose of a <body> of the file.
struct Whereabouts {
    int link = kWorld;
    Pose pose;  // world axes, y up
};

struct BodyTree {
    std::vector<Link> links;
    std::vector<Geom> fixed;                    // in world axes: the geoms that cannot move
    std::map<std::string, Whereabouts> bodies;  // by name; also "world"
    std::map<std::string, Whereabouts> sites;   // by name
    std::string lacking;  // an unsupported element that would make bodies
};

/// `root`, which has to outlive the tree: <mujoco>.
BodyTree readBodies(const Element& root, const Context& context);

}  // namespace demos::mjcf
