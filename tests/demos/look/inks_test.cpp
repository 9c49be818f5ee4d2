#include "demos/look/inks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "demos/look/theme.h"

namespace demos {
namespace {

TEST(Inks, LinesAndLabelsStandOutOnEveryTheme) {
    for (const std::string& theme : themeNames()) {
        const Inks inks = inksOf(theme);
        for (int i = 0; i < 12; ++i) {
            EXPECT_GE(contrast(lineColor(i, inks), inks.ground), 3.0) << theme << i;
            EXPECT_GE(contrast(labelColor(i, inks), inks.ground), 4.5) << theme << i;
        }
        EXPECT_GE(contrast(inks.muted, inks.ground), 4.5) << theme;
    }
}

using Matrix = double[3][3];

/// CIE L*a*b* of a colour as seen by an eye with this matrix; matrices for linear light.
std::array<double, 3> seenAs(const Matrix& m, const render::Color& color) {
    const auto linear = [](float channel) {
        const double c = static_cast<double>(channel);
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    const double rgb[3] = {linear(color.r), linear(color.g), linear(color.b)};
    double seen[3] = {};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) seen[i] += m[i][k] * rgb[k];
    const auto part = [&](double r, double g, double b, double white) {
        return std::cbrt(std::max((r * seen[0] + g * seen[1] + b * seen[2]) / white, 0.01));
    };
    const double x = part(0.4124, 0.3576, 0.1805, 0.95047);
    const double y = part(0.2126, 0.7152, 0.0722, 1.0), z = part(0.0193, 0.1192, 0.9505, 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Machado, Oliveira, Fernandes 2009, table 1, severity 1: protanopia, deuteranopia
constexpr Matrix kEyes[] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                            {{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}},
                            {{0.367322, 0.860646, -0.227968},
                             {0.280085, 0.672501, 0.047413},
                             {-0.011820, 0.042940, 0.968881}}};

TEST(Inks, SixLinesStayApartForColourBlindEyes) {
    for (const std::string& theme : themeNames())
        for (const Matrix& eye : kEyes)
            for (int i = 0; i < 6; ++i)
                for (int k = 0; k < i; ++k) {
                    const auto a = seenAs(eye, lineColor(i, inksOf(theme)));
                    const auto b = seenAs(eye, lineColor(k, inksOf(theme)));
                    // 2.3 is just noticeable side by side; a thin line needs more
                    EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 12.0)
                        << theme << ": " << k << " and " << i;
                }
}

}  // namespace
}  // namespace demos
