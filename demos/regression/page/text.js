// Numbers and names for people.

const short = (value, digits = 3) => (value !== 0 && Math.abs(value) < 1e-3
  ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits))));
const seconds = (time) => `${time} s`;
const percent = (part) => `${Math.round(100 * part)} %`;
/// The used share of a limit: "34 %", or a multiple of the limit beyond it, "2.5x".
const useText = (use) => {
  if (use > 1000) return "> 1000x";
  return use > 1 ? `${short(use, use < 10 ? 2 : 3)}x` : percent(use);
};

/// The share of the gate's limits that a picture uses: 1 is all of it.
function pictureUse(scene, picture) {
  const d = picture.difference, gate = scene.snapshot.gate;
  if (!d) return 0;
  const window = gate.window > 0 ? d.window / gate.window : d.window;
  const ssim = gate.ssim < 1 ? (1 - d.ssim) / (1 - gate.ssim) : (d.ssim < 1 ? 2 : 0);
  return Math.max(window, ssim);
}

function sceneUse(scene) {
  return Math.max(scene.physics.used, 0, ...scene.pictures.map((p) => pictureUse(scene, p)));
}

function bar(use, title) {
  const level = use > 1 ? " over" : use > 0.7 ? " high" : "";
  const inner = make("i");
  inner.style.width = `${Math.min(100, 100 * use)}%`;
  return make("div", { class: "bar" + level, title }, inner);
}

const pictureWords = {
  same: "same pixels", within: "within the gate", changed: "changed", new: "new", broken: "broken",
};
const stateWords = {
  passed: "passed", failed: "failed", new: "new", updated: "updated", error: "error",
};

/// Quoted so that a POSIX shell reads it as one word.
function shellWord(text) {
  return /^[A-Za-z0-9_@%+=:,.\/][A-Za-z0-9_@%+=:,.\/-]*$/.test(text)
    ? text : `'${text.replaceAll("'", "'\\''")}'`;
}
