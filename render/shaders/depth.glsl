uniform vec2 clipPlanes;    // m, nearest and farthest

// m along the view axis, from what is in the depth buffer
float eyeDepth(float stored) {
    float z = stored * 2.0 - 1.0;
    return 2.0 * clipPlanes.x * clipPlanes.y /
           (clipPlanes.y + clipPlanes.x - z * (clipPlanes.y - clipPlanes.x));
}
