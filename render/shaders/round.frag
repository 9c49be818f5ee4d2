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
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;
void main() {
    seen = surface;
#ifdef LIT_CORNERS
    result = vec4(tint, kCornerAlpha);
#else
    result = shaded(tint, world, normalize(worldNormal), 1.0, surface);
#endif
}
