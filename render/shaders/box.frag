#version 330 core
#include "light.glsl"
in vec3 world, local;
flat in vec3 worldNormal, tint, halfSize;
flat in vec4 q;
uniform float lineWidth;        // pixels
uniform float lineStrength;     // 0..1
out vec4 result;

vec3 turn(vec4 r, vec3 v) { return v + 2.0 * cross(r.xyz, cross(r.xyz, v) + r.w * v); }

void main() {
    vec3 normal = worldNormal;
    vec3 inner = halfSize - abs(local);          // m, to each pair of faces
    vec3 across = fwidth(local) + 1e-6;          // m a pixel
    // The face's own axis is the one on which `local` does not change.
    vec3 face = step(inner, vec3(1e-4 * max(max(halfSize.x, halfSize.y), halfSize.z)));
    vec3 pixels = inner / across + face * 1e4;
    float line = 1.0 - smoothstep(lineWidth - 0.7, lineWidth + 0.7, min(min(pixels.x, pixels.y), pixels.z));
    // Small boxes: a line never takes more than a fair share of the face.
    vec3 size = halfSize / across + face * 1e4;
    line *= smoothstep(2.0, 7.0, min(min(size.x, size.y), size.z));
    vec3 color = tint;
#ifdef EDGES
    // A rounded edge: the normal leans out over the last stretch before it.
    float bevel = 0.045 * min(min(halfSize.x, halfSize.y), halfSize.z) + 0.004;
    vec3 lean = (1.0 - face) * sign(local) * (1.0 - smoothstep(vec3(0.0), vec3(bevel), inner));
    normal = normalize(normal + turn(q, lean) * 0.55);
    color *= 1.0 - lineStrength * line;
#endif
    result = vec4(encode(fogged(lit(color, world, normal, 0.6))), 1.0);
}
