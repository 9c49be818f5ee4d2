#version 330 core
#include "material.glsl"
in vec3 world, worldNormal;
#ifdef LIT_CORNERS
in
#else
flat in
#endif
vec3 tint;
flat in int surface;
flat in float bulge;
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;
#ifndef LIT_CORNERS
// Moves a point of a ball's triangle, c + r n with |n| <= 1, along the ray of sight to the ball:
// |n + t e| = 1.
void onBall(inout vec3 place, inout vec3 n) {
    if (bulge == 0.0) return;
    vec3 e = normalize(eye - place);
    float b = dot(n, e), t = sqrt(max(b * b + 1.0 - dot(n, n), 0.0)) - b;
    place += bulge * t * e;
    n += t * e;
}
#endif

void main() {
    seen = surface;
#ifdef LIT_CORNERS
    result = vec4(tint, kCornerAlpha);
#else
    vec3 place = world, normal = worldNormal;
    onBall(place, normal);
    result = shaded(tint, place, normalize(normal), 1.0, surface);
#endif
}
