// The scene's camera at the scrubber's time: its keys, its orbit, and the body it follows.

const minus = (a, b) => a.map((v, i) => v - b[i]);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unitOf = (a) => a.map((v) => v / (Math.hypot(...a) || 1));

/// The displacement of the body that the camera follows, m; the camera's lag is left out.
function followed(film) {
  const course = film.actual ?? film.baseline;
  const body = course.bodies.find((one) => one.name === film.follow);
  if (!body) return [0, 0, 0];
  const now = poseAt(body, momentsAt(course, view.film), film.unit).position;
  return minus(now, poseAt(body, { from: 0, to: 0, share: 0 }, film.unit).position);
}

/// The camera's view: interpolated linearly between two rows, but never across a cut.
function viewNow(film) {
  let i = 0;
  while (i + 1 < film.views.length && film.views[i + 1][0] <= view.film + 1e-6) ++i;
  const a = film.views[i], b = film.views[Math.min(i + 1, film.views.length - 1)];
  const share = a[1] === b[1] && b[0] > a[0] ? (view.film - a[0]) / (b[0] - a[0]) : 0;
  const row = a.map((v, k) => v + share * (b[k] - v));
  return { from: row.slice(2, 5), lookAt: row.slice(5, 8), fov: row[8] };
}

/// Maps world to canvas: x, y in CSS pixels and the depth in front of the camera, m.
function projection(film, width, height) {
  const camera = viewNow(film);
  const ahead = unitOf(minus(camera.lookAt, camera.from));
  const right = unitOf(cross(ahead, Math.abs(ahead[1]) > 0.999 ? [0, 0, -1] : [0, 1, 0]));
  const up = cross(right, ahead);
  const scale = height / 2 / Math.tan(camera.fov * Math.PI / 360);
  const shift = followed(film), from = camera.from.map((v, i) => v + shift[i]);
  return (point) => {
    const way = minus(point, from), depth = dot(way, ahead);
    const x = scale * dot(way, right) / depth, y = scale * dot(way, up) / depth;
    return [width / 2 + x, height / 2 - y, depth];
  };
}
