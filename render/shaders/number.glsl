layout(location = 8) in float number;

// As packed in a SurfaceMap: 8 * its number + face.
int packedSurface(int face) { return 8 * int(number) + face; }

// 0..5: -x +x -y +y -z +z
int faceOf(vec3 n) {
    vec3 size = abs(n);
    int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    return 2 * axis + (n[axis] > 0.0 ? 1 : 0);
}
