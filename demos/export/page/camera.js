// The camera: the scene's, until the reader moves it.

function sceneCamera() {
  const { cameras } = data, frame = frameNow(), cameraOf = (number) => cameras[Math.min(number, cameras.length - 1)];
  const a = cameraOf(frame), b = cameraOf(frame + 1), share = a.shot === b.shot ? view.time - frame : 0;
  return { from: between(a.from, b.from, share), at: between(a.at, b.at, share), fov: a.fov + share * (b.fov - a.fov) };
}

/// m: what is nearer to a camera at this distance (m) from what it looks at is not drawn.
const nearestOf = (distance) => Math.max(0.02 * distance, 0.01);

const cameraNow = () => view.camera ?? sceneCamera();

/// The reader's own camera, which starts from the scene's.
function ownCamera() {
  view.camera ??= sceneCamera();
  return view.camera;
}

/// Matrices and axes of a camera, for a picture of this shape (width over height). In a picture narrower
/// than the film it sees as far to the sides, and more above and below.
function sightOf(camera, aspect) {
  const back = unit(minus(camera.from, camera.at)), distance = norm(minus(camera.from, camera.at));
  const right = unit(Math.abs(back[1]) > 0.9999 ? [1, 0, 0] : cross([0, 1, 0], back)), up = cross(back, right);
  const tangent = Math.tan(camera.fov * Math.PI / 360) * Math.max(1, data.aspect / aspect);
  const nearest = nearestOf(distance), farthest = 150 * Math.max(distance, 4), depth = nearest - farthest;
  const projection = [1 / (tangent * aspect), 0, 0, 0, 0, 1 / tangent, 0, 0,
    0, 0, (farthest + nearest) / depth, -1, 0, 0, 2 * farthest * nearest / depth, 0];
  const worldToClip = multiplied(projection, eyeMatrix(camera.from, right, up, back));
  return { eye: camera.from, at: camera.at, right, up, back, distance, tangent, aspect, worldToClip };
}

/// The place in the picture, CSS pixels, and the depth (m; 0 or less: behind the camera).
function project(sight, [x, y, z], width, height) {
  const m = sight.worldToClip, w = m[3] * x + m[7] * y + m[11] * z + m[15];
  const clip = [0, 1].map((row) => (m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]) / w);
  return [(0.5 + 0.5 * clip[0]) * width, (0.5 - 0.5 * clip[1]) * height, w];
}

/// Whether a camera may go there: not below a ground that it was above. It can have been behind a wall.
function staysAbove({ from, at }, place) {
  const least = nearestOf(norm(minus(from, at)));
  return data.grounds.every(({ normal, offset }) => {
    const height = dot(from, normal) - offset;
    return height < 0 || dot(place, normal) - offset >= Math.min(least, height);
  });
}

/// Turns about the point it looks at: radians about the vertical, and up. At the ground it turns only.
function orbit(turn, rise) {
  const camera = ownCamera(), way = minus(camera.from, camera.at), length = norm(way);
  const height = Math.asin(Math.max(-1, Math.min(1, way[1] / length)));
  const angle = Math.atan2(way[0], way[2]) + turn;
  const raised = Math.max(-1.55, Math.min(1.55, height + rise)), flat = Math.cos(raised) * length;
  const from = plus(camera.at, [flat * Math.sin(angle), length * Math.sin(raised), flat * Math.cos(angle)]);
  if (staysAbove(camera, from)) camera.from = from;
  else if (rise !== 0) orbit(turn, 0);
  changed();
}

/// Moves by so many pixels of the picture at the distance of the point it looks at.
function pan(x, y) {
  const camera = ownCamera(), sight = sightOf(camera, canvas.clientWidth / canvas.clientHeight);
  const pixel = 2 * sight.tangent * sight.distance / canvas.clientHeight;
  const way = plus(times(-x * pixel, sight.right), times(y * pixel, sight.up)), from = plus(camera.from, way);
  if (staysAbove(camera, from)) Object.assign(camera, { from, at: plus(camera.at, way) });
  else if (y !== 0) pan(x, 0);
  changed();
}

/// Nearer by a factor below 1.
function zoom(factor) {
  const camera = ownCamera(), way = minus(camera.from, camera.at);
  const length = Math.max(0.02, Math.min(5000, norm(way) * factor));
  const from = plus(camera.at, times(length, unit(way)));
  if (staysAbove(camera, from)) camera.from = from;
  changed();
}

function resetCamera() {
  view.camera = null;
  view.follow = false;
  changed();
}

/// The place, or where a camera that would go below a ground stops above it.
function aboveGrounds({ from, at }, place) {
  const least = nearestOf(norm(minus(from, at)));
  return data.grounds.reduce((above, { normal, offset }) => {
    const missing = least - (dot(above, normal) - offset);
    return missing <= 0 || dot(from, normal) < offset ? above : plus(above, times(missing, normal));
  }, place);
}

/// m: the last place of the body that the camera follows, and by how much the camera is above its own
/// place, for a ground.
let followed = null;

/// Moves with the followed body.
function followBody() {
  if (!view.follow || view.body < 0) {
    followed = null;
    return;
  }
  const place = poses[view.body].at, camera = ownCamera();
  if (followed) {
    const way = minus(place, followed.place), wanted = plus(minus(camera.from, followed.lift), way);
    const from = aboveGrounds(camera, wanted);
    followed.lift = minus(from, wanted);
    Object.assign(camera, { from, at: plus(camera.at, way) });
  }
  followed = { place, lift: followed?.lift ?? [0, 0, 0] };
}

/// The camera moves to the chosen body and follows it, or stops following.
function toggleFollow() {
  if (view.body < 0) return;
  view.follow = !view.follow;
  followed = null;
  if (view.follow) {
    const camera = ownCamera(), way = minus(poses[view.body].at, camera.at);
    camera.from = aboveGrounds(camera, plus(camera.from, way));
    camera.at = plus(camera.at, way);
  }
  changed();
}
