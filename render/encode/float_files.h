/// Pictures of 32-bit floats, exact: PFM for one number a pixel, Middlebury's .flo for two.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace render {

/// Portable float map: the lines "Pf", "WIDTH HEIGHT", "-1.0" (little-endian), then the rows, the
/// bottom one first. `values`: row 0 on top, width * height of them, else Error.
/// P. Debevec, https://www.pauldebevec.com/Research/HDR/PFM/
std::vector<std::uint8_t> encodePfm(std::span<const float> values, int width, int height);

/// "PIEH" (the float 202021.25), width, height as 32-bit integers, then x, y of every pixel, the
/// top row first; all little-endian. `flow`: width * height, else Error.
/// D. Scharstein, https://vision.middlebury.edu/flow/code/flow-code/README.txt
std::vector<std::uint8_t> encodeFlo(std::span<const Eigen::Vector2f> flow, int width, int height);

}  // namespace render
