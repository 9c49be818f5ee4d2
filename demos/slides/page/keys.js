// The keys and their actions.

const kKeys = [
  [["Page Down", "click"], "continue: next item, start a waiting film, else next slide"],
  [["Right", "Down"], "next item, else next slide"],
  [["Left", "Up", "Page Up"], "back: hide the last item, else previous slide"],
  [["Home", "End"], "first / last slide"],
  [["5", "Enter"], "to slide 5"],
  [["Space"], "play or pause the film; after its end, next slide"],
  [["k"], "play or pause the film"],
  [[",", "."], "one frame back / forward"],
  [["0"], "the film's first frame"],
  [["[", "]"], "film slower / faster"],
  [["n"], "notes; also printed while shown"],
  [["s"], "a window for the speaker"],
  [["o"], "all slides"],
  [["f"], "full screen"],
  [["b"], "black"],
];

const kActions = {
  PageDown: goOn, " ": space, ArrowRight: next, ArrowDown: next,
  ArrowLeft: back, ArrowUp: back, PageUp: back, Backspace: back,
  Home: () => show(0), End: () => show(leaves.length - 1),
  k: toggleFilm, ",": () => stepFilm(-1), ".": () => stepFilm(1), "[": () => changeSpeed(-1),
  "]": () => changeSpeed(1), n: toggleNotes, s: openSpeaker, o: toggleOverview, f: toggleFullScreen,
  b: () => { byId("black").hidden = !byId("black").hidden; tellSpeaker(); }, "?": showHelp,
};

const kInOverview = {
  ArrowDown: () => show(view.at + columns()), ArrowUp: () => show(view.at - columns()),
  Enter: toggleOverview, " ": toggleOverview, Escape: toggleOverview,
};

function showHelp() {
  const list = document.createElement("dl");
  for (const [keys, what] of kKeys) {
    const dt = document.createElement("dt"), dd = document.createElement("dd");
    for (const name of keys) {
      const kbd = document.createElement("kbd");
      kbd.textContent = name;
      dt.append(kbd, " ");
    }
    dd.textContent = what;
    list.append(dt, dd);
  }
  const title = document.createElement("strong");
  title.textContent = "Keys";
  byId("help").replaceChildren(title, list);
  byId("help").showModal();
}

/// Digits are the number of a slide; 0 alone is the film's first frame.
function digit(key) {
  if (key === "0" && !view.digits) return rewindFilm();
  view.digits = (view.digits + key).slice(-4);
  say(`to slide ${view.digits}: Enter`, 4000);
}

function enterDigits() {
  const number = Number(view.digits);
  view.digits = "";
  say("");
  show(number - 1);
}

/// Performs the key's action; returns whether it has one.
function press(key, shift = false) {
  if (/^[0-9]$/.test(key)) { digit(key); return true; }
  if (key === "Enter" && view.digits) { enterDigits(); return true; }
  view.digits = "";
  if (key === " " && shift) { back(); return true; }
  const action = (inOverview() && kInOverview[key]) || kActions[key.length === 1 ? key.toLowerCase() : key];
  if (action) action();
  return Boolean(action);
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || byId("help").open) return;
  if (event.target.closest?.("a, button") && [" ", "Enter"].includes(event.key)) return;
  const own = ["n", "f", "?", "o"].includes(event.key);
  if (speaks && !own) {
    tellTalk({ key: event.key, shift: event.shiftKey });
    event.preventDefault();
  } else if (press(event.key, event.shiftKey)) {
    event.preventDefault();
  }
}
