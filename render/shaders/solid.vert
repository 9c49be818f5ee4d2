#version 330 core
#include "instance.glsl"
#include "number.glsl"
uniform mat4 worldToClip;
#ifdef LIT_CORNERS
#include "sky_light.glsl"
#include "shadow_place.glsl"
#include "encode.glsl"
#endif
out vec3 world;
#if defined(LIT_CORNERS) && !defined(FLAT_FACES)
out vec3 tint;                              // sRGB
#else
flat out vec3 tint;                         // linear; with LIT_CORNERS: sRGB
#endif
flat out int surface;
#ifdef FLAT_FACES
flat out vec3 worldNormal, worldU, worldV;  // unit; u and v are the face's own axes
out vec2 onFace;                            // m, from its middle
flat out vec2 halfFace;                     // m
flat out float thinnest;                    // m, of the box's half edges

void setFace(vec3 local) {
    int axis = int(face) / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    vec3 unit = vec3(0.0);
    unit[u] = 1.0, worldU = turn(rotation, unit);
    unit[u] = 0.0, unit[v] = 1.0, worldV = turn(rotation, unit);
    onFace = vec2(local[u], local[v]);
    halfFace = vec2(scale[u], scale[v]);
    thinnest = min(min(scale.x, scale.y), scale.z);
}
#else
uniform float ofDome;                       // 1 for half a ball, else 0
out vec3 worldNormal;
flat out float bulge;                       // m: of half a ball its radius, else 0
void setFace(vec3 local) { bulge = ofDome * scale.x; }
#endif

void main() {
    world = worldPoint();
    worldNormal = turn(rotation, vertexNormal);
    tint = color;
#ifdef LIT_CORNERS
    tint = encode(color * (ambient(worldNormal) + sunLight * max(dot(worldNormal, toSun), 0.0)));
#endif
    surface = packedSurface();
    setFace(localPoint());
    setPattern();
    gl_Position = worldToClip * vec4(world, 1.0);
}
