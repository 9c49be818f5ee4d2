#include "demos/slides/measure_script.h"

namespace demos {

// A formula is drawn through an SVG picture, which a canvas may read.
const char* const kMeasureScript = R"js((() => {
"use strict";
const kInk = 6;    // px around a formula: letters may be wider than their boxes
const kSharp = 4;  // pixels per px

function boxOf(element, slide) {
  const ground = slide.getBoundingClientRect(), box = element.getBoundingClientRect();
  const scale = ground.width / 1280;
  return [box.x - ground.x, box.y - ground.y, box.width, box.height].map((side) => side / scale);
}
function wordsOf(element, slide) {
  const look = getComputedStyle(element);
  return { box: boxOf(element, slide), size: parseFloat(look.fontSize),
    line: parseFloat(look.lineHeight) || 1.2 * parseFloat(look.fontSize),
    centered: look.textAlign === "center" };
}
const fontFaces = () => [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules])
  .filter((rule) => rule instanceof CSSFontFaceRule).map((rule) => rule.cssText).join("\n");

function svgOf(math, width, height, faces) {
  const look = getComputedStyle(math);
  const style = `${faces} math { display: inline math; math-style: normal;
    font-family: ${look.fontFamily}; }
    mi[mathvariant="bold"] { font-weight: bold; font-style: normal; }`;
  const sides = `width="${width}" height="${height}"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" ${sides}><style>${style}</style>
    <foreignObject ${sides}><div xmlns="http://www.w3.org/1999/xhtml" style="position: absolute;
      left: ${kInk}px; top: ${kInk}px; white-space: nowrap; line-height: 0; color: ${look.color};
      font-size: ${look.fontSize}">${new XMLSerializer().serializeToString(math)}</div>
    </foreignObject></svg>`;
}
async function drawn(math, slide, faces) {
  const [x, y, w, h] = boxOf(math, slide);
  const width = Math.ceil(w) + 2 * kInk, height = Math.ceil(h) + 2 * kInk;
  const picture = new Image();
  picture.src = "data:image/svg+xml;charset=utf-8," +
    encodeURIComponent(svgOf(math, width, height, faces));
  await picture.decode();
  const canvas = document.createElement("canvas");
  canvas.width = kSharp * width;
  canvas.height = kSharp * height;
  canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
  return { box: [x - kInk, y - kInk, width, height], tex: math.getAttribute("alttext"),
    png: canvas.toDataURL("image/png").split(",")[1] };
}
async function blockOf(block, slide, faces) {
  const math = block.matches("p.lone") && block.querySelector("math");
  return { words: wordsOf(block, slide), formula: math ? await drawn(math, slide, faces) : null };
}
function tableOf(table, slide) {
  const sides = (list, side) => [...list].map((element) => boxOf(element, slide)[side]);
  return { words: wordsOf(table, slide), columns: sides(table.rows[0].cells, 2),
    rows: sides(table.rows, 3) };
}
async function measured(slide, faces) {
  const all = (what) => [...slide.querySelectorAll(what)];
  const words = (what) => all(what).map((element) => wordsOf(element, slide));
  const result = { title: words(".slide > h1, .slide > h2"), caption: words(".caption"),
    under: words(".under, .by"), code: words(".words > pre"), blocks: [], formulas: [],
    tables: all(".tables > table").map((table) => tableOf(table, slide)),
    pictures: all(".frame").map((frame) => boxOf(frame, slide)) };
  for (const block of all(".text > *"))
    result.blocks.push(await blockOf(block, slide, faces));
  for (const math of all(".formula > math"))
    result.formulas.push(await drawn(math, slide, faces));
  return result;
}
async function measure() {
  const faces = fontFaces(), slides = [];
  for (const slide of document.querySelectorAll("#stage .slide"))
    slides.push(await measured(slide, faces));
  const pre = document.createElement("pre");
  pre.id = "measured";
  pre.textContent = btoa(unescape(encodeURIComponent(JSON.stringify(slides))));
  document.body.replaceChildren(pre);
}
const begin = () => document.body.dataset.ready ? measure() : setTimeout(begin, 20);
begin();
})();
)js";

}  // namespace demos
