#version 330 core
#include "instance.glsl"
#include "number.glsl"
uniform mat4 worldToClip;
flat out int surface;
void main() {
    surface = packedSurface();
    gl_Position = worldToClip * vec4(worldPoint(), 1.0);
}
