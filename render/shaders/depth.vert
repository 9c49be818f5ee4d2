#version 330 core
#include "instance.glsl"
uniform mat4 worldToClip;
void main() { gl_Position = worldToClip * vec4(worldPoint(), 1.0); }
