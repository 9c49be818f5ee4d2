// The sRGB curve, here and not in the framebuffer: drivers' own differ from CPU to CPU. From square
// roots, which are exact everywhere and cheaper than a power (fit by I. Chilliant, good to a level).
vec3 encode(vec3 c) {
    vec3 a = sqrt(clamp(c, 0.0, 1.0)), b = sqrt(a), d = sqrt(b);
    return clamp(0.585122381 * a + 0.783140355 * b - 0.368262736 * d, 0.0, 1.0);
}
