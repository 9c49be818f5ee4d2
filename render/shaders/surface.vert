#version 330 core
#include "instance.glsl"
layout(location = 8) in float number;
uniform mat4 worldToClip;
flat out int surface;

// 0..5: -x +x -y +y -z +z
int face(vec3 n) {
    vec3 size = abs(n);
    int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    return 2 * axis + (n[axis] > 0.0 ? 1 : 0);
}

void main() {
    surface = 8 * int(number) + face(vertexNormal);
    gl_Position = worldToClip * vec4(worldPoint(), 1.0);
}
