#version 330 core
// The mean over the pattern's 4 x 4 cells, leaving out what lies at another depth.
uniform sampler2D depthMap, openMap;  // half size
out float open;
void main() {
    ivec2 p = ivec2(gl_FragCoord.xy), last = textureSize(openMap, 0) - 1;
    float here = texelFetch(depthMap, p, 0).r;
    float sum = 0.0, weight = 0.0;
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            ivec2 s = clamp(p + ivec2(x, y), ivec2(0), last);
            float w = abs(texelFetch(depthMap, s, 0).r - here) < 0.012 * here ? 1.0 : 0.0;
            sum += w * texelFetch(openMap, s, 0).r;
            weight += w;
        }
    open = sum / weight;  // the pixel itself is always one of them
}
