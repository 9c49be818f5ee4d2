// Reads everything, applies the link and draws the first picture.

function giveUp(trouble) {
  byId("trouble").textContent = trouble;
  byId("trouble").hidden = false;
}

function listen() {
  listenToPlay();
  listenToPointer();
  listenToCurves();
  document.addEventListener("keydown", onKey);
  new ResizeObserver(show).observe(canvas);  // before the new size is visible
  darkly.addEventListener("change", () => changed());
  window.addEventListener("hashchange", () => {
    readLink();
    followed = null;
    changed();
  });
  canvas.addEventListener("webglcontextlost", () => giveUp("The graphics context was lost; reload the page."));
}

async function start() {
  showFixedWords();
  if (!gl) return giveUp("This browser has no WebGL 2, which the page needs; browsers since 2021 have it if graphics acceleration is on.");
  if (typeof DecompressionStream === "undefined") return giveUp("This browser cannot decompress the run; use one of 2023 or later.");
  await decode();
  makeKinds();
  makeLight();
  makeMarks();
  readLink();
  listen();
  changed();
}

start().catch((error) => {
  giveUp(`The run cannot be shown: ${error.message}`);
  throw error;
});
