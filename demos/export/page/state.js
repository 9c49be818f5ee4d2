// The page's state, which is also in its link: #t=2.5&show=contacts,impulses&body=box3&follow=1&camera=...

const data = JSON.parse(byId("data").textContent);

const kLayers = ["contacts", "normals", "impulses", "friction", "joints", "trails", "names"];
const kSpeeds = [0.25, 0.5, 1, 2];

const view = {
  time: 0,                    // frames; fractions while it plays
  playing: false,
  speed: 1,
  loop: true,
  show: new Set(data.show),   // of kLayers
  curves: true,
  body: -1,                   // the chosen one; -1: none
  follow: false,              // the camera follows that body
  camera: null,               // { from, at, fov }, m and degrees; null: the scene's own
};

const lastFrame = data.frames - 1;
const frameNow = () => Math.min(lastFrame, Math.floor(view.time + 1e-6));
const secondsAt = (frame) => frame / data.fps;
const clampFrame = (time) => Math.min(lastFrame, Math.max(0, time));

const short = (value, digits = 3) => (value !== 0 && Math.abs(value) < 1e-3
  ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits))));

/// Without the sign of a rounded zero.
const fixed = (value, digits) => value.toFixed(digits).replace(/^-(?=[0.]+$)/, "");

/// "1,2,3,..." as `count` finite numbers; null for any other text.
function numbersOf(text, count) {
  const numbers = (text ?? "").split(",").map(Number);
  return numbers.length === count && numbers.every(Number.isFinite) ? numbers : null;
}

/// null if it would see nothing: it needs a direction and an angle of view.
function cameraOf(from, at, fov) {
  return fov > 0 && fov < 180 && norm(minus(from, at)) > 1e-6 ? { from, at, fov } : null;
}

function readLink() {
  const asked = new URLSearchParams(location.hash.slice(1));
  const seconds = Number(asked.get("t"));
  if (asked.has("t") && Number.isFinite(seconds)) view.time = clampFrame(Math.round(seconds * data.fps));
  if (asked.has("show")) view.show = new Set(asked.get("show").split(",").filter((name) => kLayers.includes(name)));
  view.body = data.bodies.findIndex((body) => body.name === asked.get("body"));
  view.follow = view.body >= 0 && asked.get("follow") === "1";
  const camera = numbersOf(asked.get("camera"), 7);
  view.camera = camera && cameraOf(camera.slice(0, 3), camera.slice(3, 6), camera[6]);
  const speed = Number(asked.get("speed"));
  if (kSpeeds.includes(speed)) view.speed = speed;
  view.curves = asked.get("curves") !== "0";
}

function writeLink() {
  const link = new URLSearchParams({ t: secondsAt(frameNow()).toFixed(3) });
  link.set("show", [...view.show].join());
  if (view.body >= 0) link.set("body", data.bodies[view.body].name);
  if (view.follow) link.set("follow", "1");
  if (view.speed !== 1) link.set("speed", view.speed);
  if (!view.curves) link.set("curves", "0");
  if (view.camera) {
    const { from, at, fov } = view.camera;
    link.set("camera", [...from, ...at, fov].map((x) => short(x, 5)).join());
  }
  history.replaceState(null, "", "#" + link);
}
