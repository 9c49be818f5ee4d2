/// The texts of a drawn chart, and the boxes they occupy.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "demos/charts/drawing.h"
#include "render/overlay.h"

namespace demos {

inline bool says(const Drawing& drawing, const std::string& text) {
    return std::any_of(drawing.labels.begin(), drawing.labels.end(),
                       [&](const Label& label) { return label.text == text; });
}

struct Box {
    float left, right, top, bottom;  // pixels
    bool overlaps(const Box& o) const {
        return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
    }
};

/// The box of the letters, ascent and descent; a line's whole height also includes accents.
inline Box boxOf(const Label& label) {
    const float width = render::textWidth(label.text, label.pixels);
    const float left = label.at.x - (label.anchor == render::Anchor::start ? 0.0f
                                     : label.anchor == render::Anchor::end ? width
                                                                           : 0.5f * width);
    return {left, left + width, label.at.y - 0.65f * label.pixels,
            label.at.y + 0.2f * label.pixels};
}

/// No label overlaps another one or leaves the page. `what`: added to the message.
inline void expectApart(const Drawing& drawing, const std::string& what) {
    for (std::size_t i = 0; i < drawing.labels.size(); ++i) {
        const Box a = boxOf(drawing.labels[i]);
        const std::string& text = drawing.labels[i].text;
        EXPECT_GE(a.left, 0.0f) << text << what;
        EXPECT_GE(a.top, 0.0f) << text << what;
        EXPECT_LE(a.right, static_cast<float>(drawing.size.width)) << text << what;
        EXPECT_LE(a.bottom, static_cast<float>(drawing.size.height)) << text << what;
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_FALSE(a.overlaps(boxOf(drawing.labels[k])))
                << text << " over " << drawing.labels[k].text << what;
    }
}

}  // namespace demos
