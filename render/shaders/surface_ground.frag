#version 330 core
uniform int surface;
out int result;
void main() { result = surface; }
