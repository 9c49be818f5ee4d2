// Chooses a scene and a picture; at first those in the link.

/// Shows a picture of a scene and all that depends on it; the film goes to the picture's time.
function choose(scene, picture = firstPicture(report.scenes[scene])) {
  const other = scene !== view.scene;
  view.scene = scene;
  view.picture = picture;
  view.film = pictureNow()?.time ?? 0;
  view.worst = false;
  if (!view.loupe) view.at = null;
  if (other) byId("scene").scrollTop = 0;
  show(other);
  writeLink();
}

function show(otherScene) {
  showList();
  if (!sceneNow()) return null;
  showPictures();
  if (otherScene) {
    showHead();
    showVerdict();
  }
  showFilm();
  showModes();
  return showViewer();
}

async function showViewer() {
  const picture = pictureNow();
  byId("viewer").hidden = !picture;
  if (!picture) return;
  const key = pair.key = picture.name;
  const [baseline, actual] = await Promise.all(
    [loadImage(picture.baseline_image), loadImage(picture.actual_image)]);
  if (pair.key !== key) return;  // another picture was chosen meanwhile
  Object.assign(pair, { baseline, actual, drawn: new Map() });
  lens.fitted = true;
  fit();
  if (view.worst && picture.difference) lookAtWorst(picture.difference.window_at);
  setTimer();
  draw();
}

async function start() {
  showTop();
  byId("help-button").addEventListener("click", showHelp);
  byId("copy").addEventListener("click", copyCommand);
  document.addEventListener("keydown", onKey);
  new ResizeObserver(draw).observe(byId("stage"));
  new ResizeObserver(drawFilm).observe(byId("film-body"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", drawFilm);
  listenToPointer();
  listenToFilm();
  await openLink();
}

async function openLink() {
  const asked = location.hash;
  delete document.body.dataset.ready;
  readLink();
  document.title = sceneNow() ? `${sceneNow().name} \u2013 impulse test` : "impulse test";
  const shown = show(true);
  showAccepted();
  await shown;
  if (asked.includes("mode=")) byId("viewer").scrollIntoView({ block: "nearest" });
  if (asked.includes("film=")) byId("film").scrollIntoView({ block: "nearest" });
  document.body.dataset.ready = "1";
}

window.addEventListener("hashchange", openLink);
start();
