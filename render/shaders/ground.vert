#version 330 core
uniform mat4 worldToClip;
uniform vec3 origin, across, along;   // m, a corner's way from the middle
out vec3 world;
out vec2 grid;                        // m, on the plane
void main() {
    vec2 corner = vec2(gl_VertexID == 1 || gl_VertexID == 2 || gl_VertexID == 4 ? 1.0 : -1.0,
                       gl_VertexID == 2 || gl_VertexID == 4 || gl_VertexID == 5 ? 1.0 : -1.0);
    world = origin + corner.x * across + corner.y * along;
    grid = vec2(dot(world, normalize(across)), dot(world, normalize(along)));
    gl_Position = worldToClip * vec4(world, 1.0);
}
