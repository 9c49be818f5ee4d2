// The accepted items, and the command that accepts them: `impulse approve ...`.

const accepted = new Set();  // names of single items, as `impulse approve` takes them

const kDiffering = ["changed", "new", "broken"];  // kinds of pictures
const physicsName = (scene) => `${scene.name}@physics`;

/// Without a baseline, or with one of another size or step rate, parts cannot be accepted.
const onlyWhole = (scene) => scene.physics.kind === "unknown" ||
  scene.settings.some((change) => ["world.hz", "snapshot.size"].includes(change.key));

/// The names in a scene that can be accepted: the physics if it changed, and every picture that
/// differs. Nothing if an expectation failed: a new baseline does not fix it.
function acceptable(scene) {
  if (scene.state !== "failed" || scene.expectations.some((result) => !result.passed)) return [];
  if (scene.pictures.every((picture) => picture.actual === "")) return [];
  if (onlyWhole(scene)) return [scene.name];
  const physics = scene.physics.kind === "changed" ? [physicsName(scene)] : [];
  const pictures = scene.pictures.filter((p) => kDiffering.includes(p.kind));
  return [...physics, ...pictures.map((picture) => picture.name)];
}

const isAccepted = (scene, picture) => accepted.has(picture.name) || accepted.has(scene.name);

const allAccepted = (scene) => {
  const names = acceptable(scene);
  return names.length > 0 && names.every((name) => accepted.has(name));
};

/// If everything in a scene is accepted, the scene's own name: it covers physics and pictures.
function acceptedNames() {
  return report.scenes.flatMap((scene) =>
    allAccepted(scene) ? [scene.name] : acceptable(scene).filter((name) => accepted.has(name)));
}

function acceptNames(names) {
  accepted.clear();
  for (const scene of report.scenes)
    for (const name of acceptable(scene))
      if (names.includes(scene.name) || names.includes(name)) accepted.add(name);
}

function toggle(names) {
  const on = !names.every((name) => accepted.has(name));
  for (const name of names) on ? accepted.add(name) : accepted.delete(name);
  showAccepted();
}

const acceptScene = () => toggle(acceptable(sceneNow()));

/// Accepts a part of the scene, or the whole scene if parts cannot be accepted.
const acceptPart = (part) => toggle(
  acceptable(sceneNow()).filter((name) => name === part || name === sceneNow().name));
const acceptPhysics = () => acceptPart(physicsName(sceneNow()));
const acceptPicture = () => acceptPart(pictureNow()?.name);

function approveCommand() {
  const names = acceptedNames();
  if (names.length === 0) return "";
  const results = report.results === "" ? "" : ` --results ${shellWord(report.results)}`;
  const baselines =
    report.baselines === "" ? "" : ` --baselines ${shellWord(report.baselines)}`;
  return `impulse approve${results}${baselines} ${names.map(shellWord).join(" ")}`;
}

/// "1 of 4 pictures and 0 of 2 physics accepted", of what can be accepted.
function acceptedText() {
  const open = report.scenes.filter((scene) => acceptable(scene).length > 0);
  const pictures = open.flatMap((scene) => scene.pictures
    .filter((picture) => kDiffering.includes(picture.kind))
    .map((picture) => isAccepted(scene, picture)));
  const physics = open.map(physicsName).filter((name, i) => acceptable(open[i]).includes(name))
    .map((name) => accepted.has(name));
  const count = (list, what) => `${list.filter(Boolean).length} of ${list.length} ${what}`;
  const parts = [count(pictures, pictures.length === 1 ? "picture" : "pictures")];
  if (physics.length > 0) parts.push(count(physics, "physics"));
  return `${parts.join(" and ")} accepted`;
}

function showAccepted() {
  const command = approveCommand(), code = byId("command");
  const open = report.scenes.filter((scene) => acceptable(scene).length > 0);
  byId("accepted").textContent = acceptedText();
  const hint = open.length > 0
    ? "A accepts the picture, Shift+A the scene; the command appears here" : "nothing to accept";
  code.textContent = command === "" ? hint : command;
  code.classList.toggle("idle", command === "");
  byId("copy").disabled = command === "";
  showList();
  showHead();
  showPictures();
  writeLink();
}

/// Uses the clipboard API if the browser allows it for a page from a file, else a selection.
async function copyCommand() {
  try {
    await navigator.clipboard.writeText(approveCommand());
  } catch {
    getSelection().selectAllChildren(byId("command"));
    document.execCommand("copy");
  }
  byId("copy").textContent = "Copied";
  setTimeout(() => { byId("copy").textContent = "Copy"; }, 1500);
}
