// Loads the font first: fitting the words depends on it.

async function start() {
  document.body.classList.add("live");
  if (speaks) becomeSpeaker();
  else window.addEventListener("message", hearSpeaker);
  listenToFilms();
  show(readLink());
  document.addEventListener("keydown", onKey);
  byId("room").addEventListener("click", onClick);
  document.addEventListener("mousemove", onMove);
  byId("room").addEventListener("touchstart", onTouch, { passive: true });
  byId("room").addEventListener("touchend", onTouch);
  window.addEventListener("resize", fitStage);
  if (!speaks) window.addEventListener("hashchange", () => show(readLink()));
  new ResizeObserver(fitStage).observe(byId("room"));
  fitStage();
  await document.fonts.load('30px "impulse math"', "x").catch(() => []);
  await document.fonts.ready;
  fitAll();
  if (speaks) showNext();
  document.body.dataset.ready = "1";
}

start();
