#version 330 core
#include "shadow_place.glsl"
layout(location = 0) in vec3 position;   // m
uniform mat4 worldToClip;
uniform vec3 normal, across, along;      // unit; the last two on the plane
out vec3 place;                          // in the shadow map
out vec2 grid;                           // m, on the plane
#ifdef LIT_CORNERS
#include "encode.glsl"
uniform vec3 groundColor, lineColor, fogColor, ambientLight, fullSun;  // linear
flat out vec3 plainTint, lineTint, fogTint;                            // sRGB
#endif
void main() {
    place = shadowPlace(position, normal);
    grid = vec2(dot(position, across), dot(position, along));
    gl_Position = worldToClip * vec4(position, 1.0);
#ifdef LIT_CORNERS
    plainTint = encode(groundColor * (ambientLight + fullSun));
    lineTint = encode(lineColor * (ambientLight + fullSun));
    fogTint = encode(fogColor);
#endif
}
