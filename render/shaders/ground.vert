#version 330 core
layout(location = 0) in vec3 position;   // m
uniform mat4 worldToClip;
uniform vec3 across, along;              // unit, on the plane
out vec3 world;
out vec2 grid;                           // m, on the plane
void main() {
    world = position;
    grid = vec2(dot(world, across), dot(world, along));
    gl_Position = worldToClip * vec4(world, 1.0);
}
