// Value noise: 0..1, smooth, from whole numbers only, so that every driver computes the same.
float value(uint mixed) {
    mixed ^= mixed >> 15, mixed *= 0x2c1b3c6du, mixed ^= mixed >> 12, mixed *= 0x297a2d39u;
    return float(mixed >> 8) / 16777216.0;
}
float noise(vec3 p) {
    vec3 cell = floor(p), f = p - cell;
    f = f * f * (3.0 - 2.0 * f);
    const uvec3 kMany = uvec3(0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du);
    uvec3 a = uvec3(ivec3(cell)) * kMany, b = a + kMany;
    vec4 low = vec4(value(a.x ^ a.y ^ a.z), value(b.x ^ a.y ^ a.z), value(a.x ^ b.y ^ a.z),
                    value(b.x ^ b.y ^ a.z));
    vec4 high = vec4(value(a.x ^ a.y ^ b.z), value(b.x ^ a.y ^ b.z), value(a.x ^ b.y ^ b.z),
                     value(b.x ^ b.y ^ b.z));
    vec4 level = mix(low, high, f.z);
    vec2 row = mix(level.xy, level.zw, f.y);
    return mix(row.x, row.y, f.x);
}
