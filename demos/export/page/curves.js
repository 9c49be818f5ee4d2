// Energy, penetration and separation over time, with the values at the cursor.

const kLeast = 1e-6;  // m: less is rounding error and shows no curve
const touches = data.contacts.counts.some((count) => count > 0) || data.curves.penetration.some((depth) => depth > kLeast);

/// The charts that the run has values for.
const kCharts = [
  { title: "energy", unit: "J", scale: 1, there: true, lines: [["kinetic", "--warm"], ["potential", "--cool"], ["total", "--ink"]] },
  { title: "penetration", unit: "mm", scale: 1000, there: touches, fromZero: true, lines: [["penetration", "--warm"]] },
  { title: "separation of joints", unit: "mm", scale: 1000, there: data.joints.length > 0, fromZero: true, lines: [["separation", "--cool"]] },
].filter((chart) => chart.there);
const kChartMargin = { left: 46, right: 12, top: 22, bottom: 18 };
const kNarrowest = 140;  // CSS pixels, of a chart: narrower ones go below each other

const styleColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// null stands for a value that was not finite.
function rangeOf({ lines, fromZero }) {
  let low = fromZero ? 0 : Infinity, high = fromZero ? kLeast : -Infinity;
  for (const [name] of lines)
    for (const value of data.curves[name]) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  if (high < low) return [0, 1];
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}
kCharts.forEach((chart) => { chart.range = rangeOf(chart); });

const columnsIn = (width) => Math.max(1, Math.min(kCharts.length, Math.floor(width / kNarrowest)));

function chartBox(number, width, height) {
  const columns = columnsIn(width), rows = Math.ceil(kCharts.length / columns), m = kChartMargin;
  const each = { width: width / columns, height: height / rows };
  const left = number % columns * each.width, top = Math.floor(number / columns) * each.height;
  return { left: left + m.left, right: left + each.width - m.right, top: top + m.top, bottom: top + each.height - m.bottom };
}

const chartX = (box, frame) => box.left + (box.right - box.left) * frame / Math.max(lastFrame, 1);

function drawLine(context, box, [low, high], values, color) {
  context.strokeStyle = color;
  context.lineWidth = 1.6;
  context.beginPath();
  values.forEach((value, frame) => {
    if (value === null) return;
    context.lineTo(chartX(box, frame), box.bottom - (box.bottom - box.top) * (value - low) / (high - low));
  });
  context.stroke();
}

function valueText(name, label, chart) {
  const value = data.curves[name][frameNow()];
  const number = value === null ? "\u2013" : short(chart.fromZero && value < kLeast ? 0 : value * chart.scale, 4);
  return chart.lines.length > 1 && label !== "" ? `${label} ${number}` : number;
}

/// The title, and every line's current value in its colour. Without room names are shortened, then
/// the title.
function drawChartTexts(context, box, chart) {
  const kGap = 12, width = box.right - box.left + kChartMargin.left, left = box.right - width, y = box.top - 8;  // pixels
  context.font = kChartFont(12);
  const wideOf = (texts) => texts.reduce((sum, text) => sum + context.measureText(text).width + kGap, -kGap);
  const textsOf = (letters) => chart.lines.map(([name]) => valueText(name, name.slice(0, letters), chart));
  const title = `${chart.title}, ${chart.unit}`;
  const all = [[title, textsOf(20)], [title, textsOf(3)], [chart.unit, textsOf(3)], [chart.unit, textsOf(0)], ["", textsOf(0)]];
  const [word, shown] = all.find(([first, texts]) => wideOf([first, ...texts]) <= width) ?? all.at(-1);
  context.fillStyle = styleColor("--soft");
  context.fillText(word, left, y);
  let right = box.right;
  [...chart.lines.entries()].reverse().forEach(([i, [, color]]) => {
    right -= context.measureText(shown[i]).width;
    context.fillStyle = styleColor(color);
    if (right >= left) context.fillText(shown[i], right, y);
    right -= kGap;
  });
}

const kChartFont = (pixels) => `${pixels}px system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif`;

/// The range next to the chart, its time below.
function drawScale(context, box, { range, scale }) {
  context.font = kChartFont(10.5);
  context.fillStyle = styleColor("--soft");
  context.textAlign = "right";
  range.forEach((value, i) => context.fillText(short(value * scale), box.left - 5, i === 0 ? box.bottom + 2 : box.top + 6));
  context.fillText(`${short(secondsAt(lastFrame))} s`, box.right, box.bottom + 14);
  context.textAlign = "left";
  context.fillText("0", box.left, box.bottom + 14);
}

function drawChart(context, box, chart) {
  const [low, high] = chart.range;
  context.strokeStyle = styleColor("--line");
  context.lineWidth = 1;
  context.strokeRect(box.left + 0.5, box.top - 2.5, box.right - box.left - 1, box.bottom - box.top + 5);
  if (low < 0 && high > 0) {
    const zero = Math.round(box.bottom + (box.bottom - box.top) * low / (high - low)) + 0.5;
    context.strokeRect(box.left, zero, box.right - box.left, 0);
  }
  for (const [name, color] of chart.lines) drawLine(context, box, chart.range, data.curves[name], styleColor(color));
  const x = chartX(box, view.time);
  context.strokeStyle = styleColor("--accent");
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, box.top - 3);
  context.lineTo(x, box.bottom + 3);
  context.stroke();
  drawChartTexts(context, box, chart);
  drawScale(context, box, chart);
}

function drawCurves() {
  const target = byId("curves");
  target.hidden = !view.curves;
  if (!view.curves) return;
  target.style.setProperty("--rows", Math.ceil(kCharts.length / columnsIn(target.clientWidth)));
  const { clientWidth: width, clientHeight: height } = target;
  target.width = Math.round(width * devicePixelRatio);
  target.height = Math.round(height * devicePixelRatio);
  const context = target.getContext("2d");
  context.scale(devicePixelRatio, devicePixelRatio);
  kCharts.forEach((chart, number) => drawChart(context, chartBox(number, width, height), chart));
}

/// The frame at a place in the charts, CSS pixels.
function frameUnder(x, y) {
  const { clientWidth: width, clientHeight: height } = byId("curves"), columns = columnsIn(width);
  const column = Math.min(columns - 1, Math.floor(x / width * columns));
  const row = Math.floor(y / height * Math.ceil(kCharts.length / columns));
  const box = chartBox(Math.min(kCharts.length - 1, row * columns + column), width, height);
  return clampFrame(Math.round((x - box.left) / (box.right - box.left) * lastFrame));
}

function listenToCurves() {
  const target = byId("curves");
  const goThere = (event) => { if (event.buttons & 1) seek(frameUnder(event.offsetX, event.offsetY)); };
  target.addEventListener("pointerdown", (event) => { target.setPointerCapture(event.pointerId); goThere(event); });
  target.addEventListener("pointermove", goThere);
}
