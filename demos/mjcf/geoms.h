/// <geom>: shape, place, mass, friction and colour.
#pragma once
#include <optional>
#include <string>

#include "demos/mjcf/assets.h"
#include "demos/mjcf/mass_properties.h"

namespace demos::mjcf {

/// What a model's parts are read with.
struct Context {
    const Rules& rules;
    const Defaults& defaults;
    const Assets& assets;
    Diagnostics& diagnostics;
};

struct Geom {
    std::string name;  // empty where it has none
    std::string type;  // its shape's word
    engine::Shape shape;
    Pose pose;                  // of the shape's centre, in the body's axes
    MassProperties properties;  // likewise; of a plane none
    bool ownMass = false;       // the mass is given, not by density
    double friction = 1.0;
    double rolling = 0.0;       // m, where condim is 6
    std::optional<engine::Shape> picture;  // a mesh's triangles, at the same place
    bool isShown = true;        // in MuJoCo's window: of group 0, 1 or 2, and not clear
    int body = 0;               // a number for each <body>
    int condim = 3;
    int priority = 0;
    int contype = 1, conaffinity = 1;  // bits: who meets whom
    std::optional<unsigned> color;     // 0xRRGGBB
    Spot spot;

    bool collides() const { return contype != 0 || conaffinity != 0; }
};

/// Nothing where it is left out, or wrong; that is reported then.
std::optional<Geom> readGeom(const Element& element, const std::string& childclass,
                             const Context& context);

}  // namespace demos::mjcf
