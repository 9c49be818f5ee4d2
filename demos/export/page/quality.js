// Coarser pictures where a frame takes too long, as without a GPU.

const kSlow = 100, kPatience = 500;  // ms, of one frame and of successive slow ones
const kQualities = [  // resolution: of the screen's own
  { resolution: 1, shadows: true, note: "" },
  { resolution: 0.5, shadows: true, note: "half resolution, to keep up" },
  { resolution: 0.5, shadows: false, note: "half resolution and no shadows, to keep up" },
];

const quality = { level: 0, slowFrames: 0, slowFor: 0 };  // slowFor: ms

const qualityNow = () => kQualities[quality.level];

/// One slow frame may be an accident; several in a row make pictures coarser.
function frameTook(ms) {
  const slow = ms > kSlow;
  quality.slowFrames = slow ? quality.slowFrames + 1 : 0;
  quality.slowFor = slow ? quality.slowFor + ms : 0;
  if (quality.slowFrames < 2 || quality.slowFor < kPatience) return;
  if (quality.level < kQualities.length - 1) Object.assign(quality, { level: quality.level + 1, slowFrames: 0, slowFor: 0 });
}
