// The chosen picture in nine modes, which share their zoom and position.

const modes = {
  1: "Side by side", 2: "Slider", 3: "Blink", 4: "Overlay", 5: "Difference",
  6: "Signed \u00d716", 7: "Heat map", 8: "Baseline", 9: "Actual",
};

const pair = { baseline: null, actual: null, drawn: new Map(), key: "" };
const lens = { zoom: 1, x: 0, y: 0, fitted: true };  // CSS pixels per pixel; the centre, pixels
const mixed = { split: 0.5, share: 0.5, blinkActual: false, timer: 0 };

const stageSize = () => [byId("stage").clientWidth, byId("stage").clientHeight];
const pictureSize = () => pair.actual ?? pair.baseline;

/// Each is [x, y, width, height] on the stage, CSS pixels.
function panes() {
  const [width, height] = stageSize();
  if (view.mode !== 1) return [[0, 0, width, height]];
  const half = Math.floor(width / 2) - 1;
  return [[0, 0, half, height], [half + 2, 0, width - half - 2, height]];
}

function fit() {
  const size = pictureSize(), [, , width, height] = panes()[0];
  if (!size) return;
  Object.assign(lens, {
    zoom: Math.min(width / size.width, height / size.height), x: size.width / 2, y: size.height / 2,
    fitted: true,
  });
}

/// Zooms about a point of the stage, which keeps its position.
function zoomAbout(factor, x, y) {
  const zoom = Math.min(48, Math.max(0.1, lens.zoom * factor)), at = pixelUnder(x, y);
  const pane = paneUnder(x);
  Object.assign(lens, { zoom, fitted: false });
  lens.x = at[0] - (x - pane[0] - pane[2] / 2) / zoom;
  lens.y = at[1] - (y - pane[1] - pane[3] / 2) / zoom;
  draw();
}

const paneUnder = (x) => panes().find((pane) => x < pane[0] + pane[2]) ?? panes().at(-1);

/// From the stage to pixels of the picture, not rounded.
function pixelUnder(x, y) {
  const pane = paneUnder(x);
  return [lens.x + (x - pane[0] - pane[2] / 2) / lens.zoom,
    lens.y + (y - pane[1] - pane[3] / 2) / lens.zoom];
}

/// From a pixel of the picture to its upper left corner on the stage.
function placeOf(pane, x, y) {
  return [pane[0] + pane[2] / 2 + (x - lens.x) * lens.zoom,
    pane[1] + pane[3] / 2 + (y - lens.y) * lens.zoom];
}

function whyNotComputed() {
  if (!pair.baseline) return "no baseline: nothing to compare with";
  if (!pair.actual) return "no actual picture: nothing to compare with";
  if (pair.baseline.width !== pair.actual.width || pair.baseline.height !== pair.actual.height)
    return `the sizes differ: ${pair.baseline.width} x ${pair.baseline.height} and ` +
      `${pair.actual.width} x ${pair.actual.height}`;
  if (!pair.baseline.pixels || !pair.actual.pixels)
    return "linked, not embedded: a page opened from a file cannot read its pixels; " +
      "use Blink or Slider";
  return "";
}

function computed(mode) {
  if (!pair.drawn.has(mode)) {
    const levels = sceneNow().snapshot.gate.levels;
    const paint = {
      5: (out, a, b) => drawDifference(out, a, b, levels), 6: drawSigned, 7: drawHeat,
    }[mode];
    pair.drawn.set(mode, painted(pair.baseline, pair.actual, paint));
  }
  return pair.drawn.get(mode);
}

/// The mode that the available pictures allow, and a note if it is not the chosen one.
function modeShown() {
  if (view.mode === 1 || view.mode >= 8) return [view.mode, ""];
  const why = whyNotComputed(), single = pair.actual ? 9 : 8;
  if (!pair.baseline || !pair.actual) return [single, why];
  if (view.mode >= 5 && why !== "") return [9, why];
  return [view.mode, ""];
}

function clipTo(context, [x, y, width, height], paint) {
  context.save();
  context.beginPath();
  context.rect(x, y, width, height);
  context.clip();
  paint();
  context.restore();
}

function drawInto(context, pane, source) {
  const [x, y] = placeOf(pane, 0, 0);
  context.imageSmoothingEnabled = lens.zoom < 1;
  context.imageSmoothingQuality = "high";
  context.drawImage(source, x, y, (source.naturalWidth ?? source.width) * lens.zoom,
    (source.naturalHeight ?? source.height) * lens.zoom);
}

function tag(context, pane, text, color, right = false) {
  context.font = "600 12px system-ui, sans-serif";
  const width = context.measureText(text).width + 16;
  const x = right ? pane[0] + pane[2] - width - 8 : pane[0] + 8;
  context.fillStyle = "#101316cc";
  context.fillRect(x, pane[1] + 8, width, 22);
  context.fillStyle = color;
  context.fillText(text, x + 8, pane[1] + 23);
}

