#version 330 core
#include "material.glsl"
in vec3 world;
in vec2 onFace;                             // m, from the face's middle
flat in vec3 worldNormal, worldU, worldV, tint;
flat in vec2 halfFace;
flat in float thinnest;
flat in int surface;
uniform float lineWidth;        // pixels
uniform float lineStrength;     // 0..1
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;

// Coverage of the pixel by the lines along the face's edges. They fade on small faces.
float lineCover(vec2 inner) {
    vec2 perPixel = 1.0 / (fwidth(onFace) + 1e-6);
    vec2 pixels = inner * perPixel, size = halfFace * perPixel;
    float line = 1.0 - smoothstep(lineWidth - 0.7, lineWidth + 0.7, min(pixels.x, pixels.y));
    return line * smoothstep(2.0, 7.0, min(size.x, size.y));
}

void main() {
    vec3 normal = worldNormal, color = tint;
    seen = surface;
#ifdef EDGES
    vec2 inner = halfFace - abs(onFace);    // m, to each pair of edges
    color *= 1.0 - lineStrength * lineCover(inner);
#endif
#ifdef LIT_CORNERS
    result = vec4(color, kCornerAlpha);
#else
#ifdef EDGES
    // A rounded edge: the normal leans outwards near the edge. Where that is less than 2.5 pixels wide it
    // leans less and from farther, or the edge would be a row of dashes.
    float bevel = 0.045 * thinnest + 0.004;
    vec2 width = max(vec2(bevel), 2.5 * fwidth(onFace));
    vec2 lean = sign(onFace) * (1.0 - smoothstep(vec2(0.0), width, inner)) * bevel / width;
    normal = normalize(normal + 0.55 * (worldU * lean.x + worldV * lean.y));
#endif
    result = shaded(color, world, normal, 0.6, surface);
#endif
}
