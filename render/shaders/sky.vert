#version 330 core
uniform mat4 clipToWorld;
uniform vec3 eye;
out vec3 ray;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 far = clipToWorld * vec4(corner, 1.0, 1.0);
    ray = far.xyz / far.w - eye;
    gl_Position = vec4(corner, 1.0, 1.0);
}
