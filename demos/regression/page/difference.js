// Where two pictures differ, and the signed difference.

/// Red: beyond the gate's levels. Yellow: less. The background is the actual picture, faded.
function drawDifference(out, a, b, levels) {
  for (let i = 0; i < out.length; i += 4) {
    const largest = Math.max(
      Math.abs(a[i] - b[i]), Math.abs(a[i + 1] - b[i + 1]), Math.abs(a[i + 2] - b[i + 2]));
    const gray = 190 + (0.2126 * b[i] + 0.7152 * b[i + 1] + 0.0722 * b[i + 2]) / 4;
    const color =
      largest > levels ? [214, 32, 32] : largest > 0 ? [236, 190, 30] : [gray, gray, gray];
    out[i] = color[0];
    out[i + 1] = color[1];
    out[i + 2] = color[2];
    out[i + 3] = 255;
  }
}

/// 128 + 16 (actual - baseline), per channel: gray is no difference, 8 levels are black or white.
function drawSigned(out, a, b) {
  for (let i = 0; i < out.length; ++i)
    out[i] = i % 4 === 3 ? 255 : Math.max(0, Math.min(255, 128 + 16 * (b[i] - a[i])));
}
