/// <geom>: shape, place, mass, friction and colour.
#pragma once
#include <optional>
#include <string>

#include "demos/mjcf/assets.h"
#include "demos/mjcf/mass_properties.h"

namespace demos::mjcf {

/// What the readers of a model's parts need.
struct Context {
    const Rules& rules;
    const Defaults& defaults;
    const Assets& assets;
    Diagnostics& diagnostics;
};

struct Geom {
    std::string name;  // empty if it has none
    std::string type;  // the word of its shape
    engine::Shape shape;
    Pose pose;                  // of the shape's centre, in the body's axes
    MassProperties properties;  // in the same axes; zero for a plane
    bool ownMass = false;       // the mass is given, not computed from density
    double friction = 1.0;
    double rolling = 0.0;       // m, if condim is 6
    std::optional<engine::Shape> picture;  // a mesh's triangles, at the same pose
    bool isShown = true;        // in MuJoCo's viewer: group 0, 1 or 2, and not transparent
    int body = 0;               // number of its <body>
    int condim = 3;
    int priority = 0;
    int contype = 1, conaffinity = 1;  // bits: contact_filter.h
    std::optional<unsigned> color;     // 0xRRGGBB
    Spot spot;

    bool collides() const { return contype != 0 || conaffinity != 0; }
};

/// Nothing if it is left out or wrong, which is reported.
std::optional<Geom> readGeom(const Element& element, const std::string& childclass,
                             const Context& context);

}  // namespace demos::mjcf
