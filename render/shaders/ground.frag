#version 330 core
#include "light.glsl"
in vec3 world;
in vec2 grid;
uniform vec3 normal;
uniform vec3 groundColor, lineColor;  // linear
uniform vec3 ambientLight, fullSun;   // on a plane that sees all of them, linear
uniform float lineStrength;
uniform float perCell;                // 1 / m between thin lines; five of them make a strong one
out vec4 result;

// Coverage of lines of a width in pixels at whole numbers; grey where they get too dense.
float lines(vec2 place, vec2 pixel, float width) {
    vec2 away = abs(fract(place - 0.5) - 0.5) / max(pixel, vec2(1e-6));
    vec2 cover = clamp(width * 0.5 + 0.5 - away, 0.0, 1.0) * clamp(1.6 - 20.0 * pixel, 0.0, 1.0);
    return max(cover.x, cover.y);
}

vec3 light() {
    float sees = open();
    return ambientLight * sees + fullSun * sunShare(world, normal, sees);
}

#ifdef SHADOW_CATCHER
// Black, as much of it as light is missing: over any background it looks like the shadow.
void main() {
    float share = dot(light(), vec3(1.0)) / dot(ambientLight + fullSun, vec3(1.0));
    result = vec4(0.0, 0.0, 0.0, 1.0 - encode(vec3(clamp(share, 0.0, 1.0))).r);
}
#else
void main() {
    vec2 pixel = fwidth(grid);
    float thin = lines(grid * perCell, pixel * perCell, 1.1 * lineStrength);
    float strong = lines(grid * (0.2 * perCell), pixel * (0.2 * perCell), 2.4 * lineStrength);
    vec3 color = mix(groundColor, lineColor, max(0.22 * thin, 0.62 * strong));
    result = vec4(encode(fogged(color * light())), 1.0);
}
#endif
