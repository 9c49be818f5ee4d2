#include "demos/charts/drawing.h"

namespace demos {

render::Image imageOf(const Drawing& drawing) {
    render::Image image;
    image.width = drawing.size.width, image.height = drawing.size.height;
    image.pixels.resize(4 * static_cast<std::size_t>(image.width) * image.height);
    for (const Rectangle& r : drawing.rectangles)
        render::fillRectangle(image, r.corner, r.width, r.height, r.color);
    for (const Line& line : drawing.lines)
        render::drawPolyline(image, line.points, line.width, line.color);
    for (const Label& label : drawing.labels)
        render::drawLabel(image, label.text, label.at, label.anchor, label.pixels, label.color);
    return image;
}

render::Image imageOf(const std::vector<Chart>& charts, PictureSize size,
                      const std::string& theme, const Paper& paper) {
    return imageOf(drawingOf(charts, size, theme, paper));
}

}  // namespace demos
