// Light and ground as in the film's renderer (render/shaders), without its occlusion. Not shared:
// GLSL ES 3.00 has neither #include nor the samples of a pixel that those shaders use, so that little
// more than declarations would be common.

const kPlaced = `#version 300 es
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 edges;
layout(location = 3) in vec3 place;
layout(location = 4) in vec4 turn;
layout(location = 5) in vec3 scale;
layout(location = 6) in vec4 color;
layout(location = 7) in vec2 material;  // roughness, metallic
uniform mat4 worldToClip;
out vec3 world, worldNormal;
out vec4 edge;
flat out vec4 tint;
flat out vec2 surface;
vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }
void main() {
  world = place + turned(position * scale);
  worldNormal = turned(normal);
  edge = edges;
  tint = color;
  surface = material;
  gl_Position = worldToClip * vec4(world, 1.0);
}`;

const kDark = `#version 300 es
precision highp float;
void main() {}`;

const kFlat = `#version 300 es
precision highp float;
flat in vec4 tint;
uniform float strength;
out vec4 result;
void main() { result = vec4(tint.rgb, tint.a * strength); }`;

const kLight = `#version 300 es
precision highp float;
precision highp sampler2DShadow;
uniform vec3 eye, toSun, fogColor;
uniform vec3 skyLight, groundLight, sunLight;
uniform float fogStart, fogDistance;  // m
uniform mat4 worldToShadow;
uniform float shadowTexel;            // m
uniform sampler2DShadow shadowMap;
out vec4 result;

// Moved out along the normal by what the kernel hides at this slant.
float sunlit(vec3 world, vec3 normal) {
  float slant = 1.0 - max(dot(normal, toSun), 0.0);
  vec3 p = (worldToShadow * vec4(world + normal * shadowTexel * (1.0 + 2.0 * slant), 1.0)).xyz;
  if (any(greaterThan(abs(p - 0.5), vec3(0.499)))) return 1.0;
  float texel = 1.0 / float(textureSize(shadowMap, 0).x), sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) sum += texture(shadowMap, vec3(p.xy + texel * vec2(x, y), p.z));
  return sum / 9.0;
}
vec3 ambient(vec3 normal) { return mix(groundLight, skyLight, 0.5 + 0.5 * normal.y); }
vec3 encode(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
// clear^2, clear = 1 / (1 + ((depth - start) / distance)^2)
vec3 fogged(vec3 color) {
  float near = gl_FragCoord.w * fogDistance, past = max(1.0 - gl_FragCoord.w * fogStart, 0.0);
  float clear = near * near / (near * near + past * past);
  return mix(fogColor, color, clear * clear);
}`;

