// The bodies' boxes of both runs at the scrubber's time, from the scene's camera.

const playing = { request: 0, last: 0 };
const filmNow = () => sceneNow()?.film ?? null;

/// Time in s; null: no recorded step differs.
function firstDifference() {
  const film = filmNow(), physics = sceneNow()?.physics;
  const course = film?.actual ?? film?.baseline;
  return course && physics.step >= 0 ? physics.step / course.hz : null;
}

/// v turned by the unit quaternion (q, w): v + 2 w (q x v) + 2 q x (q x v)
function turned(v, q) {
  const w = q[3], t = cross(q, v).map((c) => 2 * c), u = cross(q, t);
  return v.map((c, i) => c + w * t[i] + u[i]);
}

function rotationAt(body, at) {
  const q = body.poses.slice(at + 3, at + 6).map((v) => v / 1000);
  return [...q, Math.sqrt(Math.max(0, 1 - dot(q, q)))];
}

/// Interpolates linearly between two moments: with many bodies only few moments are kept.
function poseAt(body, between, unit) {
  const still = body.poses.length === 6;
  const from = still ? 0 : 6 * between.from, to = still ? 0 : 6 * between.to;
  const p = rotationAt(body, from), q = rotationAt(body, to);
  const side = p.reduce((sum, v, i) => sum + v * q[i], 0) < 0 ? -1 : 1;
  return {
    position: [0, 1, 2].map((i) =>
      unit * (body.poses[from + i] + between.share * (body.poses[to + i] - body.poses[from + i]))),
    rotation: unitOf(p.map((v, i) => v + between.share * (side * q[i] - v))),
  };
}

// Corner i of a box is + along an axis if the axis' bit of i is set; along an edge one bit changes.
const kEdges = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) =>
  [1, 2, 4].filter((bit) => (i & bit) === 0).map((bit) => [i, i | bit]));

function strokeBox(context, project, body, pose) {
  const corners = Array.from({ length: 8 }, (_, i) => {
    const local = body.extent.map((e, axis) => (i >> axis & 1 ? e : -e));
    return project(turned(local, pose.rotation).map((c, k) => c + pose.position[k]));
  });
  context.beginPath();
  for (const [a, b] of kEdges) {
    if (corners[a][2] < 0.05 || corners[b][2] < 0.05) continue;  // behind the camera
    context.moveTo(corners[a][0], corners[a][1]);
    context.lineTo(corners[b][0], corners[b][1]);
  }
  context.stroke();
}

/// The moments of poses before and after `time`, and the share of the way from one to the other.
function momentsAt(course, time) {
  const steps = course.pose_steps, step = time * course.hz;
  let from = 0;
  while (from + 1 < steps.length && steps[from + 1] <= step + 1e-6) ++from;
  const to = Math.min(steps.length - 1, from + 1);
  const way = steps[to] - steps[from];
  return { from, to, share: way > 0 ? Math.max(0, step - steps[from]) / way : 0 };
}

function drawBodies(context, project, course, color, thick) {
  const between = momentsAt(course, view.film);
  context.strokeStyle = color;
  for (const body of course.bodies) {
    context.lineWidth = body.name === sceneNow().physics.body ? thick + 1.5 : thick;
    strokeBox(context, project, body, poseAt(body, between, filmNow().unit));
  }
}

function drawFilm() {
  const film = filmNow();
  if (!film) return;
  const [context, width, height] = freshContext(byId("film-canvas"));
  const project = projection(film, width, height);
  if (film.baseline) drawBodies(context, project, film.baseline, styleColor("--baseline"), 1.75);
  if (film.actual) drawBodies(context, project, film.actual, styleColor("--actual"), 1);
  drawCurves(film);
  byId("film-time").value = view.film;
  const course = film.actual ?? film.baseline;
  byId("film-now").textContent =
    `${view.film.toFixed(3)} s, step ${Math.round(view.film * course.hz)}`;
}

function runWords(film) {
  if (film.same) return "both runs are the same, bit for bit";
  if (!film.baseline) return "there is no baseline";
  return film.actual ? "blue: baseline, orange: actual" : "there is no actual run";
}

function filmWords(film) {
  const parts = [runWords(film)];
  const body = sceneNow().physics.body;
  if (body !== "") parts.push(`thick: ${body}`);
  const course = film.actual ?? film.baseline;
  if (course.bodies.length < course.all_bodies)
    parts.push(`boxes of ${course.bodies.length} of ${course.all_bodies} bodies: those that ` +
      "move farthest");
  return parts.join("; ") + ".";
}

function showFilm() {
  const film = filmNow();
  byId("film").hidden = !film;
  stopFilm();
  if (!film) return;
  byId("film-time").max = filmEnd(film);
  view.film = Math.min(Math.max(0, view.film), filmEnd(film));
  byId("film-first").hidden = firstDifference() === null;
  byId("film-note").textContent = filmWords(film);
  drawFilm();
}

function seek(time) {
  const film = filmNow();
  if (!film) return;
  view.film = Math.min(filmEnd(film), Math.max(0, time));
  drawFilm();
  writeLink();
}

/// Moves by a number of steps of the run.
function stepFilm(by) {
  const course = filmNow()?.actual ?? filmNow()?.baseline;
  if (course) seek((Math.round(view.film * course.hz) + by) / course.hz);
}

function seekFirst() {
  const first = firstDifference();
  if (first === null) return;
  seek(first);
  byId("film").scrollIntoView({ block: "nearest" });
}

function stopFilm() {
  cancelAnimationFrame(playing.request);
  playing.request = 0;
  byId("film-play").textContent = "Play";
}

function advanceFilm(now) {
  const passed = Math.min(0.1, (now - playing.last) / 1000), end = filmEnd(filmNow());
  playing.last = now;
  view.film = view.film >= end ? 0 : Math.min(end, view.film + passed);
  drawFilm();
  playing.request = requestAnimationFrame(advanceFilm);
}

function playFilm() {
  if (!filmNow()) return;
  if (playing.request) {
    stopFilm();
    writeLink();
    return;
  }
  byId("film-play").textContent = "Pause";
  playing.last = performance.now();
  playing.request = requestAnimationFrame(advanceFilm);
}

function listenToFilm() {
  const curves = byId("curves");
  const toPointer = (event) => {
    const inner = curves.clientWidth - kCurveMargin.left - kCurveMargin.right;
    if (event.buttons === 1) seek((event.offsetX - kCurveMargin.left) / inner * filmEnd(filmNow()));
  };
  curves.addEventListener("pointerdown", toPointer);
  curves.addEventListener("pointermove", toPointer);
  byId("film-time").addEventListener("input", (event) => seek(Number(event.target.value)));
  byId("film-play").addEventListener("click", playFilm);
  byId("film-first").addEventListener("click", seekFirst);
}
