#version 330 core
#include "instance.glsl"
#include "number.glsl"
layout(location = 10) in vec3 toEdges;      // lengths of `along`
layout(location = 11) in vec3 beyond[3];    // normals on the other side of the edges
layout(location = 14) in vec2 along;        // across the y axis, and along it
layout(location = 15) in float apothem;     // lengths of `along`
uniform mat4 worldToClip;
uniform float thinnestOfUnit;               // of the half sizes, before it is scaled
#ifdef LIT_CORNERS
#include "sky_light.glsl"
#include "shadow_place.glsl"
#include "encode.glsl"
#endif
out vec3 world, worldNormal;
out vec3 tint;                              // linear; with LIT_CORNERS: sRGB
out vec3 edgeDistances;                     // m
out vec3 lean0, lean1, lean2;               // from the normal to the mean normal at an edge
flat out float thinnest, halfFace;          // m
flat out int surface;

vec3 scaledNormal(vec3 n) { return normalize(n / scale); }

// Its length is the tangent of half the angle between the normals, but at most that of a box.
vec3 lean(vec3 n, vec3 other) {
    vec3 m = scaledNormal(other);
    vec3 v = (m - dot(n, m) * n) / max(1.0 + dot(n, m), 0.01);
    return turn(rotation, v / max(length(v), 1.0));
}

void main() {
    vec3 normal = scaledNormal(vertexNormal);
    float unit = length(along * scale.xy);
    world = worldPoint();
    worldNormal = turn(rotation, normal);
    edgeDistances = toEdges * unit;
    lean0 = lean(normal, beyond[0]), lean1 = lean(normal, beyond[1]);
    lean2 = lean(normal, beyond[2]);
    halfFace = apothem * unit;
    thinnest = thinnestOfUnit * min(min(scale.x, scale.y), scale.z);
    surface = packedSurface();
    setPattern();
    tint = color;
#ifdef LIT_CORNERS
    tint = encode(color * (ambient(worldNormal) + sunLight * max(dot(worldNormal, toSun), 0.0)));
#endif
    gl_Position = worldToClip * vec4(world, 1.0);
}
