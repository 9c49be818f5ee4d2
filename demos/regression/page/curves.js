// Energy, penetration and separation of both runs over time, above the scrubber.

const kCurves = [
  { key: "energy", title: "energy, J" },
  { key: "penetration", title: "penetration, mm", fromZero: true, scale: 1000 },
  { key: "separation", title: "separation of joints, mm", fromZero: true, scale: 1000 },
];
const kCurveMargin = { left: 8, right: 8, top: 18, bottom: 6 };

const styleColor = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const timeOf = (course, moment) => course.steps[moment] / course.hz;
const coursesOf = (film) => [film.baseline, film.actual].filter((course) => course !== null);

function filmEnd(film) {
  const ends = coursesOf(film).map((course) => timeOf(course, course.steps.length - 1));
  return Math.max(...ends, 1e-6);
}

/// A null value was not finite.
function rangeOf(film, curve) {
  const values = coursesOf(film).flatMap((course) => course[curve.key]).filter((v) => v !== null);
  const low = curve.fromZero ? 0 : Math.min(...values), high = Math.max(...values);
  if (values.length === 0) return [0, 1];
  return high > low ? [low, high] : [low, low + 1];
}

const curveX = (width, time, end) =>
  kCurveMargin.left + (width - kCurveMargin.left - kCurveMargin.right) * time / end;

function drawCurve(context, course, curve, box, end, color, thick) {
  context.strokeStyle = color;
  context.lineWidth = thick;
  context.beginPath();
  course[curve.key].forEach((value, i) => {
    if (value === null) return;
    const y = box.bottom - (box.bottom - box.top) * (value - box.low) / (box.high - box.low);
    context.lineTo(curveX(box.width, timeOf(course, i), end), y);
  });
  context.stroke();
}

function drawCurveFrame(context, curve, box) {
  const top = (value) => short(value * (curve.scale ?? 1));
  context.strokeStyle = styleColor("--line");
  context.lineWidth = 1;
  context.strokeRect(kCurveMargin.left + 0.5, box.top - 2.5,
    box.width - kCurveMargin.left - kCurveMargin.right - 1, box.bottom - box.top + 5);
  context.fillStyle = styleColor("--soft");
  context.font = "12px system-ui, sans-serif";
  context.fillText(curve.title, kCurveMargin.left, box.top - 7);
  const range = `${top(box.low)} to ${top(box.high)}`;
  const left = box.width - kCurveMargin.right - context.measureText(range).width;
  context.fillText(range, left, box.top - 7);
}

function drawMark(context, x, height, color, dash) {
  context.strokeStyle = color;
  context.lineWidth = 1.5;
  context.setLineDash(dash);
  context.beginPath();
  context.moveTo(x, kCurveMargin.top - 3);
  context.lineTo(x, height - 2);
  context.stroke();
  context.setLineDash([]);
}

/// Clears the canvas and returns a context in CSS pixels.
function freshContext(canvas) {
  const { clientWidth: width, clientHeight: height } = canvas, dense = devicePixelRatio;
  canvas.width = Math.round(width * dense);
  canvas.height = Math.round(height * dense);
  const context = canvas.getContext("2d");
  context.scale(dense, dense);
  return [context, width, height];
}

function drawRuns(context, film, curve, box, end) {
  if (film.baseline)
    drawCurve(context, film.baseline, curve, box, end, styleColor("--baseline"), 3);
  if (film.actual) drawCurve(context, film.actual, curve, box, end, styleColor("--actual"), 1.5);
}

function drawCurves(film) {
  const [context, width, height] = freshContext(byId("curves")), end = filmEnd(film);
  const each = height / kCurves.length;
  kCurves.forEach((curve, i) => {
    const [low, high] = rangeOf(film, curve);
    const top = i * each + kCurveMargin.top, bottom = (i + 1) * each - kCurveMargin.bottom;
    drawCurveFrame(context, curve, { width, low, high, top, bottom });
    drawRuns(context, film, curve, { width, low, high, top, bottom }, end);
  });
  const first = firstDifference();
  if (first !== null)
    drawMark(context, curveX(width, first, end), height, styleColor("--failed"), [4, 3]);
  drawMark(context, curveX(width, view.film, end), height, styleColor("--ink"), []);
}
