// Fits the stage into its window and words into their places: what is too long is set smaller.

const kStage = { width: 1280, height: 720 };
const kSmallest = 0.5;  // least share of the usual size of words
const kWide = 0.72;     // a formula that would have to be smaller beside a picture goes above it
const kTight = 0.6;     // code that would have to be smaller is broken into lines
const kBroken = 0.8;    // of this size

const scaleIn = (room) => Math.min(room.clientWidth / kStage.width, room.clientHeight / kStage.height);

function fitStage() {
  document.body.style.setProperty("--scale", scaleIn(byId("room")) || 1);
  document.body.style.setProperty("--small", scaleIn(byId("next")) || 0.3);
  if (document.body.classList.contains("overview"))
    document.body.style.setProperty("--thumb", leaves[0].clientWidth / kStage.width);
}

/// The available width over the formula's; 1: it fits. MathML has no offsetWidth, hence `scale`.
function shareOf(formula, scale) {
  const width = formula.getBoundingClientRect().width / scale;
  return width > 0 ? formula.closest(".formula, p, li, .text").clientWidth / width : 1;
}

/// Whether a formula is alone in its paragraph, as if it were one of the slide's `formula`.
const isAlone = (formula) => formula.parentElement.textContent.trim() === formula.textContent.trim();

/// Scales all formulas; returns the smallest share of the slide's `formula`, not of those in a text.
function fitFormulas(slide, scale) {
  for (const formula of slide.querySelectorAll(".text p > math[display=block]"))
    formula.parentElement.classList.toggle("lone", isAlone(formula));
  const formulas = [...slide.querySelectorAll(".formula > math, .text math")];
  for (const formula of formulas) formula.style.setProperty("--narrow", 1);
  const shares = formulas.map((formula) => shareOf(formula, scale));
  formulas.forEach((formula, i) => formula.style.setProperty("--narrow", Math.min(1, 0.995 * shares[i])));
  return Math.min(1, ...shares.filter((_, i) => formulas[i].parentElement.matches(".formula")));
}

/// Makes each line a block, so that its continuation is indented below its beginning.
function breakLines(pre) {
  const code = pre.querySelector("code");
  const lines = code.textContent.replace(/\n$/, "").split("\n").map((text) => {
    const line = document.createElement("span");
    line.className = "line";
    line.textContent = text || " ";
    line.style.setProperty("--hang", `${text.search(/\S|$/) + 6}ch`);
    return line;
  });
  code.replaceChildren(...lines);
  pre.classList.add("broken");
}

function fitCode(slide) {
  for (const pre of slide.querySelectorAll("pre:not(.broken)")) {
    pre.style.setProperty("--tight", 1);
    if (pre.scrollWidth <= pre.clientWidth) continue;
    const share = 0.97 * pre.clientWidth / pre.scrollWidth;  // 0.97: padding on the right
    pre.style.setProperty("--tight", share < kTight ? kBroken : share);
    if (share < kTight) breakLines(pre);
  }
}

/// Whether words leave a picture less than a third of the slide, and less than it needs.
function isSqueezed(slide) {
  const pictures = slide.querySelector(".pictures");
  if (!pictures || !slide.querySelector(".below .words, .caption")) return false;
  const aspect = Number(pictures.style.getPropertyValue("--aspect"));
  return pictures.clientHeight < Math.min(240, pictures.clientWidth / aspect - 2);
}

const isCut = (part) => part.scrollHeight > part.clientHeight + 1;

function overflows(slide) {
  const wide = [...slide.querySelectorAll("pre, .tables, .text")];
  return [slide, ...slide.querySelectorAll(".words, .show")].some(isCut) ||
    wide.some((part) => part.scrollWidth > part.clientWidth + 1);
}

/// Marks a slide that fits at no size, so that its author sees it, on paper too.
function tellOverfull(slide) {
  const lost = slide.querySelector(".pictures")?.clientHeight < 60;
  const overfull = lost || overflows(slide);
  slide.classList.toggle("overfull", overfull);
  if (overfull) console.warn(`too much for one slide: ${slide.getAttribute("aria-label")}`);
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
  fitCode(slide);
  for (let size = 1; size > kSmallest && (overflows(slide) || isSqueezed(slide)); size -= 0.04) {
    slide.style.setProperty("--size", size - 0.04);
    fitFormulas(slide, scale);
    fitCode(slide);
  }
  tellOverfull(slide);
}

function fitAll() {
  fitStage();
  const scale = scaleIn(byId("room")) || 1;
  for (const leaf of leaves) fitSlide(slideOf(leaf), scale);
}
