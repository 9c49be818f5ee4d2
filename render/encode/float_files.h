/// Pictures of 32-bit floats, stored exactly: PFM for one number per pixel, Middlebury's .flo for
/// two.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace render {

/// Portable float map: the lines "Pf", "WIDTH HEIGHT", "-1.0" (little-endian), then the rows, the
/// bottom one first. `values`: row 0 on top; throws Error unless there are width * height.
/// P. Debevec, https://www.pauldebevec.com/Research/HDR/PFM/
std::vector<std::uint8_t> encodePfm(std::span<const float> values, int width, int height);

/// "PIEH" (the float 202021.25), width, height as 32-bit integers, then x, y of every pixel, the
/// top row first; all little-endian. Throws Error unless `flow` has width * height values.
/// D. Scharstein, https://vision.middlebury.edu/flow/code/flow-code/README.txt
std::vector<std::uint8_t> encodeFlo(std::span<const Eigen::Vector2f> flow, int width, int height);

}  // namespace render
