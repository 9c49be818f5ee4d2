// Bodies, and the bars and coils between them, at the current time.

let poses = [];        // by body: { at, turn, speed } between two frames
const kinds = [];      // { opaque, clear, parts, thinnest, reach, numbers }: solids of one size
let bars = null;       // of joints and springs
const kJointColor = [...linear([0.29, 0.302, 0.322]), 1];
const kAtEase = [0, 0, 0, 1], kFull = [1, 1, 1];

/// Half of the solid's smallest size, and its reach (m).
function sizeOf(numbers) {
  const half = [0, 0, 0];
  let reach = 0;
  for (let i = 0; i < numbers.length; i += kFloats) {
    const at = [numbers[i], numbers[i + 1], numbers[i + 2]];
    at.forEach((x, axis) => { half[axis] = Math.max(half[axis], Math.abs(x)); });
    reach = Math.max(reach, norm(at));
  }
  return { thinnest: Math.min(...half), reach };
}

const batchesOf = (numbers) => ({ opaque: new Batch(numbers), clear: new Batch(numbers) });

/// Round solids get at most so many sides.
function setSides(most) {
  const sides = Math.min(most, finest);
  if (sides === around) return;
  around = sides;
  for (const kind of kinds.filter(({ form }) => form))
    Object.assign(kind, kind.made[sides] ??= batchesOf(solidTriangles[kind.form.shape](kind.form.half)));
}

function makeKinds() {
  const known = new Map();
  suitSides(data.bodies.flatMap((body) => body.parts));
  data.bodies.forEach((body, number) => body.parts.forEach((part) => {
    const key = part.mesh === undefined ? part.shape + part.half : `mesh ${part.mesh}`;
    if (!known.has(key)) {
      const numbers = part.mesh === undefined ? solidTriangles[part.shape](part.half) : meshTriangles(meshes[part.mesh]);
      const batches = batchesOf(numbers), form = part.mesh === undefined && part.shape !== "box" ? part : null;
      const kind = { numbers, parts: [], form, made: { [around]: batches }, ...batches, ...sizeOf(numbers) };
      known.set(key, kind);
      kinds.push(kind);
    }
    const color = [...linear(body.color), body.color[3]];
    const { material } = body;
    known.get(key).parts.push({ body: number, at: part.at ?? [0, 0, 0], turn: part.turn ?? kAtEase, color, material });
  }));
  bars = new Batch(barTriangles());
}

/// q and -q are the same rotation: interpolate to the nearer one.
function poseAt({ still, places, turns, speeds }, frame, share) {
  if (still) return { at: [...places], turn: [...turns], speed: 0 };
  const next = Math.min(frame + 1, lastFrame), at = [0, 0, 0], turn = [0, 0, 0, 0];
  for (let i = 0; i < 3; ++i) at[i] = places[3 * frame + i] + share * (places[3 * next + i] - places[3 * frame + i]);
  let along = 0;
  for (let i = 0; i < 4; ++i) along += turns[4 * frame + i] * turns[4 * next + i];
  const sign = along < 0 ? -1 : 1;
  for (let i = 0; i < 4; ++i) turn[i] = (1 - share) * turns[4 * frame + i] + share * sign * turns[4 * next + i];
  const length = Math.hypot(...turn);
  return { at, turn: turn.map((x) => x / length), speed: speeds[frame] + share * (speeds[next] - speeds[frame]) };
}

function movePoses() {
  const frame = frameNow(), share = Math.max(0, view.time - frame);
  poses = motions.map((motion) => poseAt(motion, frame, share));
}

function placeSolids() {
  for (const kind of kinds) {
    kind.opaque.clear();
    kind.clear.clear();
    for (const part of kind.parts) {
      const { at, turn } = poses[part.body];
      const batch = part.color[3] < 1 ? kind.clear : kind.opaque;
      batch.add(plus(at, turned(turn, part.at)), product(turn, part.turn), kFull, part.color, part.material);
    }
    kind.opaque.upload();
    kind.clear.upload();
  }
}

/// m, in the world: a place given in a body's axes.
function placeOf(body, local) {
  return body < 0 ? local : plus(poses[body].at, turned(poses[body].turn, local));
}

/// Never thinner than half a pixel.
function addBar(batch, from, to, radius, sight, color) {
  const way = minus(to, from), length = norm(way);
  if (length < 1e-6) return;
  const away = norm(minus(from, sight.eye)), least = 0.55 * away * 2 * sight.tangent / canvas.height;
  const wide = Math.max(radius, least);
  batch.add(times(0.5, plus(from, to)), turnFromY(times(1 / length, way)), [wide, length / 2, wide], color);
}

function addCoil(from, to, rest, sight) {
  const kTurns = 9, kPerTurn = 10, kStraight = 0.12, way = minus(to, from);
  const radius = Math.max(0.02, Math.min(0.2, 0.09 * rest)), along = unit(way);
  const second = across(along), third = cross(along, second);
  let last = from;
  const go = (next) => { addBar(bars, last, next, 0.15 * radius, sight, kJointColor); last = next; };
  for (let i = 0; i <= kTurns * kPerTurn; ++i) {
    const share = i / (kTurns * kPerTurn), angle = 2 * Math.PI * kTurns * share;
    const out = plus(times(radius * Math.cos(angle), second), times(radius * Math.sin(angle), third));
    go(plus(plus(from, times(kStraight + (1 - 2 * kStraight) * share, way)), out));
  }
  go(to);
}

function placeBars(sight) {
  bars.clear();
  for (const bar of data.bars) {
    if (bar.joint >= 0 && frameNow() > data.joints[bar.joint].until) continue;
    const from = placeOf(bar.a, bar.atA), to = placeOf(bar.b, bar.atB);
    if (bar.rest === undefined) addBar(bars, from, to, bar.radius, sight, kJointColor);
    else addCoil(from, to, bar.rest, sight);
  }
  bars.upload();
}
