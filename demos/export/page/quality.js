// Coarser pictures where a frame takes too long, as without a GPU, and finer ones where it is quick.

const kSlow = 100, kPatience = 500;  // ms, of one frame and of successive slow ones
const kQuick = 25;                   // ms: with four times as many pixels it would not be slow
const kQualities = [  // resolution: of the screen's own; sides: the most of a round solid
  { resolution: 1, shadows: true, sides: Infinity, note: "" },
  { resolution: 1 / 2, shadows: true, sides: Infinity, note: "half resolution, to keep up" },
  { resolution: 1 / 2, shadows: false, sides: Infinity, note: "half resolution and no shadows, to keep up" },
  { resolution: 1 / 3, shadows: false, sides: 10, note: "a third of the resolution, fewer sides and no shadows, to keep up" },
];

/// slowFor, quickFor: ms of successive frames; wait: ms of quick frames before a finer picture is tried;
/// tried: the present picture is such a trial.
const quality = { level: 0, slowFrames: 0, slowFor: 0, quickFor: 0, wait: 1000, tried: false };

const qualityNow = () => kQualities[quality.level];

/// A trial that fails makes the next one wait longer.
function changeQuality(by) {
  const level = quality.level + by;
  if (level < 0 || level >= kQualities.length) return;
  if (by > 0 && quality.tried) quality.wait *= 4;
  Object.assign(quality, { level, slowFrames: 0, slowFor: 0, quickFor: 0, tried: by < 0 });
}

/// One slow frame may be an accident; several in a row make pictures coarser.
function frameTook(ms) {
  const slow = ms > kSlow;
  quality.slowFrames = slow ? quality.slowFrames + 1 : 0;
  quality.slowFor = slow ? quality.slowFor + ms : 0;
  quality.quickFor = ms < kQuick ? quality.quickFor + ms : 0;
  if (quality.slowFrames >= 2 && quality.slowFor >= kPatience) changeQuality(1);
  else if (quality.quickFor >= quality.wait) changeQuality(-1);
}
