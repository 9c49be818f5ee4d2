// What is accepted, and the one command that accepts it: `impulse approve ...`.

const accepted = new Set();  // names as `impulse approve` takes them, of single items

const physicsName = (scene) => `${scene.name}@physics`;

/// Without a baseline, or with one of another size or rate of steps, there is no taking parts.
const onlyWhole = (scene) => scene.physics.kind === "unknown" ||
  scene.settings.some((change) => ["world.hz", "snapshot.size"].includes(change.key));

/// What of a scene can be accepted, as `impulse approve` takes it: its physics where they changed
/// and every picture that has no equal. Nothing where an expectation failed: no baseline mends it.
function acceptable(scene) {
  if (scene.state !== "failed" || scene.expectations.some((result) => !result.passed)) return [];
  if (scene.pictures.every((picture) => picture.actual === "")) return [];
  if (onlyWhole(scene)) return [scene.name];
  const physics = scene.physics.kind === "changed" ? [physicsName(scene)] : [];
  const pictures = scene.pictures.filter((p) => ["changed", "new", "broken"].includes(p.kind));
  return [...physics, ...pictures.map((picture) => picture.name)];
}

const isAccepted = (scene, picture) => accepted.has(picture.name) || accepted.has(scene.name);

const allAccepted = (scene) => {
  const names = acceptable(scene);
  return names.length > 0 && names.every((name) => accepted.has(name));
};

/// The scene's own name where all of it is accepted: it takes the physics with the pictures.
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

/// A part of the scene, or all of it where that is the least that can be accepted.
const acceptPart = (part) => toggle(
  acceptable(sceneNow()).filter((name) => name === part || name === sceneNow().name));
const acceptPhysics = () => acceptPart(physicsName(sceneNow()));
const acceptPicture = () => acceptPart(pictureNow()?.name);

function approveCommand() {
  const names = acceptedNames();
  if (names.length === 0) return "";
  const results = report.results === "" ? "" : ` --results ${shellWord(report.results)}`;
  return `impulse approve${results} ${names.map(shellWord).join(" ")}`;
}

function showAccepted() {
  const command = approveCommand(), code = byId("command");
  const open = report.scenes.filter((scene) => acceptable(scene).length > 0);
  byId("accepted").textContent = `${open.filter(allAccepted).length} of ${open.length} accepted`;
  const hint = open.length > 0
    ? "A accepts the picture, Shift+A the scene: the command grows here" : "nothing to accept";
  code.textContent = command === "" ? hint : command;
  code.classList.toggle("idle", command === "");
  byId("copy").disabled = command === "";
  showList();
  showHead();
  showPictures();
  writeLink();
}

/// The clipboard's own way where the browser allows it to a page from a file; else by selection.
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
