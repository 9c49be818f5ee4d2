// The image of bodies in a floor. It is in no fog: the floor that shows it is.
#ifdef MIRRORED
uniform vec3 floorNormal, plainFloor;   // what leaves the floor where it shows no body, linear
uniform float floorOffset;              // m
uniform float perFade;                  // 1 / m

// Fades with the height, which becomes the alpha, 0..1.
vec4 seenInFloor(vec3 color, vec3 world) {
    float height = max(dot(floorNormal, world) - floorOffset, 0.0) * perFade;
    float near = 1.0 / (1.0 + height);
    return vec4(sqrt(mix(plainFloor, clamp(color, 0.0, 1.0), near * near)), 1.0 - near);
}
#endif
