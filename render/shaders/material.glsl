// The materials of bodies: one program each, chosen by a macro; without one, plastic.
#include "light.glsl"
#include "mirrored.glsl"
#include "dither.glsl"

// Of a body whose light is that of its corners: in drafts glass has no reflections.
#ifdef SEEN_THROUGH
const float kCornerAlpha = 0.4;
#else
const float kCornerAlpha = 1.0;
#endif

// The cosine between the normal and the middle of eye and sun, to the 16th.
float gloss16(vec3 normal, vec3 toEye) {
    float g = max(dot(normal, normalize(toEye + toSun)), 0.0);
    return g *= g, g *= g, g *= g, g * g;
}
// To the fourth: light from behind that grazes the surface.
float rim(vec3 normal, vec3 toEye) {
    float r = 1.0 - max(dot(normal, toEye), 0.0);
    return r *= r, r * r;
}

#ifdef PATTERN
#include "noise.glsl"
in vec3 inBody;             // m, in the body's axes; y along the longest
uniform float perGrain;     // 1 / m
// Every body has its own part of the pattern.
vec3 patternPlace(int number) {
    return inBody * perGrain + vec3(7.13, 3.71, 5.37) * float(number >> 12 & 1023);
}
// 1 where a period of the pattern is many pixels long, 0 where it is less than two.
float visible(vec3 p, float periods) {
    vec3 w = fwidth(p);
    return clamp(2.0 - 4.0 * periods * max(w.x, max(w.y, w.z)), 0.0, 1.0);
}
// Noise about 0, of half the given size, faded out where it is too fine.
float grain(vec3 p, vec3 periods, float size) {
    float finest = max(periods.x, max(periods.y, periods.z));
    return size * (noise(p * periods) - 0.5) * visible(p, finest);
}
#endif

// Light above 0.8 is compressed so that hues last up to white (Khronos PBR neutral tone mapper).
vec3 toned(vec3 color) {
    const float kStart = 0.8, kRest = 1.0 - kStart, kFade = 0.15;
    float peak = max(color.r, max(color.g, color.b)), over = max(peak - kStart, 0.0);
    float lower = min(peak, 1.0 - kRest * kRest / (kRest + over));
    float white = 1.0 - 1.0 / (kFade * (peak - lower) + 1.0);
    return mix(color * (lower / max(peak, 1e-6)), vec3(lower), white);
}

// What a mirror shows of a studio: floor, back wall, sky, and a soft box in front of the sun.
vec3 room(vec3 ray) {
    vec3 above = skyLight * mix(2.1, 0.9, smoothstep(0.0, 0.7, ray.y));
    vec3 below = groundLight * mix(0.9, 0.45, smoothstep(0.0, 0.9, -ray.y));
    float box = smoothstep(0.86, 0.97, dot(ray, toSun));
    return mix(below, above, smoothstep(-0.3, 0.2, ray.y)) + 1.2 * box * sunLight;
}

// The light that leaves a body of this colour (linear) towards the eye, in sRGB, and its alpha.
// `shine`: of plastic. `number`: the packed surface.
vec4 shaded(vec3 tint, vec3 world, vec3 normal, float shine, int number) {
    vec3 toEye = normalize(eye - world);
    float alpha = 1.0;
#if defined(WOOD)
    // Rings about an axis beside the body, and fibres along it.
    vec3 p = patternPlace(number);
    float rings = length(p.xz + vec2(3.1, 1.7) + 0.8 * noise(p * vec3(0.35, 0.08, 0.35)));
    float late = abs(fract(rings) - 0.35) / 0.65;
    tint *= 1.0 + visible(p, 1.0) * (0.24 * (late * late - 0.35));
    tint *= 1.0 + grain(p, vec3(7.0, 0.35, 7.0), 0.24);
#elif defined(BRICK)
    vec3 p = patternPlace(number);
    float coarse = noise(p * 0.9) - 0.5;
    tint *= 1.0 + 0.35 * coarse + grain(p, vec3(5.0), 0.35);
#elif defined(STONE)
    vec3 p = patternPlace(number);
    tint *= 1.0 + 0.45 * (noise(p * 0.7) - 0.5) + grain(p, vec3(2.3), 0.25) +
            grain(p, vec3(7.0), 0.30);
#elif defined(PAPER)
    tint *= 1.0 + grain(patternPlace(number), vec3(5.0, 1.2, 5.0), 0.07);
#elif defined(FELT)
    tint *= 1.0 + grain(patternPlace(number), vec3(7.0), 0.5);
#elif defined(STEEL)
    vec3 p = patternPlace(number);
    tint *= 1.0 + grain(p, vec3(9.0, 0.25, 9.0), 0.22);  // brushed
#endif
    Light light = lightAt(world, normal);
    vec3 color = matt(tint, normal, light);
    float lit = min(8.0 * light.sun, 1.0);
#if defined(STEEL)
    vec3 mirrored = room(reflect(-toEye, normal)) * (0.35 + 0.65 * light.sees);
    float g = gloss16(normal, toEye);
    vec3 metal = 0.22 * color + mix(tint, vec3(1.0), 0.5 * rim(normal, toEye)) * 0.85 * mirrored;
    metal += tint * sunLight * g * g * lit * 0.5;
    // A face seen from its edge has few samples in some pixels: a bright mirror would be a row of dots.
    color = mix(color, metal, smoothstep(0.0, 0.08, dot(normal, toEye)));
#elif defined(GLASS)
    float edge = mix(0.05, 1.0, rim(normal, toEye));
    float g = gloss16(normal, toEye);
    color = mix(0.7 * color, room(reflect(-toEye, normal)), edge) + g * g * g * g * lit * sunLight;
    alpha = min(0.26 + 0.7 * edge + g * g * g * g * lit, 1.0);
#elif defined(RUBBER)
    float g = gloss16(normal, toEye);
    color += g * lit * sunLight * 0.05 + rim(normal, toEye) * skyLight * 0.12;
#elif defined(WOOD)
    float g = gloss16(normal, toEye);
    color += 0.5 * shine * (g * g * lit * sunLight * 0.16 + rim(normal, toEye) * skyLight * 0.08);
#elif defined(FELT)
    color += tint * skyLight * 0.6 * rim(normal, toEye) * light.sees;
#elif defined(STONE)
    color += gloss16(normal, toEye) * lit * sunLight * 0.03;
#elif !defined(PAPER) && !defined(BRICK)
    float g = gloss16(normal, toEye);
    color += shine * (g * g * g * lit * sunLight * 0.35 + rim(normal, toEye) * skyLight * 0.10);
#endif
#ifdef MIRRORED
    return seenInFloor(toned(color), world);
#else
    return vec4(dithered(encode(fogged(toned(color)))), alpha);
#endif
}
