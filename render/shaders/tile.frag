#version 330 core
layout(location = 0) out vec4 result;
layout(location = 1) out int seen;
// An empty pixel.
void main() {
    result = vec4(0.0);
    seen = -1;
}
