uniform vec3 toSun;             // unit
#ifdef SHADOWS
uniform mat4 worldToShadow;     // to texels; z to 0..1
uniform float shadowTexel;      // m

// The point in the shadow map. It is moved along the normal by what the kernel's width needs at
// this slant: no shadow acne, no gap.
vec3 shadowPlace(vec3 world, vec3 normal) {
    float slant = 1.0 - max(dot(normal, toSun), 0.0);
    vec3 lifted = world + normal * shadowTexel * (1.0 + 2.6 * slant);
    return (worldToShadow * vec4(lifted, 1.0)).xyz;
}
#else
vec3 shadowPlace(vec3 world, vec3 normal) { return vec3(0.0); }
#endif
