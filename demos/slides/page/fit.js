// The stage in its window, and words in their places: what is too long is set smaller.

const kStage = { width: 1280, height: 720 };
const kSmallest = 0.5;  // of the size that words have where there is room
const kWide = 0.72;     // a formula that would be set smaller beside a picture goes above it

const scaleIn = (room) => Math.min(room.clientWidth / kStage.width, room.clientHeight / kStage.height);

function fitStage() {
  document.body.style.setProperty("--scale", scaleIn(byId("room")) || 1);
  document.body.style.setProperty("--small", scaleIn(byId("next")) || 0.3);
  if (document.body.classList.contains("overview"))
    document.body.style.setProperty("--thumb", leaves[0].clientWidth / kStage.width);
}

/// Of the room that it has; 1: it fits. MathML has no offsetWidth, hence the stage's scale.
function shareOf(formula, scale) {
  const width = formula.getBoundingClientRect().width / scale;
  return width > 0 ? formula.closest(".formula, p, li, .text").clientWidth / width : 1;
}

/// The smallest share of the formulas that have a place of their own, not of those in a text.
function fitFormulas(slide, scale) {
  const formulas = [...slide.querySelectorAll(".formula > math, .text math")];
  for (const formula of formulas) formula.style.setProperty("--narrow", 1);
  const shares = formulas.map((formula) => shareOf(formula, scale));
  formulas.forEach((formula, i) => formula.style.setProperty("--narrow", Math.min(1, 0.995 * shares[i])));
  return Math.min(1, ...shares.filter((_, i) => formulas[i].parentElement.matches(".formula")));
}

/// Whether words above leave a picture less than a third of the slide, and it wants more.
function isSqueezed(pictures) {
  const aspect = Number(pictures.style.getPropertyValue("--aspect"));
  return pictures.clientHeight < Math.min(240, pictures.clientWidth / aspect - 2);
}

function tooLong(slide) {
  const words = slide.querySelector(".words"), show = slide.querySelector(".pictures");
  const wide = [...slide.querySelectorAll("pre, .tables, .text")];
  return slide.scrollHeight > slide.clientHeight + 1 ||
    Boolean(words && words.scrollHeight > words.clientHeight + 1) ||
    wide.some((part) => part.scrollWidth > part.clientWidth + 1) ||
    Boolean(slide.classList.contains("below") && show && isSqueezed(show));
}

function fitSlide(slide, scale) {
  const formulas = slide.querySelector(".formulas");
  if (fitFormulas(slide, scale) < kWide && slide.matches(".beside") && formulas) {
    slide.classList.add("wide");
    slide.querySelector(".body").before(formulas);
    const words = slide.querySelector(".words");
    if (!words.childElementCount) slide.classList.replace("beside", "full");
    fitFormulas(slide, scale);
  }
  for (let size = 1; tooLong(slide) && size > kSmallest; size -= 0.04) {
    slide.style.setProperty("--size", size - 0.04);
    fitFormulas(slide, scale);
  }
}

function fitAll() {
  fitStage();
  const scale = scaleIn(byId("room")) || 1;
  for (const leaf of leaves) fitSlide(slideOf(leaf), scale);
}
