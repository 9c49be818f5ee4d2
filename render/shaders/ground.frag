#version 330 core
#include "light.glsl"
#include "dither.glsl"
in vec3 place;                        // in the shadow map
in vec2 grid;                         // m, on the plane
uniform vec3 groundColor, lineColor;  // linear
uniform vec3 ambientLight, fullSun;   // on a fully lit plane, linear
uniform float lineStrength;
uniform float perCell;                // 1 / m between thin lines; every fifth is strong
uniform vec2 subject;                 // m, on the plane: the grid fades away from it
uniform float perReach;               // 1 / m
uniform int surface;
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;

// Coverage of the pixel by grid lines; every fifth is a strong one. They fade where they get dense.
float lines() {
    vec2 at = grid * perCell, number = floor(at + 0.5);
    vec2 pixel = max(fwidth(at), vec2(1e-6));
    vec2 fifth = abs(number * 0.2 - floor(number * 0.2 + 0.5));
    vec2 strong = step(fifth, vec2(0.1));
    vec2 width = mix(vec2(1.1), vec2(2.4), strong) * lineStrength;
    vec2 cover = clamp(width * 0.5 + 0.5 - abs(at - number) / pixel, 0.0, 1.0);
    vec2 sparse = clamp(1.6 - mix(vec2(20.0), vec2(4.0), strong) * pixel, 0.0, 1.0);
    cover *= sparse * mix(vec2(0.22), vec2(0.62), strong);
    vec2 away = (grid - subject) * perReach;
    float near = 1.0 / (1.0 + dot(away, away));
    return max(cover.x, cover.y) * near * near;
}

vec3 light() {
    float sees = open();
    return ambientLight * sees + fullSun * sunShare(place, sees);
}

#ifdef GLOSSY
uniform sampler2D mirror;     // square roots of linear values
uniform vec2 perPixel;        // 1 / size of the picture
uniform vec3 plainFloor;      // linear, as in the mirror where no body is
uniform vec2 eye2;            // m, on the plane
uniform float eyeHeight;      // m, above it
uniform float reflection;     // 0..1

// Where the image is brighter than the room that an empty floor shows, it adds light; where it is darker,
// it takes away a share, also of the light in shadows.
vec3 withMirror(vec3 color) {
    vec2 away = grid - eye2;
    float down = eyeHeight * inversesqrt(dot(away, away) + eyeHeight * eyeHeight);
    vec3 image = texture(mirror, gl_FragCoord.xy * perPixel).rgb;
    vec3 change = reflection * (1.0 - 0.5 * down) * (image * image - plainFloor);
    return color * (1.0 + min(change, 0.0) / max(plainFloor, 1e-4)) + max(change, 0.0);
}
#else
vec3 withMirror(vec3 color) { return color; }
#endif

#ifdef SHADOW_CATCHER
// Black, with the missing share of light as alpha: over any background it looks like the shadow.
void main() {
    float share = dot(light(), vec3(1.0)) / dot(ambientLight + fullSun, vec3(1.0));
    seen = surface;
    result = vec4(0.0, 0.0, 0.0, 1.0 - encode(vec3(clamp(share, 0.0, 1.0))).r);
}
#elif defined(LIT_CORNERS)
flat in vec3 plainTint, lineTint, fogTint;  // sRGB
void main() {
    seen = surface;
    result = vec4(mix(fogTint, mix(plainTint, lineTint, lines()), clearness()), 1.0);
}
#else
void main() {
    vec3 color = mix(groundColor, lineColor, lines());
    seen = surface;
    result = vec4(dithered(encode(fogged(withMirror(color * light())))), 1.0);
}
#endif
