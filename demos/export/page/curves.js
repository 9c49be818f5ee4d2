// Energy, penetration and separation over time, with the values where the cursor is.

const kCharts = [
  { title: "energy", unit: "J", scale: 1, lines: [["kinetic", "--warm"], ["potential", "--cool"], ["total", "--ink"]] },
  { title: "penetration", unit: "mm", scale: 1000, fromZero: true, lines: [["penetration", "--warm"]] },
  { title: "separation of joints", unit: "mm", scale: 1000, fromZero: true, lines: [["separation", "--cool"]] },
].filter((chart) => chart.title !== "separation of joints" || data.joints.length > 0);
const kChartMargin = { left: 12, right: 12, top: 22, bottom: 6 };

const styleColor = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const kLeast = 1e-6;  // m: less is rounding, and no curve

/// What is null was not finite.
function rangeOf({ lines, fromZero }) {
  const values = lines.flatMap(([name]) => data.curves[name]).filter((value) => value !== null);
  const low = Math.min(fromZero ? 0 : Infinity, ...values), high = Math.max(fromZero ? kLeast : -Infinity, ...values);
  if (values.length === 0) return [0, 1];
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}
kCharts.forEach((chart) => { chart.range = rangeOf(chart); });

function chartBox(number, width, height) {
  const each = width / kCharts.length, m = kChartMargin;
  return { left: number * each + m.left, right: (number + 1) * each - m.right, top: m.top, bottom: height - m.bottom };
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
  return chart.lines.length > 1 ? `${label} ${number}` : number;
}

/// The title, and every line's value now in its colour; names are cut where there is no room.
function drawChartTexts(context, box, chart) {
  const kGap = 12;  // pixels
  context.font = "12px system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif";
  const title = `${chart.title}, ${chart.unit}`, room = box.right - box.left - context.measureText(title).width - kGap;
  const texts = (cut) => chart.lines.map(([name]) => valueText(name, cut ? name.slice(0, 3) : name, chart));
  const wide = (all) => all.reduce((sum, text) => sum + context.measureText(text).width + kGap, -kGap);
  const shown = wide(texts(false)) <= room ? texts(false) : texts(true);
  context.fillStyle = styleColor("--soft");
  context.fillText(wide(shown) <= room ? title : chart.unit, box.left, 14);
  let right = box.right;
  [...chart.lines.entries()].reverse().forEach(([i, [, color]]) => {
    right -= context.measureText(shown[i]).width;
    context.fillStyle = styleColor(color);
    context.fillText(shown[i], right, 14);
    right -= kGap;
  });
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
}

function drawCurves() {
  const target = byId("curves");
  target.hidden = !view.curves;
  if (!view.curves) return;
  const { clientWidth: width, clientHeight: height } = target;
  target.width = Math.round(width * devicePixelRatio);
  target.height = Math.round(height * devicePixelRatio);
  const context = target.getContext("2d");
  context.scale(devicePixelRatio, devicePixelRatio);
  kCharts.forEach((chart, number) => drawChart(context, chartBox(number, width, height), chart));
}

/// The frame under a place in the charts, CSS pixels.
function frameUnder(x) {
  const { clientWidth: width, clientHeight: height } = byId("curves");
  const box = chartBox(Math.min(kCharts.length - 1, Math.floor(x / width * kCharts.length)), width, height);
  return clampFrame(Math.round((x - box.left) / (box.right - box.left) * lastFrame));
}

function listenToCurves() {
  const target = byId("curves");
  const goThere = (event) => { if (event.buttons & 1) seek(frameUnder(event.offsetX)); };
  target.addEventListener("pointerdown", (event) => { target.setPointerCapture(event.pointerId); goThere(event); });
  target.addEventListener("pointermove", goThere);
}
