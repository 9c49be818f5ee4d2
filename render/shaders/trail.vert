#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 color;   // sRGB and cover
out vec4 tint;
void main() {
    tint = color;
    gl_Position = clip;
}
