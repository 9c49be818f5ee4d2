#extension GL_ARB_gpu_shader5 : require
uniform vec3 eye;
uniform vec3 fogColor;
uniform float fogStart, fogDistance;  // m

#include "sky_light.glsl"
#include "shadow_place.glsl"
#include "shadow.glsl"

// A point that sees little of the sky also sees a little less of the sun, which is not a point.
float sunShare(vec3 place, float sees) {
    return sunlit(place) * (0.7 + 0.3 * sees);
}

// Sun and sky on a matt surface; `shine`: strength of the gloss on it.
vec3 lit(vec3 albedo, vec3 world, vec3 normal, float shine) {
    float sees = open();
    float sun = max(dot(normal, toSun), 0.0) * sunShare(shadowPlace(world, normal), sees);
    vec3 color = albedo * (ambient(normal) * sees + sunLight * sun);
    vec3 toEye = normalize(eye - world);
    float g = max(dot(normal, normalize(toEye + toSun)), 0.0);
    g *= g, g *= g, g *= g, g *= g;                 // to the 16th
    float gloss = g * g * g * min(8.0 * sun, 1.0);  // to the 48th
    float rim = 1.0 - max(dot(normal, toEye), 0.0);
    rim *= rim, rim *= rim;
    color += shine * (gloss * sunLight * 0.35 + rim * skyLight * 0.10);
    return color;
}

// clear^2, clear = 1 / (1 + ((depth - start) / distance)^2), with depth = 1 / gl_FragCoord.w along
// the view axis: rows of ground keep one colour, which costs nothing in a PNG.
float clearness() {
    float near = gl_FragCoord.w * fogDistance, past = max(1.0 - gl_FragCoord.w * fogStart, 0.0);
    float clear = near * near / (near * near + past * past);
    return clear * clear;
}
vec3 fogged(vec3 color) { return mix(fogColor, color, clearness()); }

#include "encode.glsl"
