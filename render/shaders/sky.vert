#version 330 core
uniform mat4 clipToWorld;
uniform vec3 eye;
uniform vec3 forward;   // unit, the view axis
out float up;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 far = clipToWorld * vec4(corner, 1.0, 1.0);
    vec3 ray = far.xyz / far.w - eye;
    up = ray.y / dot(ray, forward);
    gl_Position = vec4(corner, 1.0, 1.0);
}
