layout(location = 8) in float number;
layout(location = 9) in float face;

// As in a SurfaceMap.
int packedSurface() { return 4096 * int(number) + int(face); }
