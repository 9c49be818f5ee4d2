/// Matrices of a camera, and the projection from the world to the picture.
#pragma once
#include "render/frame.h"

namespace render {

/// The matrices and clip planes of a camera.
struct View {
    Eigen::Matrix4f view;        // world to eye: x right, y up, z towards the viewer
    Eigen::Matrix4f projection;  // eye to clip
    Vec3 eye;                    // m, world
    float nearest, farthest;     // m, the clip planes

    Eigen::Matrix4f worldToClip() const { return projection * view; }  // both transforms
};

/// Pixels per metre at a distance of 1 m from the eye.
inline float pixelsAMeter(const View& view, int height) {
    return 0.5f * static_cast<float>(height) * view.projection(1, 1);
}

/// `aspect`: width over height.
View makeView(const Camera& camera, float aspect);
/// The same with the near plane in front of the visible grounds, up to 40 times nearer: a low camera's would cut them.
View frameView(const Frame& frame, float aspect);

/// Pictures are drawn upside down, so that the first row read back is the top one.
inline View upsideDown(View view) {
    view.projection.row(1) *= -1.0f;
    return view;
}

/// Pixels from the top left corner, and the distance along the view axis (m; <= 0: behind).
struct Projected {
    float x = 0, y = 0, depth = 0;  // pixels, pixels, m
};
/// Projects a point of the world (m) into a picture of this size.
Projected project(const View& view, const Vec3& world, int width, int height);

/// World to eye; `up` must not be parallel to the view direction.
Eigen::Matrix4f lookAt(const Vec3& eye, const Vec3& target, const Vec3& up);

/// m between two thin lines of the ground's grid; every fifth line is a strong one.
float gridCell(const Camera& camera);

}  // namespace render
