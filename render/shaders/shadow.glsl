// The share of the sun's and of the sky's light that reaches a point; p: the point in the map.

#ifdef SHADOWS
uniform sampler2DShadow shadowMap;
uniform float shadowSize;          // texels per side

// Sixteen texels from four gathers, weighted so that the kernel moves smoothly with the point.
float sunlit(vec3 p) {
    vec2 t = p.xy - 0.5;
    vec2 f = fract(t), g = 1.0 - f;
    float texel = 1.0 / shadowSize;
    vec2 low = floor(t) * texel, high = low + 2.0 * texel;
    vec4 a = textureGather(shadowMap, low, p.z);
    vec4 b = textureGather(shadowMap, vec2(high.x, low.y), p.z);
    vec4 c = textureGather(shadowMap, vec2(low.x, high.y), p.z);
    vec4 d = textureGather(shadowMap, high, p.z);
    // Columns -1, 0, 1, 2 weigh (1 - f), 1, 1, f; a gather gives (0,1), (1,1), (1,0), (0,0).
    float lower = (a.w * g.x + a.z + b.w + b.z * f.x) * g.y + (a.x * g.x + a.y + b.x + b.y * f.x);
    float upper = (c.w * g.x + c.z + d.w + d.z * f.x) + (c.x * g.x + c.y + d.x + d.y * f.x) * f.y;
    float share = (lower + upper) / 9.0;
    return share > 0.9999 ? 1.0 : share;  // exactly: elsewhere grounds are drawn without a lookup
}
#else
float sunlit(vec3 p) { return 1.0; }
#endif

#ifdef OCCLUSION
uniform sampler2D openMap;      // visible share of the sky
float open() { return texelFetch(openMap, ivec2(gl_FragCoord.xy), 0).r; }
#else
float open() { return 1.0; }
#endif
