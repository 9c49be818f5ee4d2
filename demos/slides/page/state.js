// The slides in the page, and which of them is shown.

const leaves = [...document.querySelectorAll("#stage > .leaf")];
const slideOf = (leaf) => leaf.querySelector(".slide");
const filmOf = (leaf) => leaf?.querySelector("video[data-film]") ?? null;
const leafNow = () => leaves[view.at];
const filmNow = () => filmOf(leafNow());

/// The parts of a slide that appear one after the other: the items of its lists, if it has `steps`.
const partsOf = (leaf) => leaf.querySelector(".slide.steps") ? [...leaf.querySelectorAll(".text li")] : [];

const speaks = location.hash === "#speaker";
const calm = matchMedia("(prefers-reduced-motion: reduce)");
const view = { at: 0, part: 0, digits: "", speed: 1 };
const within = (value, low, high) => Math.min(Math.max(value, low), high);

let silence = 0;
/// Shows a line at the bottom for `time` ms; 0: until the next one.
function say(text, time = 2500) {
  clearTimeout(silence);
  byId("says").textContent = text;
  byId("says").hidden = !text;
  if (text && time) silence = setTimeout(() => say(""), time);
}
