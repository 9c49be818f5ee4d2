// What the page shows. The link holds all of it: #scene=stack&t=2.5&mode=7&w=1&at=300,200&film=1.2

const report = JSON.parse(document.getElementById("data").textContent);

const view = {
  scene: 0,           // index in report.scenes
  picture: 0,         // index in the scene's pictures
  mode: 1,            // key of modes, viewer.js
  worst: false,       // whether the worst window's box is drawn
  at: null,           // [x, y] of the pixel under the loupe; null: none
  loupe: false,
  film: 0,            // s
};

const sceneNow = () => report.scenes[view.scene];
const pictureNow = () => sceneNow()?.pictures[view.picture];

/// "t=2.5" selects the picture nearest to that time, so a link written by hand need not be exact.
function nearestPicture(scene, time) {
  let best = 0;
  scene.pictures.forEach((picture, i) => {
    if (Math.abs(picture.time - time) < Math.abs(scene.pictures[best].time - time)) best = i;
  });
  return best;
}

function numberOf(text, fallback) {
  const value = Number.parseFloat(text ?? "");
  return Number.isFinite(value) ? value : fallback;
}

function readLink() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const found = report.scenes.findIndex((scene) => scene.name === asked.get("scene"));
  view.scene = found >= 0 ? found : firstScene();
  const scene = sceneNow();
  if (!scene) return;
  view.picture = asked.has("t")
    ? nearestPicture(scene, numberOf(asked.get("t"), 0)) : firstPicture(scene);
  view.mode = Math.min(9, Math.max(1, Math.round(numberOf(asked.get("mode"), 1))));
  view.worst = asked.get("w") === "1";
  const at = (asked.get("at") ?? "").split(",").map(Number);
  view.at = at.length === 2 && at.every(Number.isInteger) ? at : null;
  view.loupe = view.at !== null;
  view.film = numberOf(asked.get("film"), pictureNow()?.time ?? 0);
  acceptNames(asked.getAll("accept"));
}

function writeLink() {
  const scene = sceneNow();
  if (!scene) return;
  const link = new URLSearchParams({ scene: scene.name });
  if (pictureNow()) link.set("t", pictureNow().time);
  link.set("mode", view.mode);
  if (view.worst) link.set("w", "1");
  if (view.loupe && view.at) link.set("at", view.at.join(","));
  if (view.film !== (pictureNow()?.time ?? 0)) link.set("film", view.film.toFixed(3));
  for (const name of acceptedNames()) link.append("accept", name);
  history.replaceState(null, "", "#" + link);
}

/// The first picture that differs, else the first.
function firstPicture(scene) {
  return Math.max(0, scene.pictures.findIndex((p) => p.kind !== "same" && p.kind !== "within"));
}
