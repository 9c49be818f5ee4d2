// Everything is read, and the first picture drawn; what the link says, first.

function tell(trouble) {
  byId("trouble").textContent = trouble;
  byId("trouble").hidden = false;
}

function listen() {
  listenToPlay();
  listenToPointer();
  listenToCurves();
  document.addEventListener("keydown", onKey);
  new ResizeObserver(show).observe(canvas);  // before it is seen at its new size
  darkly.addEventListener("change", changed);
  window.addEventListener("hashchange", () => {
    readLink();
    followed = null;
    changed();
  });
  canvas.addEventListener("webglcontextlost", () => tell("The graphics driver gave up; load the page again."));
}

async function start() {
  showFixedWords();
  if (!gl) return tell("This browser has no WebGL 2, which draws the picture; a browser of 2021 or later has, where its graphics are on.");
  if (typeof DecompressionStream === "undefined") return tell("This browser cannot unpack the run; one of 2023 or later can.");
  await decode();
  makeKinds();
  makeLight();
  makeMarks();
  readLink();
  listen();
  changed();
}

start().catch((error) => {
  tell(`The run cannot be shown: ${error.message}`);
  throw error;
});
