/// The parts of a snapshot.
#pragma once
#include <string>

#include "demos/look/overlays.h"
#include "demos/play/stage.h"
#include "demos/snapshot/history.h"
#include "render/frame.h"

namespace demos {

/// The input of every part.
struct Moment {
    const Stage& stage;
    const Overlays& overlays;
    const History& history;
    double time;  // s
};

inline render::Vec3 drawn(const Vec3& v) { return v.cast<float>(); }

using engine::reachOf;

/// m: approximate distance from the centre to the nearest face; 0 for a plane and a mesh.
double thicknessOf(const engine::Shape& shape);

void addBodies(const Moment& moment, render::Frame& frame);     // bodies.cpp
void addGhosts(const Moment& moment, render::Frame& frame);     // bodies.cpp
void addBodyMarks(const Moment& moment, render::Frame& frame);  // marks.cpp: axes, com, bounds, ids
void addJoints(const Moment& moment, render::Frame& frame);     // joints.cpp
void addJointMarks(const Stage& stage, const engine::JointState& joint,
                   render::Frame& frame);                       // joint_marks.cpp
void addTrails(const Moment& moment, render::Frame& frame);     // trails.cpp
void addContacts(const Moment& moment, render::Frame& frame);   // contacts.cpp
void addNudges(const Moment& moment, render::Frame& frame);     // contacts.cpp
void addAnnotations(const Moment& moment, render::Frame& frame);  // annotations.cpp
void addTexts(const Moment& moment, render::Frame& frame);      // texts.cpp: caption
void colorHeadings(render::Frame& frame);                       // texts.cpp, after the theme
void addStats(const Moment& moment, render::Frame& frame);      // stats.cpp
void addLegend(const Moment& moment, render::Frame& frame);     // legend.cpp

}  // namespace demos
