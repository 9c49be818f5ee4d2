// Marks over the picture: contacts, arrows, anchors, trails. Faint where they are hidden.

const hex = (rgb) => [rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255].map((level) => level / 255).concat(1);
const kInks = {
  contacts: hex(0xe0218a), normals: hex(0x1f77d0), impulses: hex(0xd62728), friction: hex(0xf0a202),
  joints: hex(0x4a4d52), anchor: hex(0x1f77d0),
};
const kTrailSeconds = 3, kLongest = 0.16;  // of the view's height: the largest impulse's arrow

let marks = null;

function makeMarks() {
  const ball = ballTriangles(1, 0, 12);  // a few pixels wide, and there are thousands
  marks = {
    shafts: new Batch(barTriangles()), heads: new Batch(coneTriangles(1, 1)), dots: new Batch(ball), anchors: new Batch(ball),
  };
}

/// The size of a CSS pixel at a place, m.
const pixelAt = (sight, place) =>
  2 * sight.tangent * Math.max(dot(minus(sight.eye, place), sight.back), 0.01) / canvas.clientHeight;

function addDot(batch, sight, place, pixels, color, largest = Infinity) {
  const radius = Math.min(pixels * pixelAt(sight, place), largest);
  batch.add(place, kAtEase, [radius, radius, radius], color);
}

function addArrow(sight, from, way, color) {
  const length = norm(way), pixel = pixelAt(sight, from);
  if (length < 1e-9) return;
  const along = times(1 / length, way), turn = turnFromY(along);
  const wide = Math.min(1.6 * pixel, 0.12 * length), head = Math.min(11 * pixel, 0.6 * length);
  const neck = plus(from, times(length - head, along)), shaft = times(0.5, plus(from, neck));
  marks.shafts.add(shaft, turn, [wide, (length - head) / 2, wide], color);
  marks.heads.add(plus(neck, times(head / 4, along)), turn, [2.9 * wide, head / 2, 2.9 * wide], color);
}

/// The length of arrows per N s: as in the film, by the recent peak.
function arrowScale() {
  const peak = data.curves.peak[frameNow()], longest = kLongest * data.viewHeight;
  return peak > 0 ? { perUnit: longest / peak, longest, peak } : { perUnit: 0, longest, peak: 0 };
}

function addContacts(sight) {
  const { show } = view, { perUnit, longest } = arrowScale(), tall = data.viewHeight, thin = data.thinnest;
  const normal = Math.max(0.015 * tall, Math.min(0.03 * tall, 0.7 * thin)), largest = Math.max(0.16 * thin, 0.004 * tall);
  for (const contact of contacts[frameNow()]) {
    if (show.has("contacts")) addDot(marks.dots, sight, contact.at, 3.5, kInks.contacts, largest);
    if (show.has("normals")) addArrow(sight, contact.at, times(normal, contact.normal), kInks.normals);
    const push = perUnit * contact.impulse, drag = times(perUnit, contact.friction);
    if (show.has("impulses") && push > 0.03 * longest) addArrow(sight, contact.at, times(push, contact.normal), kInks.impulses);
    if (show.has("friction") && norm(drag) > 0.03 * longest) addArrow(sight, contact.at, drag, kInks.friction);
  }
}

function addAnchors(sight) {
  for (const joint of data.joints) {
    if (frameNow() > joint.until) continue;
    const a = placeOf(joint.a, joint.atA), b = placeOf(joint.b, joint.atB);
    addDot(marks.anchors, sight, a, 5, kInks.joints);
    addDot(marks.anchors, sight, b, 3.2, kInks.anchor);
  }
}

/// The paths of the last three seconds, for the bodies that the scene names and the chosen one.
function addTrails(sight) {
  const chosen = view.body >= 0 && !data.trails.includes(view.body) ? [view.body] : [];
  const now = frameNow(), first = Math.max(0, now - Math.round(kTrailSeconds * data.fps));
  for (const body of [...data.trails, ...chosen]) {
    const { still, places } = motions[body];
    if (still) continue;
    for (let f = first; f <= now; ++f) {
      const from = places.subarray(3 * f, 3 * f + 3), last = f === now;
      const to = last ? poses[body].at : places.subarray(3 * f + 3, 3 * f + 6);
      const alpha = 0.75 * (f - first + 1) / (now - first + 1);
      addBar(marks.shafts, [...from], [...to], 2 * pixelAt(sight, from), sight, [...data.bodies[body].color.slice(0, 3), alpha]);
    }
  }
}

function placeMarks(sight) {
  for (const batch of Object.values(marks)) batch.clear();
  if (["contacts", "normals", "impulses", "friction"].some((name) => view.show.has(name))) addContacts(sight);
  if (view.show.has("joints")) addAnchors(sight);
  if (view.show.has("trails")) addTrails(sight);
  for (const batch of Object.values(marks)) batch.upload();
}

const kHidden = 0.28, kAnchorHidden = 0.75;  // anchors are inside bodies

/// Draws hidden parts faintly first, then visible ones.
function drawMarks(sight) {
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  for (const hidden of [true, false]) {
    gl.depthFunc(hidden ? gl.GREATER : gl.LESS);
    gl.depthMask(!hidden);
    for (const batch of Object.values(marks)) {
      const faint = batch === marks.anchors ? kAnchorHidden : kHidden;
      use(programs.flat, { worldToClip: sight.worldToClip, strength: hidden ? faint : 1 });
      batch.draw();
    }
  }
  gl.depthMask(true);
  gl.depthFunc(gl.LESS);
  gl.disable(gl.BLEND);
}
