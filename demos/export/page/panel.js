// Texts over and under the picture: caption, legend, body, names, buttons.

const kLayerTexts = {
  contacts: ["Contacts", "points where bodies push each other (C)"],
  normals: ["Normals", "normals of the contacts (N)"],
  impulses: ["Impulses", "of the last step along the normals, N s (I)"],
  friction: ["Friction", "impulses across the normals, N s (K)"],
  joints: ["Joints", "anchors: dark on the first body, blue on the second (J)"],
  trails: ["Trails", "paths of the last three seconds (T)"],
  names: ["Names", "names of the bodies (B)"],
};

function showToggles() {
  const toggle = (name) => {
    const [text, title] = kLayerTexts[name];
    const on = view.show.has(name), onclick = () => toggleLayer(name);
    return make("button", { class: on ? "on" : "", title, "aria-pressed": String(on), onclick }, text);
  };
  const useful = kLayers.filter((name) => name !== "joints" || data.joints.length > 0);
  byId("toggles").replaceChildren(...useful.map(toggle), make("span", { class: "gap" }),
    make("button", { class: view.curves ? "on" : "", title: "curves under the picture (G)", onclick: toggleCurves }, "Curves"),
    make("button", { title: "follow the chosen body (F)", class: view.follow ? "on" : "", disabled: view.body < 0, onclick: toggleFollow }, "Follow"),
    make("button", { title: "back to the scene's camera (R)", disabled: view.camera === null, onclick: resetCamera }, "Reset view"),
    make("button", { title: "keys (?)", onclick: showHelp }, "?"));
}

function toggleLayer(name) {
  if (!view.show.delete(name)) view.show.add(name);
  changed();
}

function toggleCurves() {
  view.curves = !view.curves;
  changed();
}

/// The section that a frame is in; null before the first.
function sectionNow() {
  const seconds = secondsAt(frameNow()) + 1e-9;
  return data.sections.filter((section) => section.at <= seconds).at(-1) ?? null;
}

function captionNow() {
  const seconds = secondsAt(frameNow()) + 1e-9;
  const told = data.sections.filter((section) => section.at <= seconds && section.caption !== "");
  return told.at(-1)?.caption ?? "";
}

function showMarks() {
  byId("marks").replaceChildren(...data.sections.map((section) => {
    const name = section.name || section.caption, onclick = () => seek(Math.round(section.at * data.fps));
    const mark = make("button", { title: section.caption || name, "aria-label": `to ${name}`, onclick });
    mark.style.left = `${100 * Math.min(1, section.at * data.fps / Math.max(lastFrame, 1))}%`;
    return mark;
  }));
}

/// The largest number of 1, 2 or 5 times a power of ten that is not above x.
function roundBelow(x) {
  const decade = 10 ** Math.floor(Math.log10(x * (1 + 1e-9)));
  return decade * ([5, 2].find((step) => step * decade <= x * (1 + 1e-9)) ?? 1);
}

/// A sample arrow, as long as it would be at the point the camera looks at.
function arrowSample(sight, name, label) {
  const { perUnit, peak } = arrowScale(), value = peak > 0 ? roundBelow(0.8 * peak) : 0;
  const pixels = value * perUnit / pixelAt(sight, sight.at), sample = make("i", { class: `arrow ${name}` });
  sample.style.width = `${Math.max(8, Math.min(pixels, 160))}px`;
  const scale = pixels > 160 ? ` (not to scale)` : "";
  return make("div", {}, sample, make("span", {}, value > 0 ? `${label} ${short(value)} N s${scale}` : `${label}: none now`));
}

const legendRow = (sign, text) => make("div", {}, make("i", { class: sign }), make("span", {}, text));

function showLegend(sight) {
  const rows = [], { show } = view, pushing = contacts[frameNow()].length;
  const there = data.joints.filter((joint) => joint.until >= frameNow()).length;
  if (show.has("contacts")) rows.push(legendRow("spot contacts", plural(pushing, "contact that pushes", "contacts that push")));
  if (show.has("normals")) rows.push(legendRow("arrow normals", "normal"));
  if (show.has("impulses")) rows.push(arrowSample(sight, "impulses", "impulse"));
  if (show.has("friction")) rows.push(arrowSample(sight, "friction", "friction"));
  if (show.has("joints") && data.joints.length > 0) rows.push(legendRow("spot joints", plural(there, "joint", "joints")));
  byId("legend").hidden = rows.length === 0;
  byId("legend").replaceChildren(...rows);
}

function showInfo() {
  const info = byId("info"), body = data.bodies[view.body];
  info.hidden = !body;
  if (!body) return;
  const { at, speed } = poses[view.body], row = (name, value) => [make("dt", {}, name), make("dd", {}, value)];
  info.replaceChildren(make("h2", {}, body.name), make("dl", {},
    ...row("position", `${at.map((x) => fixed(x, 3)).join(", ")} m`), ...row("speed", `${fixed(speed, 3)} m/s`),
    ...row("mass", body.mass > 0 ? `${short(body.mass, 4)} kg` : "not moved by forces")));
}

/// The nearest bodies' names, without overlaps.
function showNames(sight) {
  const { clientWidth: width, clientHeight: height } = canvas, placed = [];
  const names = view.show.has("names") ? data.bodies.map((body, i) => [project(sight, poses[i].at, width, height), body]) : [];
  const seen = names.filter(([[x, y, depth], body]) => body.parts.length > 0 && depth > 0 && x > 0 && x < width && y > 0 && y < height);
  seen.sort(([a], [b]) => a[2] - b[2]);
  const free = ([x, y]) => placed.every(([px, py]) => Math.abs(px - x) > 60 || Math.abs(py - y) > 16);
  const shown = seen.filter(([place]) => placed.length < 80 && free(place) && placed.push(place));
  byId("labels").replaceChildren(...shown.map(([[x, y], body]) => {
    const label = make("span", {}, body.name);
    label.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
    return label;
  }));
}

function showWords(sight) {
  const frame = frameNow();
  byId("now").textContent = `${secondsAt(frame).toFixed(3)} s`;
  byId("now").title = `frame ${frame} of ${lastFrame}`;
  byId("time").value = frame;
  byId("caption").textContent = captionNow();
  byId("caption").hidden = captionNow() === "";
  byId("play-sign").setAttribute("d", view.playing ? "M4 3h3v10H4zM9 3h3v10H9z" : "M4 2.5v11l9-5.5z");
  byId("left-out").textContent = [data.left, qualityNow().note].filter((text) => text !== "").join("; ");
  byId("loop").className = view.loop ? "on" : "";
  byId("speed").value = view.speed;
  document.documentElement.dataset.look = lookNow().ground[0] < 0.4 ? "dark" : "light";
  showLegend(sight);
  showInfo();
  showNames(sight);
}

function showFixedWords() {
  const title = data.title || data.name;
  document.title = `${title} \u2013 impulse replay`;
  byId("title").textContent = title;
  byId("time").max = lastFrame;
  const fractions = { 0.25: "\u00bc", 0.5: "\u00bd" }, nameOf = (speed) => `${fractions[speed] ?? speed}\u00d7`;
  byId("speed").replaceChildren(...kSpeeds.map((speed) => make("option", { value: speed }, nameOf(speed))));
  showMarks();
}
