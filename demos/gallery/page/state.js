// The page's data and small helpers. Its link names a scene (#scene-stack) or a search (#q=pendulum).

const gallery = JSON.parse(byId("data").textContent);

/// An icon of lines in a square of 16.
function sign(path) {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  const line = document.createElementNS("http://www.w3.org/2000/svg", "path");
  line.setAttribute("d", path);
  svg.append(line);
  return svg;
}

const groupName = (scene) => scene.group || "your scenes";
/// In the order of the page: [name, scenes].
const groups = [...new Set(gallery.scenes.map(groupName))]
  .map((name) => [name, gallery.scenes.filter((scene) => groupName(scene) === name)]);
/// Differs from all other ids of the page, whatever the scene's name.
const cardId = (name) => `scene-${name}`;
const groupId = (name) => `group-${name.replace(/[^a-z0-9]+/gi, "-")}`;

/// A link to a file next to the page, whatever its name.
const beside = (scene, ending) => encodeURIComponent(`${scene.name}.${ending}`);
const shortNumber = (value) => String(Number(value.toPrecision(3)));
