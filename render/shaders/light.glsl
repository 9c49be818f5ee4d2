#extension GL_ARB_gpu_shader5 : require
uniform sampler2DShadow shadowMap;
uniform mat4 worldToShadow;
uniform float shadowTexel;      // m
uniform int shadows;
uniform vec3 toSun;             // unit
uniform vec3 eye;
uniform vec3 skyLight, groundLight, sunLight;
uniform vec3 fogColor;
uniform float fogDistance;      // m

// Sixteen texels by four gathers, weighted so that the kernel moves smoothly with the point.
float kernel(vec3 p, float size) {
    vec2 t = p.xy * size - 0.5;
    vec2 f = fract(t);
    vec2 base = (floor(t) + 0.5) / size;
    float step = 1.0 / size;
    vec4 a = textureGather(shadowMap, base + vec2(-0.5, -0.5) * step, p.z);
    vec4 b = textureGather(shadowMap, base + vec2(1.5, -0.5) * step, p.z);
    vec4 c = textureGather(shadowMap, base + vec2(-0.5, 1.5) * step, p.z);
    vec4 d = textureGather(shadowMap, base + vec2(1.5, 1.5) * step, p.z);
    // Columns -1, 0, 1, 2 weigh (1 - f), 1, 1, f; a gather gives (0,1), (1,1), (1,0), (0,0).
    float gx = 1.0 - f.x, gy = 1.0 - f.y;
    float lower = (a.w * gx + a.z + b.w + b.z * f.x) * gy + (a.x * gx + a.y + b.x + b.y * f.x);
    float upper = (c.w * gx + c.z + d.w + d.z * f.x) + (c.x * gx + c.y + d.x + d.y * f.x) * f.y;
    return (lower + upper) / 9.0;
}

float sunlit(vec3 world, vec3 normal) {
    if (shadows == 0) return 1.0;
    // Moved out along the normal by what a texel's width hides at this slant: no acne, no gap.
    float slant = 1.0 - max(dot(normal, toSun), 0.0);
    vec3 p = (worldToShadow * vec4(world + normal * shadowTexel * (0.7 + 1.8 * slant), 1.0)).xyz;
    p = p * 0.5 + 0.5;
    if (any(lessThan(p, vec3(0.0))) || any(greaterThan(p, vec3(1.0)))) return 1.0;
    return kernel(p, float(textureSize(shadowMap, 0).x));
}

// Sun, sky and the ground's glow on a matt surface with a little shine.
vec3 lit(vec3 albedo, vec3 world, vec3 normal, float shine) {
    vec3 toEye = normalize(eye - world);
    float facing = max(dot(normal, toSun), 0.0);
    float sun = facing > 0.0 ? facing * sunlit(world, normal) : 0.0;
    vec3 ambient = mix(groundLight, skyLight, 0.5 + 0.5 * normal.y);
    vec3 color = albedo * (ambient + sunLight * sun);
    vec3 middle = normalize(toEye + toSun);
    float g = max(dot(normal, middle), 0.0);
    g *= g, g *= g, g *= g, g *= g;             // to the 16th
    float gloss = g * g * g * step(0.001, sun);  // to the 48th
    float rim = 1.0 - max(dot(normal, toEye), 0.0);
    rim *= rim, rim *= rim;
    return color + shine * (gloss * sunLight * 0.35 + rim * skyLight * 0.10);
}

vec3 fogged(vec3 color, vec3 world) {
    vec3 d = (eye - world) / fogDistance;
    float clear = 1.0 / (1.0 + dot(d, d));
    return mix(fogColor, color, clear * clear);
}

#include "encode.glsl"
