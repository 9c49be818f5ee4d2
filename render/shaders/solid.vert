#version 330 core
#include "instance.glsl"
uniform mat4 worldToClip;
#ifdef FLAT_FACES
flat
#endif
out vec3 worldNormal;
out vec3 world, local;
flat out vec3 tint, halfSize;
flat out vec4 q;
void main() {
    world = worldPoint();
    worldNormal = turn(rotation, vertexNormal);
    local = localPoint();
    halfSize = scale;
    q = rotation;
    tint = color;
    gl_Position = worldToClip * vec4(world, 1.0);
}
