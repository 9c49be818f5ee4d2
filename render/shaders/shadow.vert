#version 330 core
#include "instance.glsl"
uniform mat4 worldToShadow;
void main() { gl_Position = worldToShadow * vec4(worldPoint(), 1.0); }
