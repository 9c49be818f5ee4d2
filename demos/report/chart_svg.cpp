#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "demos/report/drawing.h"

namespace demos {
namespace {

/// SVG gives a font's em; DejaVu Sans is 1901 + 483 units from cap to descender, its em 2048.
constexpr float kEmShare = 2048.0f / 2384.0f;

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

/// `name="#rrggbb"`, and how much of it.
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
    // round caps make a dot of a line to itself
    if (line.points.size() == 1) path += "L" + path.substr(1);
    return fmt::format("<path d=\"{}\" {} stroke-width=\"{:.2f}\"/>\n", path,
                       paint("stroke", line.color), line.width);
}

std::string svgText(const Label& label) {
    constexpr const char* kAnchors[] = {"start", "middle", "end"};
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" "
        "text-anchor=\"{}\" {}>{}</text>\n",
        label.at.x, label.at.y, kEmShare * label.pixels, kAnchors[static_cast<int>(label.anchor)],
        paint("fill", label.color), escaped(label.text));
}

}  // namespace

std::string svgOf(const Drawing& drawing) {
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, sans-serif\">\n",
        drawing.size.width, drawing.size.height);
    for (const Rectangle& rectangle : drawing.rectangles) svg += svgText(rectangle);
    svg += "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    for (const Line& line : drawing.lines) svg += svgText(line);
    svg += "</g>\n";
    for (const Label& label : drawing.labels) svg += svgText(label);
    return svg + "</svg>\n";
}

std::string svgOf(const std::vector<Chart>& charts, PictureSize size, const std::string& theme,
                  float type) {
    return svgOf(drawingOf(charts, size, theme, type));
}

}  // namespace demos
