#version 330 core
// How much of the sky a point sees, from the depths around it (McGuire et al. 2011, 'The alchemy
// screen-space ambient obscurance algorithm').
uniform sampler2D depthMap; // m, half size
uniform vec2 lens;          // tan of half the angles of view
uniform float farthest;     // m
uniform float reach;        // m
out float open;

const int kSamples = 8;
const float kTurns = 3.0;

vec3 eyePoint(ivec2 p, vec2 toNdc) {
    float d = texelFetch(depthMap, p, 0).r;
    return vec3(((vec2(p) + 0.5) * toNdc - 1.0) * lens * d, -d);
}

// The shorter of the two steps: the other one may lead off the surface.
vec3 slope(vec3 before, vec3 here, vec3 after) {
    vec3 a = here - before, b = after - here;
    return abs(a.z) < abs(b.z) ? a : b;
}

void main() {
    ivec2 size = textureSize(depthMap, 0);
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec2 toNdc = 2.0 / vec2(size);
    vec3 here = eyePoint(p, toNdc);
    float pixels = min(reach / -here.z / lens.y * 0.5, 0.12) * float(size.y);
    if (-here.z > 0.6 * farthest || pixels < 1.0) { open = 1.0; return; }
    ivec2 last = size - 1, x = ivec2(1, 0), y = ivec2(0, 1);
    vec3 dx = slope(eyePoint(max(p - x, 0), toNdc), here, eyePoint(min(p + x, last), toNdc));
    vec3 dy = slope(eyePoint(max(p - y, 0), toNdc), here, eyePoint(min(p + y, last), toNdc));
    vec3 normal = normalize(cross(dx, dy));
    // A pattern of 4 x 4 pixels, which the blur of the same size takes out again.
    ivec2 cell = p & 3;
    float start = float((cell.x * 4 + cell.y * 7 + (cell.x ^ cell.y) * 3) & 15) / 16.0;
    float sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        float t = (float(i) + 0.5) / float(kSamples);
        float angle = (t * kTurns + start) * 6.2831853;
        ivec2 s = clamp(p + ivec2(round(vec2(cos(angle), sin(angle)) * t * pixels)), ivec2(0), last);
        vec3 v = eyePoint(s, toNdc) - here;
        float square = dot(v, v);
        float fall = max(1.0 - square / (reach * reach), 0.0);
        sum += fall * fall * max(dot(v, normal) + 0.004 * here.z, 0.0) / (square + 0.004);
    }
    open = max(0.0, 1.0 - sum * 1.32 * reach / float(kSamples));
}
