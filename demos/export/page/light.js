// Sun with its shadow map, sky and ground.

const kSkyLight = [0.40, 0.44, 0.50], kGroundLight = [0.27, 0.25, 0.23], kSunLight = [1.06, 1.00, 0.90];
const kShadowSide = 2048;  // texels
const darkly = matchMedia("(prefers-color-scheme: dark)");

/// The scene's own look; the dark look if the page is dark and the scene has no theme.
const lookNow = () => (darkly.matches && !data.themed ? data.dark : data.look);

let programs = null, shadow = null, nothing = null;

function makeLight() {
  programs = {
    dark: programOf(kPlaced, kDark), flat: programOf(kPlaced, kFlat), solid: programOf(kPlaced, kSolid),
    ground: programOf(kGroundPlace, kGround), sky: programOf(kSkyPlace, kSky),
  };
  nothing = gl.createVertexArray();
  const map = gl.createTexture(), buffer = gl.createFramebuffer();
  gl.bindTexture(gl.TEXTURE_2D, map);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, kShadowSide, kShadowSide);
  for (const [name, value] of [["MIN_FILTER", "LINEAR"], ["MAG_FILTER", "LINEAR"], ["WRAP_S", "CLAMP_TO_EDGE"],
    ["WRAP_T", "CLAMP_TO_EDGE"], ["COMPARE_MODE", "COMPARE_REF_TO_TEXTURE"], ["COMPARE_FUNC", "LEQUAL"]])
    gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
  gl.bindFramebuffer(gl.FRAMEBUFFER, buffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, map, 0);
  gl.drawBuffers([gl.NONE]);
  shadow = { map, buffer };
}

/// A ball (m) around all visible bodies that cast shadows; steps of 10 % keep shadow edges still.
function shadowBall(sight) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const farthest = 4 * sight.distance;
  for (const kind of kinds)
    for (const part of kind.parts) {
      const { at, turn } = poses[part.body], place = plus(at, turned(turn, part.at));
      if (norm(minus(place, sight.at)) - kind.reach > farthest) continue;
      const reach = Math.min(kind.reach, farthest);
      place.forEach((x, axis) => {
        low[axis] = Math.min(low[axis], x - reach);
        high[axis] = Math.max(high[axis], x + reach);
      });
    }
  if (low[0] > high[0]) return { middle: sight.at, radius: 1 };
  const radius = 1.1 ** Math.ceil(Math.log(Math.max(0.5 * norm(minus(high, low)), 1e-3)) / Math.log(1.1));
  return { middle: times(0.5, plus(low, high)), radius };
}

/// Takes every place out of the shadow map, where the sun shines.
const kNoShadows = { worldToShadow: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 2, 1], shadowTexel: 0 };

function drawShadows(sight) {
  const { middle, radius } = shadowBall(sight), toSun = unit(lookNow().sun);
  const right = across(toSun), up = cross(toSun, right);
  const eye = plus(middle, times(2 * radius, toSun));
  const narrow = [1 / radius, 0, 0, 0, 0, 1 / radius, 0, 0, 0, 0, -2 / (4 * radius), 0, 0, 0, -1, 1];
  const worldToMap = multiplied(narrow, eyeMatrix(eye, right, up, toSun));
  gl.bindFramebuffer(gl.FRAMEBUFFER, shadow.buffer);
  gl.viewport(0, 0, kShadowSide, kShadowSide);
  gl.clear(gl.DEPTH_BUFFER_BIT);
  use(programs.dark, { worldToClip: worldToMap });
  gl.enable(gl.POLYGON_OFFSET_FILL);
  gl.polygonOffset(1.5, 2);
  for (const kind of kinds) kind.opaque.draw();
  bars.draw();
  gl.disable(gl.POLYGON_OFFSET_FILL);
  const halved = [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0.5, 1];
  return { worldToShadow: multiplied(halved, worldToMap), shadowTexel: 2 * radius / kShadowSide };
}

/// The uniforms of every lit program.
function lightOf(sight, shadows) {
  const look = lookNow();
  return {
    worldToClip: sight.worldToClip, eye: sight.eye, toSun: unit(look.sun), fogColor: linear(look.fog),
    skyLight: kSkyLight, groundLight: kGroundLight, sunLight: kSunLight, shadowMap: 0,
    fogStart: sight.distance, fogDistance: Math.max(3 * sight.distance, 20), ...shadows,
  };
}

function lineColor([r, g, b]) {
  return linear(r < 0.4 ? [0.42, 0.44, 0.47] : [0.50 * r, 0.51 * g, 0.54 * b]);
}

/// 1 / m: as in the pictures; from farther off one sees more of the grid. 0: it does not fade.
function perReach(sight) {
  const tall = 2 * sight.tangent * sight.distance;
  return data.gridReach > 0 ? 1 / (data.gridReach * Math.max(1, tall / data.viewHeight)) : 0;
}

function drawGround(ground, sight, light) {
  const { normal, offset } = ground, look = lookNow();
  if (dot(sight.eye, normal) <= offset) return;  // visible from its front only
  const acrossIt = Math.abs(normal[0]) < 0.9 ? unit(minus([1, 0, 0], times(normal[0], normal))) : across(normal);
  const middle = plus(sight.at, times(offset - dot(sight.at, normal), normal));
  const decade = Math.floor(Math.log10(sight.distance / 6)), alongIt = cross(normal, acrossIt);
  use(programs.ground, {
    ...light, normal, across: acrossIt, along: alongIt, middle, reach: 120 * Math.max(sight.distance, 4),
    groundColor: linear(look.ground), lineColor: lineColor(look.ground), lineStrength: look.lines,
    perCell: 1 / Math.max(10 ** decade, 0.1), subject: [dot(acrossIt, sight.at), dot(alongIt, sight.at)],
    perReach: perReach(sight),
  });
  gl.bindVertexArray(nothing);
  gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
}

function drawSky(sight) {
  const look = lookNow();
  gl.depthFunc(gl.LEQUAL);
  use(programs.sky, {
    forward: times(-1, sight.back), right: times(sight.tangent * sight.aspect, sight.right),
    upward: times(sight.tangent, sight.up), fog: look.fog.slice(0, 3), horizon: look.skyHorizon.slice(0, 3),
    top: look.skyTop.slice(0, 3),
  });
  gl.bindVertexArray(nothing);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  gl.depthFunc(gl.LESS);
}
