// Left: the scenes, grouped by result; top: the number of scenes with each result.

const hasPicture = (scene, ...kinds) => scene.pictures.some((p) => kinds.includes(p.kind));
const withoutBaseline = (scene) =>
  scene.pictures.length > 0 && scene.pictures.every((p) => p.kind === "new");
const physicsOnly = (scene) =>
  scene.physics.kind === "changed" && !hasPicture(scene, "changed", "new", "broken");

const differs = (scene) =>
  scene.physics.kind === "changed" || hasPicture(scene, "changed", "new", "broken");

/// A scene belongs to the first group that takes it.
const groups = [
  { title: "Changed", open: true,
    takes: (s) => s.state === "failed" && differs(s) && !physicsOnly(s) && !withoutBaseline(s) },
  { title: "Physics only", open: true, takes: (s) => s.state === "failed" && physicsOnly(s) },
  { title: "Expectation failed", open: true,
    takes: (s) => s.state === "failed" && !withoutBaseline(s) && !differs(s) },
  { title: "New", open: true,
    takes: (s) => s.state === "new" || (s.state === "failed" && withoutBaseline(s)) },
  { title: "Updated", open: true, takes: (s) => s.state === "updated" },
  { title: "Error", open: true, takes: (s) => s.state === "error" },
  { title: "Passed", open: false, takes: (s) => s.state === "passed" },
];

function groupOf(scene) {
  return groups.findIndex((group) => group.takes(scene));
}

/// Indices in report.scenes, in the order of the list.
function listOrder() {
  return report.scenes.map((scene, i) => i)
    .sort((a, b) => groupOf(report.scenes[a]) - groupOf(report.scenes[b]) || a - b);
}

const firstScene = () => listOrder()[0] ?? 0;

function whatDiffers(scene) {
  if (scene.state === "error") return "error";
  const parts = [];
  if (scene.physics.kind === "changed") parts.push("physics");
  const changed = scene.pictures.filter((p) => p.kind === "changed" || p.kind === "broken").length;
  if (changed > 0) parts.push(`${changed}/${scene.pictures.length} pictures`);
  if (scene.expectations.some((e) => !e.passed)) parts.push("expectation");
  return parts.join(", ") || (scene.cached ? "cached" : "");
}

function sceneRow(place) {
  const scene = report.scenes[place], use = sceneUse(scene);
  const row = make("button", {
    class: `row ${scene.state}${place === view.scene ? " on" : ""}`, title: scene.title,
    "data-scene": scene.name, "aria-current": place === view.scene && "true",
    onclick: () => choose(place),
  }, make("span", { class: "dot" }), make("span", { class: "name" }, scene.name),
    make("span", { class: allAccepted(scene) ? "tick" : "what" },
      allAccepted(scene) ? "\u2713" : use > 0 ? useText(use) : ""));
  const what = whatDiffers(scene);
  if (what !== "") row.append(make("span"), make("span", { class: "what" }, what), make("span"));
  if (use > 0) row.append(make("span"), bar(use, `${useText(use)} of the allowed difference`));
  return row;
}

function groupBlock(group, places) {
  const holdsChosen = places.includes(view.scene);
  const block = make("details", { open: group.open || holdsChosen, "data-group": group.title },
    make("summary", {}, `${group.title} (${places.length})`), ...places.map(sceneRow));
  block.addEventListener("toggle", () => { group.open = block.open; });
  return block;
}

function fileBlock(title, files, hint) {
  return make("details", { open: true, "data-group": title },
    make("summary", {}, `${title} (${files.length})`),
    ...files.map((file) => make("div", { class: "file" }, file)),
    make("div", { class: "hint" }, hint));
}

function showList() {
  const order = listOrder(), list = byId("list"), scroll = list.scrollTop;
  list.replaceChildren();
  groups.forEach((group, i) => {
    const places = order.filter((place) => groupOf(report.scenes[place]) === i);
    if (places.length > 0) list.append(groupBlock(group, places));
  });
  const deleted = report.scenes.flatMap((scene) => scene.orphans);
  if (report.orphans.length > 0)
    list.append(fileBlock("Orphans", report.orphans,
      "baselines without a scene; impulse approve --prune removes them"));
  if (deleted.length > 0)
    list.append(fileBlock("Deleted", deleted,
      "pictures of times that no scene lists; impulse approve --prune removes them"));
  list.scrollTop = scroll;
}

function showTop() {
  byId("counts").replaceChildren(...Object.entries(report.counts)
    .filter(([, count]) => count > 0)
    .map(([state, count]) => make("span", {}, make("b", {}, String(count)), ` ${state}`)));
  const linked = report.images.filter((image) => image.linked).length;
  const machine = [report.renderer, report.pixels].filter((text) => text !== "").join(" \u00b7 ");
  const note = linked > 0
    ? `${linked} pictures are linked, not embedded: keep the results' folder \u00b7 ` : "";
  byId("machine").textContent = note + machine;
  byId("machine").title = report.command;
}
