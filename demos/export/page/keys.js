// The keyboard, and its help.

const kKeyHelp = [
  ["Space", "play, pause"], ["Left Right", "one frame back, forward; with Shift ten"], ["Home End", "first, last frame"],
  ["PageUp PageDown", "previous, next section"], ["[ ]", "slower, faster"], ["L", "loop"],
  ["C N I K", "contacts, normals, impulses, friction"], ["J T B", "joints, trails, names"], ["G", "curves"],
  ["W A S D", "orbit; with Shift pan. Or drag; pan with the right button or two fingers"],
  ["+ -", "zoom in, out; also the wheel or two fingers"], ["R", "back to the scene's camera"],
  ["click", "choose a body"], ["F", "follow it; or double-click"], ["Esc", "deselect"], ["?", "this help"],
];
const kKeyTurn = 0.08, kKeyPan = 40;  // rad, CSS pixels

/// To the nearest section before (-1) or after (1).
function toSection(by) {
  const frames = data.sections.map((section) => Math.round(section.at * data.fps)), now = frameNow();
  const target = by > 0 ? frames.find((frame) => frame > now) : frames.filter((frame) => frame < now).at(-1);
  seek(target ?? (by > 0 ? lastFrame : 0));
}

const kKeyActions = {
  " ": togglePlay, ArrowLeft: () => stepFrames(-1), ArrowRight: () => stepFrames(1),
  "Shift+ArrowLeft": () => stepFrames(-10), "Shift+ArrowRight": () => stepFrames(10),
  Home: () => seek(0), End: () => seek(lastFrame), PageUp: () => toSection(-1), PageDown: () => toSection(1),
  "[": () => changeSpeed(-1), "]": () => changeSpeed(1), l: toggleLoop,
  c: () => toggleLayer("contacts"), n: () => toggleLayer("normals"), i: () => toggleLayer("impulses"),
  k: () => toggleLayer("friction"), j: () => toggleLayer("joints"), t: () => toggleLayer("trails"),
  b: () => toggleLayer("names"), g: toggleCurves,
  a: () => orbit(-kKeyTurn, 0), d: () => orbit(kKeyTurn, 0), w: () => orbit(0, kKeyTurn), s: () => orbit(0, -kKeyTurn),
  "Shift+a": () => pan(kKeyPan, 0), "Shift+d": () => pan(-kKeyPan, 0), "Shift+w": () => pan(0, kKeyPan), "Shift+s": () => pan(0, -kKeyPan),
  "+": () => zoom(1 / 1.15), "=": () => zoom(1 / 1.15), "-": () => zoom(1.15), r: resetCamera, f: toggleFollow,
  Escape: () => choose(-1), "?": showHelp,
};

function showHelp() {
  const help = byId("help");
  if (help.open) return help.close();
  const rows = kKeyHelp.flatMap(([keys, text]) => [
    make("dt", {}, ...keys.split(" ").map((key) => make("kbd", {}, key))), make("dd", {}, text)]);
  help.replaceChildren(make("h2", {}, "Keys"), make("dl", {}, ...rows));
  help.showModal();
}

/// Caps Lock does not matter; Shift is part of the name for letters and arrows.
function keyOf({ key, shiftKey }) {
  const named = /^[a-zA-Z]$/.test(key) ? key.toLowerCase() : key;
  return shiftKey && (named !== key || /^([a-z]|Arrow)/.test(named)) ? `Shift+${named}` : named;
}

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest?.("select")) return;
  if (byId("help").open && event.key !== "?") return;
  if (event.key === " " && event.target.closest?.("button")) return;  // Space presses the button
  const action = kKeyActions[keyOf(event)];
  if (!action) return;
  event.preventDefault();
  action();
}
