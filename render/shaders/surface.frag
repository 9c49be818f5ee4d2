#version 330 core
flat in int surface;
out int result;
void main() { result = surface; }
