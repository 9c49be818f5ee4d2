#include "render/plate.h"

#include <algorithm>
#include <cmath>

#include "render/canvas.h"
#include "render/coverage.h"
#include "render/overlay.h"

namespace render {
namespace {

constexpr float kShortArrow = 1.8f;  // in heights of the text

float widthOf(const std::string& text, const PlateMetrics& m,
              Figures figures = Figures::proportional) {
    return text.empty() ? 0.0f : textWidth(text, static_cast<float>(m.pixels), figures);
}

float arrowLength(const PlateRow& row, int pixels, float pixelsPerMeter) {
    return row.meters > 0.0f ? row.meters * pixelsPerMeter
                             : kShortArrow * static_cast<float>(pixels);
}

/// Height of a row's bar or scale, in addition to its text.
float extraOf(const PlateRow& row, const PlateMetrics& m) {
    return (row.bar.empty() ? 0.0f : m.bar + 0.4f * m.gap) +
           (row.ramp.empty() ? 0.0f : 1.6f * m.bar);
}

void drawSwatch(Image& image, const PlateRow& row, float left, float middle, const PlateMetrics& m,
                const Look& look, float pixelsPerMeter) {
    const float size = static_cast<float>(m.pixels);
    const Vec2 centre(left + 0.5f * m.swatch, middle);
    switch (row.swatch) {
        case Swatch::none:
            return;
        case Swatch::dot: {
            const Vec2 reach(0.3f * size, 0.3f * size);
            return fill(image, centre - reach, centre + reach, {row.color, {1, 1, 1, 0.8f}, 1.0f},
                        [&](const Vec2& q) { return (q - centre).norm() - 0.26f * size; });
        }
        case Swatch::quartered: {
            // A disc of ink, and two white quarters.
            const Vec2 reach(0.4f * size, 0.4f * size);
            fill(image, centre - reach, centre + reach, {row.color, {}, 0.0f},
                 [&](const Vec2& q) { return (q - centre).norm() - 0.4f * size; });
            return fill(image, centre - reach, centre + reach, {{1, 1, 1, 1}, {}, 0.0f},
                        [&](const Vec2& q) {
                            const Vec2 d = q - centre;
                            const float away = std::min(std::abs(d.x()), std::abs(d.y()));
                            return std::max(d.norm() - 0.32f * size,
                                            d.x() * d.y() < 0.0f ? away : -away);
                        });
        }
        case Swatch::arrow: {
            const float half = 0.5f * arrowLength(row, m.pixels, pixelsPerMeter);
            return drawFlatArrow(image, centre - Vec2(half, 0), centre + Vec2(half, 0), row.color,
                                 look);
        }
        case Swatch::line:
            return fillRectangle(image, {centre.x() - 0.5f * size, centre.y() - 0.06f * size}, size,
                                 0.12f * size, row.color);
    }
}

void drawBar(Image& image, const PlateRow& row, float x, float y, float width,
             const PlateMetrics& m, const Look& look) {
    Color trough = look.ink;
    trough.a = 0.14f;
    fillRectangle(image, {x, y}, width, m.bar, trough);
    for (const BarPart& part : row.bar) {
        const float length = std::clamp(part.share, 0.0f, 1.0f) * width;
        fillRectangle(image, {x, y}, length, m.bar, part.color);
        x += length;
    }
}

Color mixed(const std::vector<Color>& ramp, float share) {
    const float at = share * static_cast<float>(ramp.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), ramp.size() - 1);
    const Color &a = ramp[i], &b = ramp[std::min(i + 1, ramp.size() - 1)];
    const float t = at - static_cast<float>(i);
    return {a.r + t * (b.r - a.r), a.g + t * (b.g - a.g), a.b + t * (b.b - a.b), 1.0f};
}

void drawRamp(Image& image, const PlateRow& row, float x, float y, float width,
              const PlateMetrics& m) {
    const int columns = std::max(static_cast<int>(width), 2);
    for (int i = 0; i < columns; ++i)
        fillRectangle(image, {x + static_cast<float>(i), y}, 1.0f, 1.2f * m.bar,
                      mixed(row.ramp, static_cast<float>(i) / static_cast<float>(columns - 1)));
}

}  // namespace

PlateMetrics metricsOf(const Plate& plate, int pixels, float pixelsPerMeter) {
    PlateMetrics m;
    m.pixels = pixels;
    const float size = static_cast<float>(pixels);
    m.pad = std::round(0.65f * size);
    m.row = std::round((pixels > 12 ? 1.3f : 1.15f) * size);  // tighter rows in small pictures
    m.bar = std::max(std::round(0.5f * size), 4.0f);
    m.gap = size;
    for (const PlateRow& row : plate.rows)
        if (row.swatch == Swatch::arrow)
            m.swatch = std::max(m.swatch, arrowLength(row, pixels, pixelsPerMeter));
        else if (row.swatch != Swatch::none)
            m.swatch = std::max(m.swatch, size);
    float names = 0.0f, values = 0.0f, extra = 0.0f;
    for (const PlateRow& row : plate.rows) {
        const float before = row.swatch == Swatch::none ? 0.0f : m.swatch + 0.6f * m.gap;
        names = std::max(names, before + widthOf(row.name, m));
        values = std::max(values, widthOf(row.value, m, Figures::tabular));
        extra += extraOf(row, m);
    }
    m.width = 2.0f * m.pad + names + (values > 0.0f ? 1.2f * m.gap + values : 0.0f);
    m.height = 2.0f * m.pad + m.row * static_cast<float>(plate.rows.size()) + extra;
    return m;
}

void drawPlate(Image& image, const PlacedPlate& placed, const Look& look, float pixelsPerMeter) {
    const PlateMetrics& m = placed.metrics;
    const Box& box = placed.box;
    const Vec2 low(box.x, box.y), high(box.x + box.width, box.y + box.height);
    fill(image, low, high, {look.plate, {}, 0.0f},
         [&](const Vec2& q) { return toRoundedBox(q, low, high, 0.6f * m.pad); });
    const float left = box.x + m.pad, right = box.x + box.width - m.pad;
    const float names = left + m.swatch + 0.6f * m.gap;
    const float ascent = textAscent(m.pixels), size = static_cast<float>(m.pixels);
    float y = box.y + m.pad;
    for (const PlateRow& row : placed.plate->rows) {
        if (!row.ramp.empty()) {
            drawRamp(image, row, left, y, right - left, m);
            y += 1.6f * m.bar;
        }
        const float base = std::round(y + 0.5f * (m.row - size) + ascent);
        drawSwatch(image, row, left, y + 0.5f * m.row, m, look, pixelsPerMeter);
        drawLabel(image, row.name, {row.swatch == Swatch::none ? left : names, base}, Anchor::start,
                  size, look.ink);
        drawLabel(image, row.value, {right, base}, Anchor::end, size, look.ink,
                  Figures::tabular);
        y += m.row;
        if (row.bar.empty()) continue;
        drawBar(image, row, left, y, right - left, m, look);
        y += extraOf(row, m);
    }
}

}  // namespace render