const kTags = { baseline: ["baseline", "#8fc1f5"], actual: ["actual", "#ffb377"] };

function drawOne(context, pane, which, right = false) {
  if (pair[which]) clipTo(context, pane, () => drawInto(context, pane, pair[which].image));
  const [name, color] = kTags[which];
  tag(context, pane, pair[which] ? name : `${name}: missing`, color, right);
}

function drawSlider(context, pane) {
  const [x, y, width, height] = pane, at = x + Math.round(width * mixed.split);
  const left = [x, y, at - x, height], right = [at, y, x + width - at, height];
  clipTo(context, left, () => drawInto(context, pane, pair.baseline.image));
  clipTo(context, right, () => drawInto(context, pane, pair.actual.image));
  tag(context, pane, ...kTags.baseline);
  tag(context, pane, ...kTags.actual, true);
  context.fillStyle = "#ffffff";
  context.fillRect(at - 1, y, 2, height);
  context.beginPath();
  context.arc(at, y + height / 2, 9, 0, 7);
  context.fill();
}

function drawOverlay(context, pane) {
  clipTo(context, pane, () => {
    drawInto(context, pane, pair.baseline.image);
    context.globalAlpha = mixed.share;
    drawInto(context, pane, pair.actual.image);
  });
  const words = `baseline ${percent(1 - mixed.share)}, actual ${percent(mixed.share)}`;
  tag(context, pane, words, "#eef1f4");
}

const kComputedTags = {
  5: ["red: beyond the gate's levels, yellow: less", "#eef1f4"],
  6: ["128 + 16 (actual - baseline)", "#eef1f4"],
};

function drawComputed(context, pane, mode) {
  clipTo(context, pane, () => drawInto(context, pane, computed(mode)));
  if (mode === 7) drawHeatScale(context, pane);
  else tag(context, pane, ...kComputedTags[mode]);
}

function drawHeatScale(context, pane) {
  const [x, y] = [pane[0] + 8, pane[1] + 8];
  context.fillStyle = "#101316cc";
  context.fillRect(x, y, 236, 22);
  for (let i = 0; i < 100; ++i) {
    context.fillStyle = `rgb(${heatColor(i / 99).map(Math.round).join(",")})`;
    context.fillRect(x + 62 + i, y + 6, 1, 10);
  }
  context.fillStyle = "#eef1f4";
  context.font = "600 12px system-ui, sans-serif";
  context.fillText("unseen", x + 8, y + 15);
  context.fillText("obvious", x + 172, y + 15);
}

function drawMode(context, mode) {
  const [first, second] = panes();
  if (mode === 1) {
    drawOne(context, first, "baseline");
    drawOne(context, second ?? first, "actual");
  } else if (mode === 2) drawSlider(context, first);
  else if (mode === 3) drawOne(context, first, mixed.blinkActual ? "actual" : "baseline");
  else if (mode === 4) drawOverlay(context, first);
  else if (mode <= 7) drawComputed(context, first, mode);
  else drawOne(context, first, mode === 8 ? "baseline" : "actual");
}

/// Black and white, so that it is visible on any picture.
function drawWorst(context) {
  const at = pictureNow()?.difference?.window_at;
  if (!at || !view.worst) return;
  for (const pane of panes())
    clipTo(context, pane, () => {
      const [x, y] = placeOf(pane, at[0], at[1]), side = 16 * lens.zoom;
      context.lineWidth = 4;
      context.strokeStyle = "#000000";
      context.strokeRect(x - 2, y - 2, side + 4, side + 4);
      context.lineWidth = 2;
      context.strokeStyle = "#ffffff";
      context.strokeRect(x - 2, y - 2, side + 4, side + 4);
    });
}

function draw() {
  const canvas = byId("canvas"), [width, height] = stageSize(), dense = devicePixelRatio;
  canvas.width = Math.round(width * dense);
  canvas.height = Math.round(height * dense);
  const context = canvas.getContext("2d");
  context.scale(dense, dense);
  if (lens.fitted) fit();
  const [mode, note] = modeShown();
  drawMode(context, mode);
  drawWorst(context);
  byId("note").textContent = note;
  byId("note").hidden = note === "";
  showReadout();
  drawLoupe();
  document.body.dataset.drawn = `${mode} ${pictureNow()?.name ?? ""}`;
}

/// Zooms to the worst window, or back to the whole picture.
function toggleWorst() {
  const at = pictureNow()?.difference?.window_at;
  if (!at) return;
  view.worst = !view.worst;
  view.worst ? lookAtWorst(at) : fit();
  showModes();
  draw();
  writeLink();
}

function lookAtWorst(at) {
  Object.assign(lens, { zoom: Math.max(8, lens.zoom), x: at[0] + 8, y: at[1] + 8, fitted: false });
}
