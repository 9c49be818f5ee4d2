// The sRGB curve. It is here and not in the framebuffer, because drivers' conversion differs from
// CPU to CPU. It uses square roots, which are exact everywhere and cheaper than a power, and is
// fitted to within 1.1 levels of 255, with white exact.
vec3 encode(vec3 color) {
    vec3 c = clamp(color, 0.0, 1.0), a = sqrt(c), b = sqrt(a);
    return a * (2.2554174 - 1.4178644 * b) + (0.4398030 * c - 0.2773560 * b);
}
