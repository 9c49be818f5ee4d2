// Finds the body at a point of the picture.

/// m along the ray (unit) to a triangle seen from its front; Infinity if the ray misses it.
/// (Moller and Trumbore 1997)
function meet(eye, ray, a, b, c) {
  const ab = minus(b, a), ac = minus(c, a), p = cross(ray, ac), area = dot(ab, p);
  if (area < 1e-14) return Infinity;
  const s = minus(eye, a), u = dot(s, p) / area, q = cross(s, ab), v = dot(ray, q) / area;
  const way = dot(ac, q) / area;
  return u >= 0 && v >= 0 && u + v <= 1 && way > 0 ? way : Infinity;
}

/// m to the solid; the eye and the ray are in the solid's axes.
function meetSolid(numbers, eye, ray) {
  let nearest = Infinity;
  const point = (i) => [numbers[i], numbers[i + 1], numbers[i + 2]];
  for (let i = 0; i < numbers.length; i += 3 * kFloats)
    nearest = Math.min(nearest, meet(eye, ray, point(i), point(i + kFloats), point(i + 2 * kFloats)));
  return nearest;
}

const passesBy = (eye, ray, middle, reach) => norm(cross(ray, minus(middle, eye))) > reach;

/// x, y: CSS pixels in the picture. The body's number, -1 for none.
function bodyAt(x, y) {
  const { clientWidth: width, clientHeight: height } = canvas, sight = sightOf(cameraNow(), width / height);
  const right = (2 * x / width - 1) * sight.tangent * sight.aspect, up = (1 - 2 * y / height) * sight.tangent;
  const ray = unit(plus(plus(times(right, sight.right), times(up, sight.up)), times(-1, sight.back)));
  let best = -1, nearest = Infinity;
  for (const kind of kinds)
    for (const part of kind.parts) {
      const { at, turn } = poses[part.body], middle = plus(at, turned(turn, part.at)), all = product(turn, part.turn);
      if (passesBy(sight.eye, ray, middle, kind.reach)) continue;
      const way = meetSolid(kind.numbers, turnedBack(all, minus(sight.eye, middle)), turnedBack(all, ray));
      if (way < nearest) [best, nearest] = [part.body, way];
    }
  return best;
}
