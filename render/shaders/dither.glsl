// Noise of one level of 255, so that smooth gradients have no bands. It is the same in every frame.
// Source: J. Jimenez, Next generation post processing in Call of Duty: Advanced Warfare, 2014.
vec3 dithered(vec3 color) {
#ifdef DITHERED
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    color += (noise - 0.5) / 255.0;
#endif
    return color;
}
