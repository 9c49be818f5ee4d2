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

// The light that reaches a point of a body.
struct Light {
    float sees;  // 0..1, of the sky
    float sun;   // times sunLight
};
Light lightAt(vec3 world, vec3 normal) {
    float sees = open();
    return Light(sees, max(dot(normal, toSun), 0.0) * sunShare(shadowPlace(world, normal), sees));
}
vec3 matt(vec3 albedo, vec3 normal, Light light) {
    return albedo * (ambient(normal) * light.sees + sunLight * light.sun);
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
