#version 330 core
// The picture, darkened where the sky is hidden; of the four half-size pixels around, those count
// that lie at the pixel's own depth.
uniform sampler2D colorMap, depthMap, halfDepthMap, openMap;
#include "depth.glsl"
out vec4 result;
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(openMap, 0) - 1;
    float here = eyeDepth(texelFetch(depthMap, p, 0).r);
    ivec2 first = (p - 1) / 2;
    float sum = 0.0, weight = 1e-4;
    for (int i = 0; i < 4; ++i) {
        ivec2 s = clamp(first + ivec2(i & 1, i >> 1), ivec2(0), last);
        float w = abs(texelFetch(halfDepthMap, s, 0).r - here) < 0.012 * here ? 1.0 : 0.0;
        sum += w * texelFetch(openMap, s, 0).r;
        weight += w;
    }
    float open = weight > 0.5 ? sum / weight : 1.0;
    vec4 color = texelFetch(colorMap, p, 0);
    result = vec4(color.rgb * mix(1.0, open, 0.85), color.a);
}
