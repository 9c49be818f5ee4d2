#version 330 core
in vec3 ray;
uniform vec3 fogColor, horizonColor, topColor;
out vec4 result;
#include "encode.glsl"
void main() {
    float up = normalize(ray).y;
    vec3 color = mix(fogColor, horizonColor, smoothstep(0.0, 0.07, up));
    color = mix(color, topColor, smoothstep(0.05, 0.5, up));
    result = vec4(encode(color), 1.0);
}
