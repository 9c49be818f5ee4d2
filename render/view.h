/// The camera in numbers: what turns metres into pixels.
#pragma once
#include "render/frame.h"

namespace render {

using Mat4 = Eigen::Matrix4f;

/// Where a point lands: pixels from the lower left corner, depth -1..1 as GL has it.
struct Projected {
    float x = 0, y = 0, z = 0;
    float distance = 0;  // m along the view direction; <= near: not in front of the camera
};

struct View {
    int width = 0, height = 0;  // pixels
    Vec3 eye, right, up, forward;
    float focus = 1;        // m, from the eye to the point looked at: the scene's scale
    float near = 0.1f;      // m
    float far = 1000;       // m
    float tanHalf = 0.3f;   // of half the vertical angle
    Mat4 worldToClip = Mat4::Identity();

    float aspect() const { return static_cast<float>(width) / static_cast<float>(height); }
    float pixelsPerMetre(float distance) const {
        return 0.5f * static_cast<float>(height) / (tanHalf * distance);
    }
    /// Lengths given for a picture 720 pixels high, in this picture's pixels.
    float scale() const { return static_cast<float>(height) / 720.0f; }
    Projected project(const Vec3& point) const;
};

/// Throws Error when the camera looks nowhere (a value not finite, eye = target, angle not in 1..170).
View makeView(const Camera& camera, int width, int height);

}  // namespace render
