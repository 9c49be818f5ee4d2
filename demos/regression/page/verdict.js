// The scene's results as text: physics above the pictures; expectations and settings below.

function acceptButton(text, title, names, action) {
  const on = names.every((name) => accepted.has(name));
  return switchButton(on ? `${text} \u2713` : text, title, on, action);
}

function showHead() {
  const scene = sceneNow();
  if (!scene) return;
  const names = acceptable(scene), physics = names.filter((name) => name === physicsName(scene));
  const right = make("div", { class: "right" });
  if (physics.length > 0 && names.length > 1)
    right.append(acceptButton("Accept physics", "only the physics (P)", physics, acceptPhysics));
  if (names.length > 0)
    right.append(acceptButton("Accept scene", "all of it (Shift+A)", names, acceptScene));
  byId("head").replaceChildren(
    make("h2", {}, scene.name), make("span", { class: "title" }, scene.title),
    make("span", { class: `chip ${scene.state}` }, stateWords[scene.state] ?? scene.state),
    scene.cached ? make("span", { class: "chip" }, "cached: not run") : "", right);
}

/// Used if the verdict has no lines of its own.
const physicsWords = {
  same: "Physics: the same in every step, bit for bit.",
  bits: "Physics: different bits, within the tolerances.",
  changed: "Physics: changed.",
  unknown: "Physics: there is no baseline to compare with.",
};

const levels = { same: "passed", bits: "passed", changed: "failed", unknown: "unknown" };

function physicsCard(scene) {
  const physics = scene.physics, level = levels[physics.kind];
  const lines = physics.lines.length > 0 ? physics.lines : [physicsWords[physics.kind]];
  const card = make("div", { class: `card lines ${level}`, id: "physics" },
    ...lines.map((line, i) => make("div", { class: i === 0 ? "first" : "" }, line)));
  if (physics.kind === "same" || physics.kind === "unknown") return card;
  const limits = scene.snapshot.tolerance;
  const words = `${useText(physics.used)} of the tolerances (${limits.position} m, ` +
    `${limits.angle_deg} deg, ${100 * limits.load} % of a load)${limits.why === "" ? "" : `: ${limits.why}`}`;
  card.append(make("div", { class: "budget" }, bar(physics.used, "largest difference"), words));
  return card;
}

const plainCard = (level, text) =>
  make("div", { class: `card lines ${level}` }, make("div", { class: "first" }, text));

/// A scene that was not run, or has no pictures, has no physics to report.
function outcomeCard(scene) {
  if (scene.state === "error") return null;
  if (scene.cached)
    return plainCard("passed", "Nothing has changed since it passed, so it was not run again.");
  if (scene.pictures.length === 0 && scene.physics.kind === "unknown")
    return plainCard(scene.state, "Only expectations are tested: [snapshot] lists no times.");
  return physicsCard(scene);
}

function expectationRow(result) {
  const value = result.value === null ? "not measured" : `${short(result.value, 4)} ${result.unit}`;
  const worst = result.worst ? ` (${result.worst})` : "";
  return make("tr", { class: result.passed ? "passed" : "failed" },
    make("td", { class: "state" }, result.passed ? "passed" : "failed"),
    make("td", { class: "wide" }, result.text), make("td", { class: "number" }, value + worst),
    make("td", { class: "wide" }, result.why));
}

const tableOf = (heads, rows) =>
  make("table", {}, make("tr", {}, ...heads.map((head) => make("th", {}, head))), ...rows);

function expectationsCard(scene) {
  const all = scene.expectations, failed = all.filter((result) => !result.passed).length;
  if (all.length === 0) return null;
  const says = failed > 0
    ? `${failed} of ${all.length} failed; a baseline cannot fix that, so nothing can be accepted`
    : `all ${all.length} passed`;
  return make("details", { class: "card", open: failed > 0, id: "expectations" },
    make("summary", {}, "Expectations ", make("span", {}, says)),
    tableOf(["", "expected", "measured", "why"], all.map(expectationRow)));
}

function settingRow(change) {
  if (change.baseline === "" && change.actual === "")  // a table that is new or gone
    return make("tr", {}, make("td", { colspan: 3 }, make("code", {}, change.key)));
  const cell = (text, kind) =>
    make("td", { class: "wide" }, make("code", { class: kind }, text === "" ? "not set" : text));
  return make("tr", {}, make("td", {}, make("code", {}, change.key)),
    cell(change.baseline, "old"), cell(change.actual, "now"));
}

function settingsCard(scene) {
  if (scene.settings.length === 0) return null;
  const open = scene.settings.length <= 6;
  return make("details", { class: "card", open, id: "settings" },
    make("summary", {}, "Settings that differ ", make("span", {}, String(scene.settings.length))),
    tableOf(["setting", "baseline", "actual"], scene.settings.map(settingRow)));
}

/// In one line, above the pictures; the table is below them.
function failuresCard(scene) {
  const failed = scene.expectations.filter((result) => !result.passed).length;
  return failed > 0 ? plainCard("failed", `${failed} of ${plural(scene.expectations.length,
    "expectation", "expectations")} failed: see below the pictures`) : null;
}

function showVerdict() {
  const scene = sceneNow(), present = (cards) => cards.filter((card) => card !== null);
  const problem = scene.problem ? plainCard("failed", scene.problem) : null;
  byId("verdict").replaceChildren(...present([problem, outcomeCard(scene), failuresCard(scene)]));
  byId("tables").replaceChildren(...present([expectationsCard(scene), settingsCard(scene)]));
}
