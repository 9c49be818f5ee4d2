#version 330 core
#include "light.glsl"
in vec3 world;
in vec2 grid;
uniform vec3 normal;
uniform vec3 groundColor, lineColor;  // linear
uniform float lineStrength;
uniform float cell;                   // m between thin lines; five of them make a strong one
out vec4 result;

// Coverage of lines of a width in pixels, every `spacing` metres; grey where they get too dense.
float lines(vec2 p, float spacing, float width) {
    vec2 t = p / spacing;
    vec2 pixel = fwidth(t);
    vec2 away = abs(fract(t - 0.5) - 0.5) / max(pixel, vec2(1e-6));
    vec2 cover = clamp(width * 0.5 + 0.5 - away, 0.0, 1.0) * clamp(1.6 - 20.0 * pixel, 0.0, 1.0);
    return max(cover.x, cover.y);
}

#ifdef SHADOW_CATCHER
// Black, as much of it as light is missing: over any background it looks like the shadow.
void main() {
    float here = dot(lit(vec3(1.0), world, normal, 0.0), vec3(1.0));
    float free = dot(skyLight * (0.5 + 0.5 * normal.y) + groundLight * (0.5 - 0.5 * normal.y) +
                     sunLight * max(dot(normal, toSun), 0.0), vec3(1.0));
    result = vec4(0.0, 0.0, 0.0, 1.0 - encode(vec3(clamp(here / free, 0.0, 1.0))).r);
}
#else
void main() {
    float thin = lines(grid, cell, 1.1 * lineStrength);
    float strong = lines(grid, 5.0 * cell, 2.4 * lineStrength);
    vec3 color = mix(groundColor, lineColor, max(0.22 * thin, 0.62 * strong));
    result = vec4(encode(fogged(lit(color, world, normal, 0.0))), 1.0);
}
#endif
