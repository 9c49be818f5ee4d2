/// What one picture shows, as plain values: nothing points back into a simulation, so a frame can
/// be kept, compared, sent to another process or written by hand.
/// Units: metres, radians unless a name ends in Degrees, Y up, right-handed. Colours are sRGB.
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace render {

using Vec3 = Eigen::Vector3f;
using Quat = Eigen::Quaternionf;

/// sRGB, each channel 0..1; a = 1 is opaque.
struct Color {
    float r = 0.8f, g = 0.8f, b = 0.8f, a = 1.0f;
};

enum class SolidShape { box, sphere, capsule };

/// A body's picture.
struct Solid {
    SolidShape shape = SolidShape::box;
    Vec3 halfSize{0.5f, 0.5f, 0.5f};  // m; box: half edges; sphere: (r, r, r);
                                      // capsule: (radius, half length of the core segment, radius)
    Vec3 position{0, 0, 0};           // m, centre
    Quat rotation = Quat::Identity(); // a capsule's core lies along its own y
    Color color;
    int id = 0;                       // 0..65534, for data passes (data_images.h)
};

/// A straight round bar: joints, ropes.
struct Rod {
    Vec3 from{0, 0, 0}, to{0, 0, 0};
    float radius = 0.03f;
    Color color;
    int id = 0;  // as a solid's
};

/// Drawn over everything it touches, with a head at `to`.
struct Arrow {
    Vec3 from{0, 0, 0}, to{0, 0, 0};
    Color color;
};

/// A dot of constant size on the picture (contact points).
struct Marker {
    Vec3 position{0, 0, 0};
    float pixels = 3.5f;  // radius in a picture 720 pixels high; scales with the height
    Color color;
};

/// A band along a path that fades towards its oldest (first) point.
struct Trail {
    std::vector<Vec3> points;
    float pixels = 4.0f;  // width in a picture 720 pixels high
    Color color;
};

/// An infinite plane with a grid that fades into the fog: {x : normal . x = offset}.
struct Ground {
    bool visible = true;
    Vec3 normal{0, 1, 0};
    float offset = 0.0f;  // m
    int id = 0;           // as a solid's
};

enum class Corner { topLeft, topRight, bottomLeft, bottomRight };

/// One line of text in a corner of the picture; lines in one corner stack in the order given.
struct Text {
    std::string text;  // UTF-8; glyphs: Latin, Greek, arrows, arithmetic signs
    Corner corner = Corner::topLeft;
    float size = 18.0f;  // pixels of cap-to-descender height in a picture 720 pixels high
    Color color{0.1f, 0.1f, 0.11f, 1.0f};
};

struct Camera {
    Vec3 from{8, 5, 14};
    Vec3 lookAt{0, 2, 0};
    Vec3 up{0, 1, 0};
    float fovDegrees = 35.0f;  // vertical
    float aperture = 0.0f;     // m, the lens's radius: what is not in focus is soft, in sub-frames
    float focus = 0.0f;        // m along the view axis; 0: at lookAt
};

/// Light and ground tones.
struct Look {
    Vec3 sunDirection{0.45f, 0.75f, 0.5f};  // towards the sun, any length
    Color skyTop{0.66f, 0.72f, 0.78f, 1.0f};
    Color skyHorizon{0.87f, 0.89f, 0.91f, 1.0f};
    Color fog{0.84f, 0.86f, 0.885f, 1.0f};
    Color ground{0.71f, 0.715f, 0.72f, 1.0f};
    bool shadows = true;
    bool ambientOcclusion = true;
    bool edges = true;
    bool transparent = false;  // no sky and no ground: alpha is 0 where nothing stands
    float lineStrength = 1.0f;  // of edges and of the grid
};

struct Frame {
    Camera camera;
    Look look;
    std::vector<Ground> grounds;
    std::vector<Solid> solids;
    std::vector<Rod> rods;
    std::vector<Arrow> arrows;
    std::vector<Marker> markers;
    std::vector<Trail> trails;
    std::vector<Text> texts;
};

}  // namespace render
