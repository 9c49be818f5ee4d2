// From slide to slide.

/// `part`: how many of the slide's parts are shown.
function show(at, part = 0) {
  const before = leafNow();
  view.at = within(at, 0, leaves.length - 1);
  showParts(at < leaves.length ? part : Infinity);  // beyond the end, the last slide stays as it is
  const entered = before !== leafNow() || !before.classList.contains("seen");
  before.classList.remove("seen");
  leafNow().classList.add("seen");
  byId("course").firstElementChild.style.width = `${100 * (view.at + 1) / leaves.length}%`;
  byId("black").hidden = true;
  showNotes();
  if (entered) enter();
  if (!speaks) writeLink();
  tellSpeaker();
}

function enter() {
  say("");
  stopFilms();
  loadFilms();
  if (document.body.classList.contains("overview")) {
    leafNow().scrollIntoView({ block: "nearest" });
    return;
  }
  enterFilm();
  leafNow().querySelector("h1, h2")?.focus({ preventScroll: true });
  if (speaks) showNext();
}

function showParts(part) {
  const parts = partsOf(leafNow());
  view.part = within(part, 0, parts.length);
  parts.forEach((item, i) => item.classList.toggle("later", i >= view.part));
}

const inOverview = () => document.body.classList.contains("overview");

/// Shows the next part of the slide; returns whether there was one.
function showNextPart() {
  if (inOverview() || view.part >= partsOf(leafNow()).length) return false;
  showParts(view.part + 1);
  tellSpeaker();
  return true;
}

/// The next part, else the next slide.
function next() {
  if (!showNextPart()) show(view.at + 1);
}

/// Hides the last part, else goes to the previous slide, all of whose parts are shown.
function back() {
  if (inOverview() || view.part === 0) return show(view.at - 1, view.at > 0 ? Infinity : 0);
  showParts(view.part - 1);
  tellSpeaker();
}

/// The action of a presenter's remote and of a click: the next part, else starts a waiting film,
/// else the next slide.
function goOn() {
  if (showNextPart()) return;
  const film = filmNow();
  if (waits(film)) return play(film);
  show(view.at + 1);
}

/// The action of the space bar: plays or pauses a film that has not ended, else next().
function space() {
  const film = filmNow();
  if (film && !ended(film)) return toggleFilm();
  next();
}

function showNotes() {
  const notes = leafNow().querySelector(".notes");
  const words = notes ? [...notes.cloneNode(true).childNodes] : ["no notes"];
  byId("notes").replaceChildren(...words);
}

function toggleNotes() {
  byId("notes").hidden = !byId("notes").hidden;
  document.body.classList.toggle("noted", !byId("notes").hidden);  // printed too
  fitStage();
}

/// #5 is the fifth slide; writing it adds no entry to the browser's history.
function writeLink() {
  const link = `#${view.at + 1}`;
  if (location.hash !== link) history.replaceState(null, "", link);
}

function readLink() {
  const number = Number(location.hash.slice(1));
  return Number.isInteger(number) && number > 0 ? number - 1 : 0;
}

function toggleOverview() {
  const on = document.body.classList.toggle("overview");
  stopFilms();
  fitStage();
  if (on) leafNow().scrollIntoView({ block: "center" });
  else enter();
}

/// The number of slides in a row of the overview.
function columns() {
  const top = leaves[0].getBoundingClientRect().top;
  const next = leaves.findIndex((leaf) => leaf.getBoundingClientRect().top > top + 1);
  return next < 0 ? leaves.length : next;
}

function toggleFullScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else document.documentElement.requestFullscreen?.().catch(() => say("this browser refuses full screen"));
}
