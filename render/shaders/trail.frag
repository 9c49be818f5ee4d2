#version 330 core
in vec4 tint;
noperspective in vec2 place;   // pixels: from the trail's middle, and half its width
out vec4 result;
// Coverage: the overlap of trail and pixel.
void main() {
    float both = min(place.x + 0.5, place.y) - max(place.x - 0.5, -place.y);
    result = vec4(tint.rgb, tint.a * clamp(both, 0.0, 1.0));
}
