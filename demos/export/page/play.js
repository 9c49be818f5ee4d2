// Time, and drawing when something has changed.

let wanted = null, before = 0;  // the pending requests to draw; time of the last picture, ms

/// A hidden page gets no animation frames, and slow frames come late; then the timer draws.
/// `since`: ms, when the picture's time began; a slow one before delays its animation frame.
function changed(since = performance.now()) {
  const draw = () => {
    if (!document.hidden) frameTook(performance.now() - since);
    show();
  };
  wanted ??= { timer: setTimeout(draw, 120), frame: requestAnimationFrame(draw) };
  if (!view.playing) delete document.body.dataset.ready;  // until the picture is up to date
}

function advance(now) {
  if (!view.playing) return;
  const way = Math.min(now - before, 100) / 1000 * data.fps * view.speed;
  view.time += way;
  if (view.time < lastFrame) return;
  if (view.loop) view.time %= Math.max(lastFrame, 1);
  else {
    view.time = lastFrame;
    view.playing = false;
  }
}

function fitCanvas() {
  const dense = devicePixelRatio * qualityNow().resolution;
  const width = Math.round(canvas.clientWidth * dense), height = Math.round(canvas.clientHeight * dense);
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  return canvas.clientWidth / Math.max(canvas.clientHeight, 1);
}

function drawPicture(sight) {
  setSides(qualityNow().sides);
  placeSolids();
  placeBars(sight);
  placeMarks(sight);
  gl.enable(gl.DEPTH_TEST);
  gl.enable(gl.CULL_FACE);
  const light = lightOf(sight, qualityNow().shadows ? drawShadows(sight) : kNoShadows);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.viewport(0, 0, canvas.width, canvas.height);
  gl.clear(gl.DEPTH_BUFFER_BIT);
  gl.bindTexture(gl.TEXTURE_2D, shadow.map);
  drawSolids(light, "opaque");
  use(programs.solid, { ...light, thinnest: 0, chosen: 0, lineStrength: 0, lineWidth: 1 });
  bars.draw();
  for (const ground of data.grounds) drawGround(ground, sight, light);
  drawSky(sight);
  gl.enable(gl.BLEND);
  gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
  gl.depthMask(false);
  drawSolids(light, "clear");
  gl.depthMask(true);
  gl.disable(gl.BLEND);
  drawMarks(sight);
}

function drawSolids(light, which) {
  const look = lookNow(), wide = 1.3 * canvas.height / 720 * Math.sqrt(look.lines);
  const lines = { lineWidth: Math.max(1, wide), lineStrength: Math.min(0.42 * look.lines, 1) };
  for (const kind of kinds) {
    use(programs.solid, { ...light, ...lines, thinnest: kind.thinnest, chosen: 0 });
    kind[which].draw();
  }
}

function show() {
  const now = performance.now();
  cancelAnimationFrame(wanted?.frame);
  clearTimeout(wanted?.timer);
  wanted = null;
  advance(now);
  before = now;
  movePoses();
  followBody();
  const sight = sightOf(cameraNow(), fitCanvas());
  drawPicture(sight);
  showWords(sight);
  showToggles();
  drawCurves();
  document.body.dataset.ready = "1";
  if (view.playing) changed(now);
  else linkSoon();
}

let linkTimer = 0;

/// Browsers limit how often the address may change.
function linkSoon() {
  clearTimeout(linkTimer);
  linkTimer = setTimeout(writeLink, 150);
}

function seek(frame) {
  view.time = clampFrame(frame);
  changed();
}

function stepFrames(count) {
  view.playing = false;
  seek(frameNow() + count);
}

function togglePlay() {
  view.playing = !view.playing;
  if (view.playing && view.time >= lastFrame) view.time = 0;
  before = performance.now();
  changed();
}

function changeSpeed(by) {
  const place = kSpeeds.indexOf(view.speed) + by;
  view.speed = kSpeeds[Math.max(0, Math.min(kSpeeds.length - 1, place))];
  changed();
}

function toggleLoop() {
  view.loop = !view.loop;
  changed();
}

function listenToPlay() {
  byId("play").addEventListener("click", togglePlay);
  byId("back").addEventListener("click", () => stepFrames(-1));
  byId("forth").addEventListener("click", () => stepFrames(1));
  byId("loop").addEventListener("click", toggleLoop);
  byId("time").addEventListener("input", (event) => seek(Number(event.target.value)));
  byId("speed").addEventListener("change", (event) => {
    view.speed = Number(event.target.value);
    changed();
  });
}
