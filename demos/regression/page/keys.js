// The keys, and the help that lists them.

const keyHelp = [
  ["J K", "next / previous picture"], ["N Shift+N", "next / previous scene"],
  ["1 ... 9", "side by side, slider, blink, overlay, difference, signed \u00d716, heat map, " +
    "baseline, actual"],
  ["B", "blink by hand"], ["[ ]", "move the slider, mix the overlay"],
  ["W", "zoom to the worst window and back"], ["L", "loupe at the pointer"],
  ["+ - 0", "zoom in / out, show the whole picture; also Ctrl and wheel, drag, double click"],
  ["A", "accept the picture"], ["P", "accept the physics only"],
  ["Shift+A", "accept the whole scene"],
  ["C", "copy the command"],
  ["D", "film: go to the first step that differs"], [", .", "film: one step back / forward"],
  ["Space", "film: play / pause"], ["?", "this help"],
];

function mix(by) {
  const what = { 2: "split", 4: "share" }[view.mode];
  if (!what) return;
  mixed[what] = Math.min(1, Math.max(0, mixed[what] + by));
  showModes();
  draw();
}

function toPicture(by) {
  const count = sceneNow()?.pictures.length ?? 0, place = view.picture + by;
  if (place >= 0 && place < count) choose(view.scene, place);
}

function toScene(by) {
  const order = listOrder(), place = order[order.indexOf(view.scene) + by];
  if (place !== undefined) choose(place);
}

const middle = () => stageSize().map((side) => side / 2);

const keyActions = {
  j: () => toPicture(1), k: () => toPicture(-1), n: () => toScene(1), N: () => toScene(-1),
  b: flip, w: toggleWorst, l: toggleLoupe,
  "[": () => mix(-0.05), "]": () => mix(0.05),
  "+": () => zoomAbout(1.5, ...middle()), "=": () => zoomAbout(1.5, ...middle()),
  "-": () => zoomAbout(1 / 1.5, ...middle()), 0: () => { fit(); draw(); },
  a: acceptPicture, A: acceptScene, p: acceptPhysics, c: copyCommand,
  d: seekFirst, ",": () => stepFilm(-1), ".": () => stepFilm(1), " ": playFilm,
  "?": showHelp,
};

function showHelp() {
  const help = byId("help");
  if (help.open) return help.close();
  const cap = (key) => (key === "..." ? " \u2026 " : make("kbd", {}, key));
  const rows = keyHelp.flatMap(([keys, text]) => [
    make("dt", {}, ...keys.split(" ").map(cap)), make("dd", {}, text)]);
  help.replaceChildren(make("h2", {}, "Keys"), make("dl", {}, ...rows));
  help.showModal();
}

/// Ignores Caps Lock: a letter without Shift is lower case.
function keyOf(event) {
  return /^[a-zA-Z]$/.test(event.key) && !event.shiftKey ? event.key.toLowerCase() : event.key;
}

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const key = keyOf(event);
  if (byId("help").open && key !== "?") return;
  if (key === " " && event.target.closest?.("button, summary")) return;  // Space presses it
  const action = modes[key] && key !== "0" ? () => setMode(Number(key)) : keyActions[key];
  if (!action || !sceneNow()) return;
  event.preventDefault();
  action();
}
