#include "render/difference.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace render {
namespace {

constexpr int kWindow = 16;  // pixels per side
constexpr int kBlock = 8;    // pixels per side

int pixelDifference(const std::uint8_t* a, const std::uint8_t* b) {
    int largest = 0;
    for (int channel = 0; channel < 4; ++channel) {
        largest = std::max(largest, std::abs(a[channel] - b[channel]));
    }
    return largest;
}

/// sum(x, y): of counts or differences left of column x and above row y, so that any window costs
/// four lookups.
struct SummedArea {
    int columns = 0;
    std::vector<int> sums;

    SummedArea(int width, int height)
        : columns(width + 1), sums(static_cast<std::size_t>(width + 1) * (height + 1)) {}
    int& at(int x, int y) { return sums[static_cast<std::size_t>(y) * columns + x]; }
    int inside(int x, int y, int width, int height) {
        return at(x + width, y + height) - at(x, y + height) - at(x + width, y) + at(x, y);
    }
};

SummedArea countPixels(const Image& a, const Image& b, int levels, Difference& result) {
    SummedArea area(a.width, a.height);
    for (int y = 0; y < a.height; ++y) {
        int countedInRow = 0;
        for (int x = 0; x < a.width; ++x) {
            const int difference = pixelDifference(a.at(x, y), b.at(x, y));
            if (difference > 0) ++result.differing;
            if (difference > levels) ++countedInRow;
            result.largest = std::max(result.largest, difference);
            area.at(x + 1, y + 1) = area.at(x + 1, y) + countedInRow;
        }
    }
    return area;
}

/// A picture smaller than the window is one window.
void findWorstWindow(SummedArea& area, int width, int height, Difference& result) {
    const int w = std::min(kWindow, width), h = std::min(kWindow, height);
    for (int y = 0; y + h <= height; ++y) {
        for (int x = 0; x + w <= width; ++x) {
            const int counted = area.inside(x, y, w, h);
            if (counted <= result.worstWindow) continue;
            result.worstWindow = counted;
            result.windowX = x;
            result.windowY = y;
        }
    }
}

/// Signed differences of noise cancel in the mean, those of another colour do not.
double worstShift(const Image& a, const Image& b) {
    const int w = std::min(kBlock, a.width), h = std::min(kBlock, a.height);
    int worst = 0;
    for (int channel = 0; channel < 4; ++channel) {
        SummedArea area(a.width, a.height);
        for (int y = 0; y < a.height; ++y)
            for (int x = 0, row = 0; x < a.width; ++x) {
                row += a.at(x, y)[channel] - b.at(x, y)[channel];
                area.at(x + 1, y + 1) = area.at(x + 1, y) + row;
            }
        for (int y = 0; y + h <= a.height; ++y)
            for (int x = 0; x + w <= a.width; ++x)
                worst = std::max(worst, std::abs(area.inside(x, y, w, h)));
    }
    return static_cast<double>(worst) / (w * h);
}

/// ITU-R BT.601 weights, 0..255.
double luma(const std::uint8_t* pixel) {
    return 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
}

struct Moments {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;  // sums over the block
};

Moments momentsOf(const Image& a, const Image& b, int left, int top, int width, int height) {
    Moments sum;
    for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x) {
            const double p = luma(a.at(x, y)), q = luma(b.at(x, y));
            sum.a += p;
            sum.b += q;
            sum.aa += p * p;
            sum.bb += q * q;
            sum.ab += p * q;
        }
    }
    return sum;
}

/// SSIM = (2 mA mB + c1) (2 cov + c2) / ((mA^2 + mB^2 + c1) (varA + varB + c2))
/// Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment, IEEE TIP 13 (2004), equation 13,
/// on plain blocks instead of Gaussian windows; c1 = (0.01 * 255)^2, c2 = (0.03 * 255)^2.
double similarity(const Moments& sum, int pixels) {
    constexpr double c1 = 6.5025, c2 = 58.5225;
    const double meanA = sum.a / pixels, meanB = sum.b / pixels;
    const double varianceA = sum.aa / pixels - meanA * meanA;
    const double varianceB = sum.bb / pixels - meanB * meanB;
    const double covariance = sum.ab / pixels - meanA * meanB;
    return (2 * meanA * meanB + c1) * (2 * covariance + c2) /
           ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2));
}

/// Blocks on a grid of 8; those at the right and lower edge may be smaller.
double worstSimilarity(const Image& a, const Image& b) {
    double worst = 1.0;
    for (int y = 0; y < a.height; y += kBlock) {
        for (int x = 0; x < a.width; x += kBlock) {
            const int width = std::min(kBlock, a.width - x);
            const int height = std::min(kBlock, a.height - y);
            const Moments sum = momentsOf(a, b, x, y, width, height);
            worst = std::min(worst, similarity(sum, width * height));
        }
    }
    return worst;
}

}  // namespace

Difference compare(const Image& a, const Image& b, int levels) {
    Difference result;
    result.sameSize = a.width == b.width && a.height == b.height;
    if (!result.sameSize) return result;
    SummedArea area = countPixels(a, b, levels, result);
    if (result.differing == 0) return result;
    findWorstWindow(area, a.width, a.height, result);
    result.worstShift = worstShift(a, b);
    result.worstSsim = worstSimilarity(a, b);
    return result;
}

bool samePicture(const Difference& difference, const Gate& gate) {
    const bool shifted = difference.worstShift > gate.shift() && gate.windowPixels < kBlock * kBlock;
    return difference.sameSize && difference.worstWindow <= gate.windowPixels && !shifted &&
           difference.worstSsim >= gate.ssim;
}

}  // namespace render
