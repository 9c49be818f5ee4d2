// Meshes as triangles with smooth or sharp edges. As in render/solid_mesh.h, edges of a convex mesh
// are sharp from half a degree, those of a surface from 30 degrees.

const bend = (degrees) => Math.cos(degrees * Math.PI / 180);

function faceNormals({ vertices, corners }) {
  const normals = [];
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => vertices[corners[i + k]]);
    normals.push(unit(cross(minus(b, a), minus(c, a))));
  }
  return normals;
}

/// The triangles at every vertex.
function trianglesAt({ vertices, corners }) {
  const around = vertices.map(() => []);
  corners.forEach((vertex, i) => around[vertex].push(Math.floor(i / 3)));
  return around;
}

/// The mean normal of the triangles that join a triangle smoothly.
function smoothNormal(own, normals, around, smooth) {
  let sum = [0, 0, 0];
  for (const other of around) if (dot(normals[other], own) >= smooth) sum = plus(sum, normals[other]);
  return unit(sum);
}

function isSharp(triangle, from, to, around, normals, smooth) {
  const other = around[from].find((t) => t !== triangle && around[to].includes(t));
  return other !== undefined && dot(normals[other], normals[triangle]) < smooth;
}

/// For each corner the distances from the three edges: its own height, or 0 on an edge.
function edgeDistances(triangle, mesh, around, normals, smooth) {
  const number = (k) => mesh.corners[3 * triangle + k % 3], point = (k) => mesh.vertices[number(k)];
  return [0, 1, 2].map((corner) => [0, 1, 2].map((edge) => {
    if (!isSharp(triangle, number(edge), number(edge + 1), around, normals, smooth)) return kFar;
    if (corner !== (edge + 2) % 3) return 0;
    const way = minus(point(edge + 1), point(edge));
    return norm(cross(way, minus(point(edge + 2), point(edge)))) / Math.max(norm(way), 1e-12);
  }));
}

function meshTriangles(mesh) {
  const smooth = bend(mesh.convex ? 0.5 : 30), triangles = new Triangles();
  const normals = faceNormals(mesh), around = trianglesAt(mesh);
  normals.forEach((normal, t) => {
    const edges = edgeDistances(t, mesh, around, normals, smooth);
    for (let k = 0; k < 3; ++k) {
      const vertex = mesh.corners[3 * t + k];
      triangles.vertex(mesh.vertices[vertex], smoothNormal(normal, normals, around[vertex], smooth), [...edges[k], kFar]);
    }
  });
  return triangles.numbers;
}
