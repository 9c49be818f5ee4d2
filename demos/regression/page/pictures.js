// One thumbnail per time, with its verdict and the share of the gate it uses.

function thumbImage(picture) {
  const place = picture.actual_image >= 0 ? picture.actual_image : picture.baseline_image;
  if (place < 0) return make("div", { class: "none" }, "missing");
  const image = make("img", { src: report.images[place].src, alt: picture.name });
  image.addEventListener("error", () =>
    image.replaceWith(make("div", { class: "none" }, "cannot be read")));
  return image;
}

function gateText(scene, picture) {
  const d = picture.difference, gate = scene.snapshot.gate;
  return `worst window ${d.window} pixels over ${gate.levels} levels (at most ${gate.window}), ` +
    `SSIM ${short(d.ssim)} (at least ${gate.ssim})`;
}

function thumbWords(scene, picture) {
  const kind = make("span", { class: `kind ${picture.kind}` }, pictureWords[picture.kind]);
  const use = picture.kind === "same" || !picture.difference
    ? "" : useText(pictureUse(scene, picture));
  return make("span", { class: "says" }, kind, isAccepted(scene, picture)
    ? make("span", { class: "tick" }, "\u2713 accepted") : make("span", { class: "soft" }, use));
}

function thumb(scene, picture, place) {
  const gate = picture.difference ? gateText(scene, picture) : "";
  return make("button", {
    class: `thumb${place === view.picture ? " on" : ""}`, "data-picture": picture.name,
    "aria-current": place === view.picture && "true",
    title: gate || (picture.problem ?? ""), onclick: () => choose(view.scene, place),
  }, thumbImage(picture), make("b", {}, seconds(picture.time)), thumbWords(scene, picture),
    bar(pictureUse(scene, picture), gate));
}

/// Scrolls horizontally only: scrollIntoView would move the page as well.
function keepInSight(strip, item) {
  if (!item) return;
  const left = item.offsetLeft - strip.offsetLeft;
  const least = left + item.offsetWidth - strip.clientWidth;
  strip.scrollLeft = Math.min(left, Math.max(least, strip.scrollLeft));
}

function showPictures() {
  const scene = sceneNow(), strip = byId("pictures");
  if (!scene) return;
  const scroll = strip.scrollLeft;
  strip.replaceChildren(...scene.pictures.map((picture, i) => thumb(scene, picture, i)));
  strip.hidden = scene.pictures.length === 0;
  strip.scrollLeft = scroll;
  keepInSight(strip, strip.querySelector(".on"));
}
