// Solids as triangles, in metres. A vertex: position, normal, and its distances (m) from up to four
// edges of its face, which the shader draws; kFar: no edge.

const kFar = 1e3;
const kTriangles = 200e3;  // about as many as balls may have together
let around = 48, finest = 48;  // sides of round solids: now, and where frames are quick

/// Fewer sides where there are many round solids, which are small then: a ball has about sides^2
/// triangles.
function suitSides(parts) {
  const round = parts.filter((part) => !["box", "mesh"].includes(part.shape)).length;
  finest = [48, 32, 24].find((sides) => round * sides ** 2 <= kTriangles) ?? 16;
  around = finest;
}

const kFloats = 10;  // per vertex

class Triangles {
  constructor() { this.numbers = []; }
  vertex(position, normal, edges) { this.numbers.push(...position, ...normal, ...edges); }
  add(...vertices) { for (const vertex of vertices) this.vertex(...vertex); }
  quad(a, b, c, d) { this.add(a, b, c, a, c, d); }
}

function boxTriangles([hx, hy, hz]) {
  const mesh = new Triangles(), half = [hx, hy, hz];
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [-1, 1]) {
      const u = (axis + 1) % 3, v = (axis + 2) % 3, normal = [0, 0, 0];
      normal[axis] = side;
      const corner = (s, t) => {
        const at = [0, 0, 0];
        at[axis] = side * half[axis];
        at[u] = s * side * half[u];
        at[v] = t * half[v];
        return [at, normal, [(1 - s) * half[u], (1 + s) * half[u], (1 - t) * half[v], (1 + t) * half[v]]];
      };
      mesh.quad(corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1));
    }
  return mesh.numbers;
}

const kNoEdges = [kFar, kFar, kFar, kFar];
const circle = (i, sides = around) => [Math.cos(2 * Math.PI * i / sides), -Math.sin(2 * Math.PI * i / sides)];

/// A ball with its halves moved `half` up and down; with half > 0 a capsule.
function ballTriangles(radius, half, sides = around) {
  const mesh = new Triangles(), rings = sides / 2;
  const point = (ring, i) => {
    const below = ring <= rings / 2, angle = Math.PI * ((below ? ring : ring - 1) / rings - 0.5);
    const [x, z] = circle(i, sides), normal = [Math.cos(angle) * x, Math.sin(angle), Math.cos(angle) * z];
    const at = times(radius, normal);
    at[1] += below ? -half : half;
    return [at, normal, kNoEdges];
  };
  for (let ring = 0; ring <= rings; ++ring)
    for (let i = 0; i < sides; ++i)
      mesh.quad(point(ring, i), point(ring, i + 1), point(ring + 1, i + 1), point(ring + 1, i));
  return mesh.numbers;
}

/// A disc that faces up (side 1) or down (-1).
function addDisc(mesh, radius, y, side) {
  const normal = [0, side, 0], middle = [[0, y, 0], normal, [radius, kFar, kFar, kFar]];
  const rim = (i) => {
    const [x, z] = circle(i);
    return [[radius * x, y, radius * z], normal, [0, kFar, kFar, kFar]];
  };
  for (let i = 0; i < around; ++i) {
    if (side > 0) mesh.add(middle, rim(i), rim(i + 1));
    else mesh.add(middle, rim(i + 1), rim(i));
  }
}

function cylinderTriangles(radius, half) {
  const mesh = new Triangles();
  const point = (i, side) => {
    const [x, z] = circle(i);
    return [[radius * x, side * half, radius * z], [x, 0, z], [(1 - side) * half, (1 + side) * half, kFar, kFar]];
  };
  for (let i = 0; i < around; ++i) mesh.quad(point(i, -1), point(i + 1, -1), point(i + 1, 1), point(i, 1));
  addDisc(mesh, radius, half, 1);
  addDisc(mesh, radius, -half, -1);
  return mesh.numbers;
}

/// The base is half / 2 below the origin, the tip 1.5 half above.
function coneTriangles(radius, half) {
  const mesh = new Triangles(), slant = Math.hypot(radius, 2 * half);
  const normal = (i) => {
    const [x, z] = circle(i);
    return [2 * half / slant * x, radius / slant, 2 * half / slant * z];
  };
  for (let i = 0; i < around; ++i) {
    const rim = (k) => {
      const [x, z] = circle(k);
      return [[radius * x, -half / 2, radius * z], normal(k), [0, kFar, kFar, kFar]];
    };
    mesh.add(rim(i), rim(i + 1), [[0, 1.5 * half, 0], normal(i + 0.5), [slant, kFar, kFar, kFar]]);
  }
  addDisc(mesh, radius, -half / 2, -1);
  return mesh.numbers;
}

/// A cylinder along y from -1 to 1, of radius 1, open: bars and shafts.
function barTriangles() {
  const mesh = new Triangles(), sides = 12;
  const point = (i, y) => {
    const angle = 2 * Math.PI * i / sides, out = [Math.cos(angle), 0, -Math.sin(angle)];
    return [[out[0], y, out[2]], out, kNoEdges];
  };
  for (let i = 0; i < sides; ++i) mesh.quad(point(i, -1), point(i + 1, -1), point(i + 1, 1), point(i, 1));
  return mesh.numbers;
}

const solidTriangles = {
  box: (half) => boxTriangles(half),
  sphere: ([radius]) => ballTriangles(radius, 0),
  capsule: ([radius, half]) => ballTriangles(radius, half),
  cylinder: ([radius, half]) => cylinderTriangles(radius, half),
  cone: ([radius, half]) => coneTriangles(radius, half),
};
