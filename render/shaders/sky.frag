#version 330 core
in float up;                                    // of a ray of length 1 along the view axis
uniform vec3 fogColor, horizonColor, topColor;  // sRGB, mixed in sRGB
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;
#include "dither.glsl"
void main() {
    seen = -1;
    vec3 color = mix(fogColor, horizonColor, smoothstep(0.0, 0.07, up));
    result = vec4(dithered(mix(color, topColor, smoothstep(0.05, 0.5, up))), 1.0);
}
