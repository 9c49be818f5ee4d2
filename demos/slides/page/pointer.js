// Clicks and touch: the left quarter goes back, the rest goes on.

const kSwipe = 50;  // pixels
let touched = null;

function onClick(event) {
  if (event.target.closest("a, button:not(.wait), dialog") || event.button !== 0) return;
  if (!getSelection().isCollapsed) return;  // text is being selected
  const leaf = event.target.closest("#stage > .leaf");
  if (document.body.classList.contains("overview")) {
    if (leaf) show(leaves.indexOf(leaf));
    if (leaf) toggleOverview();
    return;
  }
  const key = event.clientX < innerWidth / 4 ? "PageUp" : "PageDown";
  if (speaks) tellTalk({ key });
  else if (event.target.closest(".frame") && filmNow() && !ended(filmNow())) toggleFilm();
  else press(key);
}

function onTouch(event) {
  const finger = event.changedTouches[0];
  if (event.type === "touchstart") {
    touched = event.touches.length === 1 ? [finger.clientX, finger.clientY] : null;
    return;
  }
  if (!touched || document.body.classList.contains("overview")) return;
  const dx = finger.clientX - touched[0], dy = finger.clientY - touched[1];
  touched = null;
  if (Math.abs(dx) < kSwipe || Math.abs(dx) < Math.abs(dy)) return;
  event.preventDefault();  // no click follows
  const key = dx > 0 ? "PageUp" : "PageDown";
  if (speaks) tellTalk({ key });
  else press(key);
}

let rest = 0;
/// Hides the pointer when it has not moved for a while.
function onMove() {
  document.body.classList.remove("idle");
  clearTimeout(rest);
  rest = setTimeout(() => document.body.classList.add("idle"), 2500);
}
