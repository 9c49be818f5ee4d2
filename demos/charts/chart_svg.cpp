#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/charts/drawing.h"
#include "demos/look/type.h"

namespace demos {
namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&apos;";
                break;
            default:
                result += c;
        }
    return result;
}

std::string colorText(const render::Color& color) {
    const auto byte = [](float channel) {
        return static_cast<int>(std::lround(255.0f * std::clamp(channel, 0.0f, 1.0f)));
    };
    return fmt::format("#{:02x}{:02x}{:02x}", byte(color.r), byte(color.g), byte(color.b));
}

/// `name="#rrggbb"`, and its opacity.
std::string paint(const char* name, const render::Color& color) {
    const std::string text = fmt::format("{}=\"{}\"", name, colorText(color));
    return color.a < 1.0f ? fmt::format("{} {}-opacity=\"{:.2f}\"", text, name, color.a) : text;
}

std::string svgText(const Rectangle& r) {
    return fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" {}/>\n",
                       r.corner.x, r.corner.y, r.width, r.height, paint("fill", r.color));
}

std::string svgText(const Line& line) {
    std::string path;
    for (const render::Point& p : line.points)
        path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? 'M' : 'L', p.x, p.y);
    // with round caps a line to itself is a dot
    if (line.points.size() == 1) path += "L" + path.substr(1);
    return fmt::format("<path d=\"{}\" {} stroke-width=\"{:.2f}\"/>\n", path,
                       paint("stroke", line.color), line.width);
}

/// Pixels of the font's em. Letters have whole pixels in a picture and whole points on paper.
double emOf(const Label& label, double pixelsPerPoint) {
    const double em = kEmShare * static_cast<double>(label.pixels);
    return pixelsPerPoint > 0.0 ? std::round(em / pixelsPerPoint) * pixelsPerPoint : em;
}

std::string svgText(const Label& label, double pixelsPerPoint) {
    constexpr const char* kAnchors[] = {"start", "middle", "end"};
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" "
        "text-anchor=\"{}\" {}>{}</text>\n",
        label.at.x, label.at.y, emOf(label, pixelsPerPoint),
        kAnchors[static_cast<int>(label.anchor)], paint("fill", label.color), escaped(label.text));
}

/// The size; on paper in mm, while coordinates stay pixels.
std::string sizeText(const Drawing& drawing) {
    const auto [width, height] = drawing.size;
    if (!(drawing.millimetres > 0.0))
        return fmt::format("width=\"{}\" height=\"{}\"", width, height);
    return fmt::format("width=\"{:g}mm\" height=\"{:.3f}mm\"", drawing.millimetres,
                       drawing.millimetres * height / width);
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" {} "
        "viewBox=\"0 0 {} {}\" font-family=\"Inter, DejaVu Sans, sans-serif\">\n",
        sizeText(drawing), drawing.size.width, drawing.size.height);
    for (const Rectangle& rectangle : drawing.rectangles) svg += svgText(rectangle);
    svg += "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    for (const Line& line : drawing.lines) svg += svgText(line);
    svg += "</g>\n";
    for (const Label& label : drawing.labels) svg += svgText(label, drawing.pixelsPerPoint);
    return svg + "</svg>\n";
}

std::string svgOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                  const Paper& paper) {
    return svgOf(drawingOf(charts, size, theme, paper));
}

}  // namespace demos
