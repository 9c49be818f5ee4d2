#version 330 core
// Blurs the image in a floor: the more, the higher the body is above the floor.
uniform sampler2D sharp;        // with the height as alpha (mirrored.glsl), and smaller levels
uniform vec2 perPixel;          // 1 / size
uniform float widest, level;    // pixels; the level whose pixels' mean height counts
layout(location = 0) out vec4 result;
void main() {
    vec2 at = gl_FragCoord.xy * perPixel;
    float width = max(widest * textureLod(sharp, at, level).a, 1.0);
    vec2 side = 0.5 * width * perPixel;
    float fine = log2(width);
    result = 0.25 * (textureLod(sharp, at + side, fine) + textureLod(sharp, at - side, fine) +
                     textureLod(sharp, at + vec2(side.x, -side.y), fine) +
                     textureLod(sharp, at + vec2(-side.x, side.y), fine));
}
