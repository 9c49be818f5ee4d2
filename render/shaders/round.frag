#version 330 core
#include "light.glsl"
in vec3 world, worldNormal, tint, local;
out vec4 result;
void main() {
    result = vec4(encode(fogged(lit(tint, world, normalize(worldNormal), 1.0))), 1.0);
}
