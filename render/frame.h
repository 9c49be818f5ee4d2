/// The contents of one picture, as plain values without pointers into a simulation: a frame can be
/// stored, compared, sent to another process or written by hand.
/// Units: metres; radians unless a name ends in Degrees. Y up, right-handed. Colours are sRGB.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "render/formula.h"

namespace render {

using Vec3 = Eigen::Vector3f;       // x, y, z
using Quat = Eigen::Quaternionf;    // a rotation, unit length

/// sRGB, each channel 0..1; a = 1 is opaque.
struct Color {
    float r = 0.8f, g = 0.8f, b = 0.8f, a = 1.0f;  // 0..1
};

struct SolidMesh;  // solid_mesh.h

/// The shape of a solid; Solid::halfSize gives its size.
enum class SolidShape { box, sphere, capsule, cylinder, cone, mesh };

/// The surface of a solid: its pattern, and how it reflects light (material.h).
enum class Material { plastic, wood, brick, steel, rubber, stone, paper, felt, glass };

/// A body's picture.
struct Solid {
    SolidShape shape = SolidShape::box;
    Vec3 halfSize{0.5f, 0.5f, 0.5f};  // m; box: half edges; sphere: (r, r, r);
                                      // capsule: (radius, half length of the core segment, radius)
                                      // cylinder, cone: (radius, half height, radius)
                                      // mesh: SolidMesh::halfSize
    Vec3 position{0, 0, 0};           // m, centre; for a cone the centre of mass: the base is
                                      // halfSize.y / 2 below it, the tip 1.5 halfSize.y above
    Quat rotation = Quat::Identity(); // round shapes have their axis along local y
    Color color;
    Material material = Material::plastic;
    int id = 0;                       // 0..65534, for data passes (data_images.h)
    std::shared_ptr<const SolidMesh> mesh{};  // for a mesh; if null, nothing is drawn
};

/// A straight round bar: joints, ropes.
struct Rod {
    Vec3 from{0, 0, 0}, to{0, 0, 0};  // m
    float radius = 0.03f;             // m
    Color color;
    int id = 0;  // as for a solid
};

/// An arrow over the picture, with its head at `to`; faint if it starts behind something.
struct Arrow {
    Vec3 from{0, 0, 0}, to{0, 0, 0};  // m
    Color color;
    float reach = 0.0f;  // m: something less than this in front of `from` does not hide it
};

/// A dot, or a quartered disc.
enum class MarkerShape { dot, quartered };

/// A mark of constant size on the picture: a contact point, or the quartered disc of a centre of
/// mass.
struct Marker {
    Vec3 position{0, 0, 0};  // m
    float pixels = 3.5f;  // radius in a picture of 1280x720
    Color color;
    float largest = 0.0f;  // m: upper limit of its radius in the world; 0 = none
    float reach = 0.0f;    // m, as for an arrow
    MarkerShape shape = MarkerShape::dot;
};

/// A thin line over the picture; faint where it is behind something.
struct Line {
    Vec3 from{0, 0, 0}, to{0, 0, 0};  // m
    float pixels = 1.5f;  // width in a picture of 1280x720
    Color color;
};

/// A name at a point. It is left out if it would cover another one or a corner's text, or if it is
/// behind something. The nearest labels are placed first.
struct Label {
    std::string text;    // one line, UTF-8
    Vec3 position{0, 0, 0};  // m
    float reach = 0.0f;  // m, as for an arrow; smaller bodies have smaller names
    float size = 15.0f;  // as for a text
    float below = 0.0f;  // distance of its middle below the point, in heights of the name
    std::string subscript{};  // smaller and lower, after the text
    std::string value{};      // after the subscript
    bool beside = false;  // next to its point, where it covers no arrow, marker or name; such labels
                          // are placed before the others
    std::vector<Vec3> clearOf{};  // m: it stands beside the rectangle around these points, with a line to
                                  // its own point, if there is room; empty: near its point
    Color color{0, 0, 0, 0};  // a = 0: Look::ink
};

/// A band along a path that fades towards its oldest (first) point.
struct Trail {
    std::vector<Vec3> points;  // m, oldest first
    float pixels = 4.0f;  // width in a picture 720 pixels high
    Color color;
};

/// An infinite plane with a grid that fades into the fog: {x : normal . x = offset}.
struct Ground {
    bool visible = true;   // false: it hides nothing and receives no shadow
    Vec3 normal{0, 1, 0};  // unit
    float offset = 0.0f;  // m
    int id = 0;           // as for a solid
};

/// A corner of the picture.
enum class Corner { topLeft, topRight, bottomLeft, bottomRight };

/// A text in a corner of the picture; texts in one corner stack in the order given. A text wider
/// than the picture is broken into lines. Letters have a halo, or stand on a plate.
struct Text {
    std::string text;  // UTF-8; glyphs: Latin, Greek, arrows, arithmetic signs; characters for formulas
    Corner corner = Corner::topLeft;
    float size = 18.0f;  // pixels of cap-to-descender height in a picture of 1280x720
    Color color{0.1f, 0.1f, 0.11f, 1.0f};
    bool plate = false;     // translucent, with Look::plate as its colour
    std::string heading{};  // smaller, above the text; left out where letters are smallest
    Color headingColor{0.1f, 0.1f, 0.11f, 1.0f};  // sRGB
    std::vector<Formula> formulas{};  // in the text; such a text has no halo
    bool needed = false;  // drawn even where it hides much of a small picture
};

/// The symbol before a row's text: a sample of a mark in the picture.
enum class Swatch { none, dot, quartered, arrow, line };

/// A share of a bar, 0..1 of its width.
struct BarPart {
    float share = 0.0f;  // 0..1
    Color color;
};

/// One row of a plate: a swatch or none, a name, and a value at the right edge.
struct PlateRow {
    std::string name, value;   // UTF-8
    Swatch swatch = Swatch::none;
    Color color{};             // of the swatch
    float meters = 0.0f;       // length of an arrow, at the camera's lookAt; 0 = short
    std::vector<BarPart> bar{};  // below the text, from left to right; empty = none
    std::vector<Color> ramp{};   // a colour scale above the text, from left to right; empty = none
};

/// A table on a translucent background, in a corner, below the corner's texts.
struct Plate {
    Corner corner = Corner::topRight;
    float size = 15.0f;  // as for a text
    std::vector<PlateRow> rows;
};

/// The viewpoint of the picture.
struct Camera {
    Vec3 from{8, 5, 14};       // m
    Vec3 lookAt{0, 2, 0};      // m, the picture's middle; must differ from `from`
    Vec3 up{0, 1, 0};          // not parallel to the view direction
    float fovDegrees = 35.0f;  // vertical
    float aperture = 0.0f;     // m, radius of the lens: blur out of focus, in sub-frames
    float focus = 0.0f;        // m along the view axis; 0: at lookAt
};

/// Light, colours and line widths.
struct Look {
    Vec3 sunDirection{0.45f, 0.75f, 0.5f};  // towards the sun, any length
    Color skyTop{0.42f, 0.51f, 0.61f, 1.0f};      // at the picture's upper edge
    Color skyHorizon{0.74f, 0.79f, 0.83f, 1.0f};  // and at its horizon
    Color fog{0.80f, 0.82f, 0.83f, 1.0f};         // colour the ground fades to
    Color ground{0.76f, 0.735f, 0.70f, 1.0f};     // nearby, without its grid
    bool shadows = true;           // of the sun
    bool ambientOcclusion = true;  // darker where little of the sky is visible
    bool edges = true;             // lines along the edges of bodies
    bool dither = false;       // no bands in smooth gradients, for files of up to 2.5 times the size
    bool transparent = false;  // no sky and no ground: alpha is 0 where there is no body
    float lineStrength = 1.0f;  // of edges and of the grid
    float reflection = 0.0f;  // 0..1: share of the bodies' image in the floor, seen at a flat angle
    float grain = 0.2f;  // m: the size of the patterns of materials
    float gridReach = 0.0f;  // m from lookAt, where a quarter of the grid is left; 0: all everywhere
    float unit = 0.0f;  // pixels for 1 pixel of 1280x720, for text (which then never shrinks),
                        // marks and lines; 0: by the picture's area
    float edgePixels = 0.0f;  // width of bodies' edges and the ground's lines; 0: by the height
    Color ink{0.1f, 0.1f, 0.11f, 1.0f};         // text of plates and labels
    Color plate{0.96f, 0.965f, 0.97f, 0.72f};  // background of plates
};

/// Everything that one picture shows.
struct Frame {
    Camera camera;
    Look look;
    std::vector<Ground> grounds;
    std::vector<Solid> solids;
    std::vector<Rod> rods;
    std::vector<Arrow> arrows;
    std::vector<Marker> markers;
    std::vector<Line> lines;
    std::vector<Solid> ghosts;  // sensors, earlier poses (oldest first); translucent by their colour's a
    std::vector<Label> labels;
    std::vector<Trail> trails;
    std::vector<Text> texts;
    std::vector<Plate> plates;
};

}  // namespace render
