layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in float vertexEnd;
layout(location = 3) in vec3 position;
layout(location = 4) in vec4 rotation;
layout(location = 5) in vec3 scale;
layout(location = 6) in float stretch;
layout(location = 7) in vec3 color;

vec3 turn(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

vec3 localPoint() { return vertexPosition * scale + vec3(0.0, vertexEnd * stretch, 0.0); }
vec3 worldPoint() { return position + turn(rotation, localPoint()); }

#ifdef PATTERN
out vec3 inBody;  // m, y along the longest axis
void setPattern() {
    vec3 size = scale + vec3(0.0, stretch, 0.0), p = localPoint();
    bool x = size.x > size.y && size.x >= size.z, z = size.z > size.y && !x;
    inBody = x ? p.yxz : z ? p.xzy : p;
}
#else
void setPattern() {}
#endif
