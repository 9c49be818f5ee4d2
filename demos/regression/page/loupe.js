// The pixels under the pointer, enlarged, and their values in both pictures.

const kLoupePixels = 11, kLoupeZoom = 12;

function valueAt(picture, [x, y]) {
  if (!picture?.pixels || x >= picture.width || y >= picture.height) return null;
  const i = 4 * (y * picture.width + x);
  return [...picture.pixels.data.slice(i, i + 3)];
}

const triple = (values) => (values ? values.map((v) => String(v).padStart(3)).join(" ") : "\u2013");
const signedTriple = (values) =>
  values.map((v) => (v > 0 ? `+${v}` : String(v)).padStart(4)).join(" ");

function valuesText() {
  const before = valueAt(pair.baseline, view.at), after = valueAt(pair.actual, view.at);
  const change = before && after ? signedTriple(after.map((v, i) => v - before[i])) : "\u2013";
  return { before: triple(before), after: triple(after), change };
}

function readoutParts(picture) {
  if (view.at) {
    const { before, after, change } = valuesText();
    const rows = [["x, y", view.at.join(", "), ""], ["baseline", before, "old"],
      ["actual", after, "now"], ["difference", change, ""]];
    return rows.map(([name, text, kind]) =>
      make("span", {}, `${name} `, make("code", { class: kind }, text)));
  }
  if (picture?.problem) return [make("span", {}, picture.problem)];
  if (!picture?.difference) return [];
  const d = picture.difference;
  return [make("span", {}, `${d.differing} pixels differ, by ${d.largest} levels at most; ` +
    gateText(sceneNow(), picture))];
}

function showReadout() {
  const zoom = make("span", { class: "right" }, `${Math.round(100 * lens.zoom)} %`);
  byId("readout").replaceChildren(...readoutParts(pictureNow()), zoom);
}

function drawLoupePane(context, picture, left, color) {
  const side = kLoupePixels * kLoupeZoom, half = (kLoupePixels - 1) / 2;
  context.fillStyle = "#101316";
  context.fillRect(left, 0, side, side);
  if (picture) {
    context.save();
    context.beginPath();
    context.rect(left, 0, side, side);
    context.clip();
    const [x, y] = view.at.map((v) => (half - v) * kLoupeZoom);
    context.drawImage(picture.image, left + x, y,
      picture.width * kLoupeZoom, picture.height * kLoupeZoom);
    context.restore();
  }
  context.strokeStyle = color;
  context.lineWidth = 2;
  context.strokeRect(left + half * kLoupeZoom, half * kLoupeZoom, kLoupeZoom, kLoupeZoom);
}

function drawLoupeText(context, top, width) {
  const values = valuesText();
  context.fillStyle = "#101316";
  context.fillRect(0, top, width, 62);
  context.font = '12px ui-monospace, "DejaVu Sans Mono", monospace';
  [["baseline", values.before, "#8fc1f5"], ["actual", values.after, "#ffb377"],
    ["difference", values.change, "#eef1f4"]].forEach(([name, text, color], i) => {
    context.fillStyle = color;
    context.fillText(`${name.padEnd(12)}${text}`, 8, top + 18 + 18 * i);
  });
}

/// Next to the pixel, and within the stage.
function placeLoupe(loupe, width, height) {
  const pane = panes()[0], [x, y] = placeOf(pane, view.at[0] + 0.5, view.at[1] + 0.5);
  const [stageWidth, stageHeight] = stageSize();
  const left = x + 24 + width < stageWidth ? x + 24 : x - 24 - width;
  loupe.style.left = `${Math.min(stageWidth - width, Math.max(0, left))}px`;
  loupe.style.top = `${Math.min(stageHeight - height, Math.max(0, y - height / 2))}px`;
}

function drawLoupe() {
  const loupe = byId("loupe"), side = kLoupePixels * kLoupeZoom;
  loupe.hidden = !view.loupe || !view.at || !pictureSize();
  if (loupe.hidden) return;
  const width = 2 * side + 2, height = side + 62, dense = devicePixelRatio;
  loupe.width = width * dense;
  loupe.height = height * dense;
  loupe.style.width = `${width}px`;
  const context = loupe.getContext("2d");
  context.scale(dense, dense);
  context.imageSmoothingEnabled = false;
  drawLoupePane(context, pair.baseline, 0, "#8fc1f5");
  drawLoupePane(context, pair.actual, side + 2, "#ffb377");
  drawLoupeText(context, side, width);
  placeLoupe(loupe, width, height);
}

function toggleLoupe() {
  view.loupe = !view.loupe;
  const worst = pictureNow()?.difference?.window_at;
  if (view.loupe && !view.at && worst) view.at = worst.map((v) => v + 8);
  showModes();
  draw();
  writeLink();
}
