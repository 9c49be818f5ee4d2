// Decodes what replay_codec.cpp and replay_json.cpp wrote.

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// Columns of `length` words; each word is stored as its difference from the one before.
async function columnsOf(text, length) {
  const bytes = await unpacked(text), count = bytes.length / 2, words = new Uint16Array(count);
  for (let i = 0; i < count; ++i) {
    const step = bytes[i] | bytes[count + i] << 8;
    words[i] = step + (i % length === 0 ? 0 : words[i - 1]);
  }
  return (number) => words.subarray(number * length, (number + 1) * length);
}

const valueOf = ([low, size], word) => low + size * word / 65535;

/// The smallest three of a quaternion; two top bits say which is left out.
function rotationOf(words, into, at) {
  const largest = words[0] >> 15 | words[1] >> 15 << 1;
  let next = 0, rest = 1;
  for (let i = 0; i < 4; ++i) {
    if (i === largest) continue;
    const x = (2 * (words[next++] & 0x7fff) / 32767 - 1) * Math.SQRT1_2;
    into[at + i] = x;
    rest -= x * x;
  }
  into[at + largest] = Math.sqrt(Math.max(rest, 0));
}

/// A unit vector from an octahedron's square.
function directionOf(word) {
  const u = (word >> 8) / 127.5 - 1, v = (word & 255) / 127.5 - 1, z = 1 - Math.abs(u) - Math.abs(v);
  const sign = (x) => (x < 0 ? -1 : 1);
  if (z >= 0) return unit([u, v, z]);
  return unit([(1 - Math.abs(v)) * sign(u), (1 - Math.abs(u)) * sign(v), z]);
}

/// For every body: places (3 per frame), turns (4) and speeds; one frame only if it never moves.
async function motionsOf() {
  const column = await columnsOf(data.tracks, data.frames);
  let next = 0;
  return data.bodies.map((body) => {
    if (!body.ranges) return { still: true, places: Float32Array.from(body.at), turns: Float32Array.from(body.turn), speeds: [0] };
    const words = Array.from({ length: 7 }, () => column(next++));
    const room = (each) => new Float32Array(each * data.frames);
    const motion = { still: false, places: room(3), turns: room(4), speeds: room(1) };
    for (let f = 0; f < data.frames; ++f) {
      for (let axis = 0; axis < 3; ++axis) motion.places[3 * f + axis] = valueOf(body.ranges[axis], words[axis][f]);
      motion.speeds[f] = valueOf(body.ranges[3], words[3][f]);
      rotationOf([words[4][f], words[5][f], words[6][f]], motion.turns, 4 * f);
    }
    return motion;
  });
}

/// By frame: { at, normal, impulse, friction }, m and N s.
async function contactsOf() {
  const { counts, ranges, words } = data.contacts;
  const total = counts.reduce((sum, count) => sum + count, 0);
  const column = await columnsOf(words, Math.max(total, 1));
  const columns = Array.from({ length: 7 }, (_, number) => column(number));
  let next = 0;
  const contact = (i) => ({
    at: [0, 1, 2].map((axis) => valueOf(ranges[axis], columns[axis][i])),
    impulse: valueOf(ranges[3], columns[3][i]),
    normal: directionOf(columns[5][i]),
    friction: times(valueOf(ranges[4], columns[4][i]), directionOf(columns[6][i])),
  });
  return counts.map((count) => Array.from({ length: count }, () => contact(next++)));
}

/// Vertices (m) and corners of triangles.
async function meshOf(mesh) {
  const point = await columnsOf(mesh.points, mesh.vertices);
  const corner = await columnsOf(mesh.corners, 3 * mesh.triangles);
  const low = corner(0), high = corner(1), axes = [point(0), point(1), point(2)];
  const ranges = mesh.half.map((half) => [-half, 2 * half]);
  return {
    convex: mesh.convex,
    vertices: Array.from(axes[0], (_, i) => axes.map((words, axis) => valueOf(ranges[axis], words[i]))),
    corners: Array.from(low, (word, i) => word + 65536 * high[i]),
  };
}

let motions = [], contacts = [], meshes = [];

async function decode() {
  motions = await motionsOf();
  contacts = await contactsOf();
  meshes = await Promise.all(data.meshes.map(meshOf));
}
