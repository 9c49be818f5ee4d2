#version 330 core
#include "light.glsl"
in vec3 world, worldNormal;
flat in vec3 tint;
out vec4 result;
void main() {
    result = vec4(encode(fogged(lit(tint, world, normalize(worldNormal), 1.0))), 1.0);
}
