/// Places for names over a picture: none covers another one, or a text or plate in a corner.
#pragma once
#include <vector>

#include "render/camera.h"
#include "render/corners.h"
#include "render/frame.h"
#include "render/image.h"

namespace render {

class LabelPlaces {
public:
    /// All arguments except `image` and `corners` are needed only now.
    LabelPlaces(const Image& image, const Frame& frame, const View& view,
                const CornerLayout& corners);

    /// Takes the box where it is, or its height above or below if that is at most `most` pixels
    /// away; entirely within the picture. False if there is no room.
    bool takeOver(Box& box, float most);

    /// Takes a place near the box's middle, away from it, where it covers no arrow, marker or line
    /// either. False if there is none.
    bool takeBeside(Box& box);

    /// Takes a place to the left or right of the rectangle around `points` (m), else above or below, at
    /// the height of the box or near it, where it covers no mark. False if there is none.
    bool takeOutside(Box& box, const std::vector<Vec3>& points, const View& view);

private:
    struct Stroke {
        Eigen::Vector2f from, to;  // pixels
        float half;                // pixels, half of its width
    };
    bool isFree(const Box& box) const;
    bool coversMarks(const Box& box) const;
    bool takeNear(Box& box, const Eigen::Vector2f& corner, const Eigen::Vector2f& way);
    void addStroke(const View& view, const Vec3& from, const Vec3& to, float half);

    const Image& image_;
    const CornerLayout& corners_;
    std::vector<Box> taken_;
    std::vector<Stroke> strokes_;
};

}  // namespace render