const kSolid = `${kLight}
in vec3 world, worldNormal;
in vec4 edge;
flat in vec4 tint;
flat in vec2 surface;        // roughness, metallic
uniform float thinnest;      // m, of the solid
uniform float lineWidth, lineStrength;  // pixels; 0..1
uniform float chosen;        // 0..1

// The way to the nearest edge on the surface: minus the gradient of its distance.
vec3 outward(float distance, vec3 normal) {
  vec3 dx = dFdx(world), dy = dFdy(world), u = cross(dy, normal), v = cross(normal, dx);
  float area = dot(dx, u);
  return abs(area) < 1e-14 ? vec3(0.0) : -(dFdx(distance) * u + dFdy(distance) * v) / area;
}
// What a mirror shows of the studio.
vec3 room(vec3 ray) {
  vec3 above = skyLight * mix(2.1, 0.9, smoothstep(0.0, 0.7, ray.y));
  vec3 below = groundLight * mix(0.9, 0.45, smoothstep(0.0, 0.9, -ray.y));
  return mix(below, above, smoothstep(-0.3, 0.2, ray.y)) + 1.2 * smoothstep(0.86, 0.97, dot(ray, toSun)) * sunLight;
}
void main() {
  vec3 normal = normalize(worldNormal), color = tint.rgb;
  vec4 pixel = fwidth(edge) + 1e-6, pixels = edge / pixel;
  float nearest = min(min(edge.x, edge.y), min(edge.z, edge.w));
  float line = 1.0 - smoothstep(lineWidth - 0.7, lineWidth + 0.7, min(min(pixels.x, pixels.y), min(pixels.z, pixels.w)));
  vec3 pace = fwidth(world);
  line *= smoothstep(2.0, 7.0, thinnest / (length(pace) + 1e-9));
  vec3 lean = outward(nearest, normal) * (1.0 - smoothstep(0.0, 0.045 * thinnest + 0.004, nearest));
  color *= 1.0 - lineStrength * line;
  normal = normalize(normal + 0.55 * clamp(lean, -1.0, 1.0));
  float sun = max(dot(normal, toSun), 0.0) * sunlit(world, normalize(worldNormal));
  vec3 lit = color * (ambient(normal) + sunLight * sun), toEye = normalize(eye - world);
  float polish = 1.0 - surface.x, sharp = exp2(2.0 + 8.0 * polish);
  float gloss = pow(max(dot(normal, normalize(toEye + toSun)), 0.0), sharp) * min(8.0 * sun, 1.0);
  float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 4.0);
  lit += polish * (gloss * sunLight * 0.47 + rim * skyLight * 0.14);
  vec3 metal = 0.22 * lit + color * (0.85 * room(reflect(-toEye, normal)) + 0.5 * gloss * sunLight);
  lit = mix(lit, metal, surface.y);
  result = vec4(encode(fogged(mix(lit, lit * 1.25 + 0.06, chosen))), tint.a);
}`;

const kGroundPlace = `#version 300 es
precision highp float;
uniform mat4 worldToClip;
uniform vec3 middle, across, along;  // m
uniform float reach;                 // m
out vec3 world;
out vec2 grid;
void main() {
  vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
  world = middle + reach * (corner.x * across + corner.y * along);
  grid = vec2(dot(world, across), dot(world, along));
  gl_Position = worldToClip * vec4(world, 1.0);
}`;

const kGround = `${kLight}
in vec3 world;
in vec2 grid;                         // m
uniform vec3 normal, groundColor, lineColor;
uniform float perCell, lineStrength;  // 1 / m between thin lines; five of them make a strong one
uniform vec2 subject;                 // m, on the plane: the grid fades away from it
uniform float perReach;               // 1 / m

float lines() {
  vec2 at = grid * perCell, number = floor(at + 0.5), pixel = max(fwidth(at), vec2(1e-6));
  vec2 strong = step(abs(number * 0.2 - floor(number * 0.2 + 0.5)), vec2(0.1));
  vec2 width = mix(vec2(1.1), vec2(2.4), strong) * lineStrength;
  vec2 cover = clamp(width * 0.5 + 0.5 - abs(at - number) / pixel, 0.0, 1.0);
  cover *= clamp(1.6 - mix(vec2(20.0), vec2(4.0), strong) * pixel, 0.0, 1.0) * mix(vec2(0.22), vec2(0.62), strong);
  vec2 away = (grid - subject) * perReach;
  float near = 1.0 / (1.0 + dot(away, away));
  return max(cover.x, cover.y) * near * near;
}
void main() {
  vec3 light = ambient(normal) + sunLight * max(dot(normal, toSun), 0.0) * sunlit(world, normal);
  result = vec4(encode(fogged(mix(groundColor, lineColor, lines()) * light)), 1.0);
}`;

const kSkyPlace = `#version 300 es
precision highp float;
uniform vec3 forward, right, upward;  // a ray is as long as 1 along the view axis
out float up;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  up = forward.y + corner.x * right.y + corner.y * upward.y;
  gl_Position = vec4(corner, 1.0, 1.0);
}`;

const kSky = `#version 300 es
precision highp float;
in float up;
uniform vec3 fog, horizon, top;  // sRGB
out vec4 result;
void main() {
  vec3 color = mix(fog, horizon, smoothstep(0.0, 0.07, up));
  result = vec4(mix(color, top, smoothstep(0.05, 0.5, up)), 1.0);
}`;
