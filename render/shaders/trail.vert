#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 color;    // sRGB and opacity
layout(location = 2) in vec2 across;   // pixels: from the trail's middle, and half its width
out vec4 tint;
noperspective out vec2 place;
void main() {
    tint = color;
    place = across;
    gl_Position = clip;
}
