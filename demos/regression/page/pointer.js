// The viewer's buttons, mouse and wheel.

const kBlink = 600;  // ms

function modeInput() {
  const slides = { 2: "split", 4: "share" }[view.mode];
  if (!slides) return null;
  const input = make("input", {
    type: "range", min: 0, max: 1, step: 0.01, value: mixed[slides], "aria-label": slides,
  });
  input.addEventListener("input", () => {
    mixed[slides] = Number(input.value);
    draw();
  });
  return input;
}

function switchButton(text, title, on, onclick, disabled = false) {
  return make("button",
    { class: on ? "on" : "", title, onclick, disabled, "aria-pressed": String(on) }, text);
}

/// As in WAI-ARIA's tabs: only the chosen one is in the order of Tab, arrows go to the others.
function modeTab([key, name]) {
  const on = Number(key) === view.mode;
  return make("button", {
    class: on ? "on" : "", role: "tab", id: `mode-${key}`, "aria-selected": String(on),
    "aria-controls": "stage", tabindex: on ? 0 : -1, onclick: () => setMode(Number(key)),
  }, make("small", {}, `${key} `), name);
}

function showModes() {
  const tabs = byId("tabs"), focused = tabs.contains(document.activeElement);
  tabs.replaceChildren(...Object.entries(modes).map(modeTab));
  if (focused) tabs.querySelector(".on").focus();
  byId("stage").setAttribute("aria-labelledby", `mode-${view.mode}`);
  byId("tools").replaceChildren(modeInput() ?? "",
    switchButton("Worst window", "W", view.worst, toggleWorst, !pictureNow()?.difference),
    switchButton("Loupe", "L", view.loupe, toggleLoupe));
}

function onTabKey(event) {
  const count = Object.keys(modes).length;
  const mode = {
    ArrowRight: view.mode % count + 1, ArrowLeft: (view.mode + count - 2) % count + 1,
    Home: 1, End: count,
  }[event.key];
  if (!mode || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  setMode(mode);
}

/// Alternates the two pictures in Blink mode; B flips them by hand.
function setTimer() {
  clearInterval(mixed.timer);
  if (view.mode === 3)
    mixed.timer = setInterval(() => { mixed.blinkActual = !mixed.blinkActual; draw(); }, kBlink);
}

function setMode(mode) {
  view.mode = mode;
  setTimer();
  showModes();
  draw();
  writeLink();
  byId("viewer").scrollIntoView({ block: "nearest" });
}

function flip() {
  if (view.mode !== 3) setMode(3);
  clearInterval(mixed.timer);
  mixed.blinkActual = !mixed.blinkActual;
  draw();
}

const onStage = (event) => {
  const box = byId("canvas").getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
};

function pointAt(event) {
  const size = pictureSize(), [x, y] = pixelUnder(...onStage(event)).map(Math.floor);
  view.at = size && x >= 0 && y >= 0 && x < size.width && y < size.height ? [x, y] : null;
}

function dragged(event, from) {
  const [x, y] = onStage(event);
  if (from.split) mixed.split = Math.min(1, Math.max(0, x / stageSize()[0]));
  else Object.assign(lens, {
    x: from.lens[0] - (x - from.x) / lens.zoom, y: from.lens[1] - (y - from.y) / lens.zoom,
    fitted: false,
  });
}

function listenToPointer() {
  byId("tabs").addEventListener("keydown", onTabKey);
  const canvas = byId("canvas");
  let from = null;
  canvas.addEventListener("pointerdown", (event) => {
    const [x, y] = onStage(event);
    const split = view.mode === 2 && Math.abs(x - stageSize()[0] * mixed.split) < 14;
    from = { x, y, split, lens: [lens.x, lens.y] };
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointerup", () => { from = null; });
  canvas.addEventListener("pointermove", (event) => {
    if (from) dragged(event, from);
    pointAt(event);
    from ? draw() : (showReadout(), drawLoupe());
  });
  canvas.addEventListener("pointerleave", () => { view.at = null; showReadout(); drawLoupe(); });
  canvas.addEventListener("dblclick", (event) =>
    lens.fitted ? zoomAbout(8 / lens.zoom, ...onStage(event)) : (fit(), draw()));
  canvas.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return;  // without Ctrl the wheel scrolls the page
    event.preventDefault();
    zoomAbout(Math.exp(-event.deltaY / 300), ...onStage(event));
  }, { passive: false });
}
