#version 330 core
uniform sampler2D depthMap;
#include "depth.glsl"
out float depth;            // m, at half the size
void main() { depth = eyeDepth(texelFetch(depthMap, ivec2(gl_FragCoord.xy) * 2, 0).r); }
