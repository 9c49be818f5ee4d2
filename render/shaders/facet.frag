#version 330 core
#include "material.glsl"
in vec3 world, worldNormal, tint;
in vec3 edgeDistances;                  // m
in vec3 lean0, lean1, lean2;
flat in float thinnest, halfFace;
flat in int surface;
uniform float lineWidth;        // pixels
uniform float lineStrength;     // 0..1
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;

// As on a box, but with no line at edges of less than 10 degrees, and a full one from 30 on.
float lineCover() {
    vec3 pixel = fwidth(edgeDistances) + 1e-6;
    vec3 bend = vec3(length(lean0), length(lean1), length(lean2));
    vec3 line = 1.0 - smoothstep(lineWidth - 0.7, lineWidth + 0.7, edgeDistances / pixel);
    line *= smoothstep(0.087, 0.268, bend) * smoothstep(2.0, 7.0, halfFace / pixel);
    return max(max(line.x, line.y), line.z);
}

void main() {
    vec3 normal = normalize(worldNormal), color = tint;
    seen = surface;
#ifdef EDGES
    color *= 1.0 - lineStrength * lineCover();
#endif
#ifdef LIT_CORNERS
    result = vec4(color, kCornerAlpha);
#else
#ifdef EDGES
    // A rounded edge, as on a box.
    float bevel = 0.045 * thinnest + 0.004;
    vec3 width = max(vec3(bevel), 2.5 * fwidth(edgeDistances));
    vec3 near = (1.0 - smoothstep(vec3(0.0), width, edgeDistances)) * bevel / width;
    normal = normalize(normal + 0.55 * (lean0 * near.x + lean1 * near.y + lean2 * near.z));
#endif
    result = shaded(color, world, normal, 0.6, surface);
#endif
}
