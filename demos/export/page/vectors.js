// Vectors of three numbers, rotations as x y z w, matrices as 16 numbers by columns.

const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => times(1 / Math.max(norm(a), 1e-30), a);
const between = (a, b, share) => a.map((x, i) => x + share * (b[i] - x));

/// Any unit vector at right angles to a unit vector.
const across = (a) => unit(cross(a, Math.abs(a[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0]));

function turned(q, v) {
  const u = [q[0], q[1], q[2]], t = plus(cross(u, v), times(q[3], v));
  return plus(v, times(2, cross(u, t)));
}
const turnedBack = (q, v) => turned([-q[0], -q[1], -q[2], q[3]], v);

function product(a, b) {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
    a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
    a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]];
}

/// The rotation that turns y to the unit vector d.
function turnFromY(d) {
  if (d[1] < -0.99999) return [1, 0, 0, 0];
  const q = [d[2], 0, -d[0], 1 + d[1]], length = Math.hypot(...q);
  return q.map((x) => x / length);
}

function turnAbout(axis, angle) {
  const s = Math.sin(angle / 2);
  return [s * axis[0], s * axis[1], s * axis[2], Math.cos(angle / 2)];
}

function multiplied(a, b) {
  const c = new Float32Array(16);
  for (let column = 0; column < 4; ++column)
    for (let row = 0; row < 4; ++row)
      for (let k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
  return c;
}

/// World to eye: x right, y up, z towards the viewer.
function eyeMatrix(from, right, up, back) {
  return [right[0], up[0], back[0], 0, right[1], up[1], back[1], 0, right[2], up[2], back[2], 0,
    -dot(right, from), -dot(up, from), -dot(back, from), 1];
}
