// How visible each difference is when one flips between two pictures, 0 to 1.
//
// After FLIP: P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson, K. Astrom,
// M. D. Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph.
// Interact. Tech. 3(2), High-Performance Graphics 2020. Simplified here:
//   - one small blur of linear light replaces their three contrast sensitivity functions, so no
//     distance to the display is assumed;
//   - edges only, by Sobel's operator on L*; no point detector.
// As there: L*a*b* with the Hunt adjustment, the HyAB distance, the exponent 0.7, the two-piece
// scale, and an exponent that edges lower: color^(1 - edges).

const kColorExponent = 0.7;
const kKnee = 0.4, kKneeValue = 0.95;  // this share of the largest error is drawn as 0.95

const linearLight = Float32Array.from({ length: 256 }, (_, level) => {
  const s = level / 255;
  return s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
});

/// [1 4 6 4 1] / 16 along one axis; the border repeats.
function blurAlong(from, to, width, height, dx, dy) {
  const at = (x, y) =>
    from[Math.max(0, Math.min(height - 1, y)) * width + Math.max(0, Math.min(width - 1, x))];
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      to[y * width + x] = (at(x - 2 * dx, y - 2 * dy) + at(x + 2 * dx, y + 2 * dy) +
        4 * (at(x - dx, y - dy) + at(x + dx, y + dy)) + 6 * at(x, y)) / 16;
}

function blurredLight(bytes, channel, width, height) {
  const light = new Float32Array(width * height), other = new Float32Array(width * height);
  for (let i = 0; i < light.length; ++i) light[i] = linearLight[bytes[4 * i + channel]];
  blurAlong(light, other, width, height, 1, 0);
  blurAlong(other, light, width, height, 0, 1);
  return light;
}

const labCurve = (t) => (t > 216 / 24389 ? Math.cbrt(t) : (24389 / 27 * t + 16) / 116);

/// L*, and a*, b* times L* / 100: colours in dark areas count less (Hunt). White is D65.
function huntLab(r, g, b) {
  const x = labCurve((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const y = labCurve(0.2126729 * r + 0.7151522 * g + 0.072175 * b);
  const z = labCurve((0.0193339 * r + 0.119192 * g + 0.9503041 * b) / 1.08883);
  const lightness = 116 * y - 16, share = lightness / 100;
  return [lightness, 500 * (x - y) * share, 200 * (y - z) * share];
}

/// |dL| + sqrt(da^2 + db^2)
const hyab = (p, q) => Math.abs(p[0] - q[0]) + Math.hypot(p[1] - q[1], p[2] - q[2]);

/// The largest possible error: green to blue.
const kLargestError = hyab(huntLab(0, 1, 0), huntLab(0, 0, 1)) ** kColorExponent;

function colorError(p, q) {
  const error = hyab(p, q) ** kColorExponent / kLargestError;
  return error < kKnee ? error * kKneeValue / kKnee
    : Math.min(1, kKneeValue + (error - kKnee) / (1 - kKnee) * (1 - kKneeValue));
}

function labPlanes(bytes, width, height) {
  const [r, g, b] = [0, 1, 2].map((channel) => blurredLight(bytes, channel, width, height));
  return Array.from(r, (_, i) => huntLab(r[i], g[i], b[i]));
}

/// The length of Sobel's gradient of L*, 1 for a step from black to white.
function edgeAt(lab, width, height, x, y) {
  const at = (dx, dy) => lab[Math.max(0, Math.min(height - 1, y + dy)) * width +
    Math.max(0, Math.min(width - 1, x + dx))][0];
  const across = at(1, -1) + 2 * at(1, 0) + at(1, 1) - at(-1, -1) - 2 * at(-1, 0) - at(-1, 1);
  const down = at(-1, 1) + 2 * at(0, 1) + at(1, 1) - at(-1, -1) - 2 * at(0, -1) - at(1, -1);
  return Math.hypot(across, down) / 400;
}

/// One value per pixel, 0 to 1.
function heatOf(a, b, width, height) {
  const labA = labPlanes(a, width, height), labB = labPlanes(b, width, height);
  const heat = new Float32Array(width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const i = y * width + x, color = colorError(labA[i], labB[i]);
      if (color === 0) continue;
      const edges = Math.abs(edgeAt(labA, width, height, x, y) - edgeAt(labB, width, height, x, y));
      heat[i] = color ** (1 - Math.sqrt(Math.min(1, edges) / Math.SQRT2));
    }
  return heat;
}

// From dark violet through red to cream with increasing lightness, like the magma map.
const kHeatColors = [
  [0, 0, 4], [62, 16, 112], [160, 42, 124], [240, 92, 94], [254, 192, 134], [252, 253, 191],
];

function heatColor(value) {
  const at = Math.min(0.9999, Math.max(0, value)) * (kHeatColors.length - 1);
  const low = kHeatColors[Math.floor(at)], high = kHeatColors[Math.floor(at) + 1];
  return low.map((channel, i) => channel + (high[i] - channel) * (at % 1));
}

function drawHeat(out, a, b, width, height) {
  heatOf(a, b, width, height).forEach((value, i) => {
    const color = heatColor(value);
    for (let channel = 0; channel < 3; ++channel) out[4 * i + channel] = color[channel];
    out[4 * i + 3] = 255;
  });
}
