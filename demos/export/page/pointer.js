// Mouse and fingers on the picture: drag to orbit, with the right button or two fingers to pan.

const held = new Map();  // pressed pointers: { x, y }
let moved = 0;           // CSS pixels since the first went down

const kTurnAPixel = 0.006;  // rad

function middleOfHeld() {
  const all = [...held.values()], sum = all.reduce((s, p) => [s[0] + p.x, s[1] + p.y], [0, 0]);
  const middle = [sum[0] / all.length, sum[1] / all.length];
  const spread = all.length > 1 ? Math.hypot(all[0].x - all[1].x, all[0].y - all[1].y) : 0;
  return { middle, spread };
}

function dragged(event) {
  const pointer = held.get(event.pointerId);
  if (!pointer) return hover(event);
  const old = middleOfHeld();
  moved += Math.abs(event.offsetX - pointer.x) + Math.abs(event.offsetY - pointer.y);
  Object.assign(pointer, { x: event.offsetX, y: event.offsetY });
  if (moved < 4) return;
  const { middle, spread } = middleOfHeld(), x = middle[0] - old.middle[0], y = middle[1] - old.middle[1];
  if (held.size > 1) {
    pan(x, y);
    if (spread > 0 && old.spread > 0) zoom(old.spread / spread);
  } else if (event.buttons & 6 || event.shiftKey) pan(x, y);
  else orbit(-kTurnAPixel * x, kTurnAPixel * y);
}

/// Shows the name of the body under the mouse.
function hover(event) {
  const label = byId("hover"), body = event.pointerType === "touch" ? -1 : bodyAt(event.offsetX, event.offsetY);
  label.hidden = body < 0;
  if (body < 0) return;
  label.textContent = data.bodies[body].name;
  label.style.left = `${event.offsetX + 14}px`;
  label.style.top = `${event.offsetY + 14}px`;
}

function choose(body) {
  view.body = body;
  if (body < 0) view.follow = false;
  followed = null;
  changed();
}

function listenToPointer() {
  canvas.addEventListener("pointerdown", (event) => {
    if (held.size === 0) moved = 0;
    held.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    canvas.setPointerCapture(event.pointerId);
    byId("hover").hidden = true;
  });
  canvas.addEventListener("pointermove", dragged);
  canvas.addEventListener("pointerup", (event) => {
    held.delete(event.pointerId);
    if (moved < 4 && event.button === 0) choose(bodyAt(event.offsetX, event.offsetY));
  });
  canvas.addEventListener("pointercancel", (event) => held.delete(event.pointerId));
  canvas.addEventListener("pointerleave", () => { byId("hover").hidden = true; });
  canvas.addEventListener("dblclick", toggleFollow);
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY / (event.deltaMode ? 20 : 600)))));
  }, { passive: false });
}
