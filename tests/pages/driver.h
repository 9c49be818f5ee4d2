/// Scripts that use a page as a reader would, and their results.
#pragma once
#include "tests/pages/browser.h"

namespace support {

/// Steps of a driver, each after the page has come to rest; their results go into the DOM.
inline std::string driver(const std::string& steps) {
    return R"js(
const told = document.createElement("pre");
told.id = "told";
document.body.append(told);
const tell = (text) => { told.textContent += `[${text}]`; };
const byId = (id) => document.getElementById(id);
const rest = async () => {
  do await new Promise((go) => setTimeout(go, 60)); while (!document.body.dataset.ready);
};
const key = async (name, shiftKey = false) => {
  document.body.dispatchEvent(new KeyboardEvent("keydown", { key: name, shiftKey, bubbles: true }));
  await rest();
};
const link = async (hash) => { location.hash = hash; await rest(); };
// Loading a picture takes real time but no virtual time of the browser; a timer would use up
// virtual time while a film seeks or the clipboard answers. The page's policy allows its address.
const inPage = /img-src[^;]*data:/.test(document.querySelector("meta[http-equiv]").content);
const emptyPicture = 'data:image/svg+xml,<svg xmlns="http://www.w3.org/2000/svg" id="p';
let breaths = 0;
const breath = () => new Promise((go) => {
  const picture = new Image();
  picture.onload = go;
  picture.src = inPage ? `${emptyPicture}${++breaths}"/>` : `empty.svg?${++breaths}`;
});
const comes = async (condition) => {
  for (let i = 0; i < 20000 && !condition(); ++i) await breath();
  return condition();
};
(async () => {
  await rest();
)js" + steps +
           "})();";
}

/// Tells the texts on one colour whose contrast with it is below 4.5 (WCAG 2.2, 1.4.3), in the
/// light and in the dark style. Texts of buttons that are off are exempt, and so is what lies on a
/// canvas.
inline const char* const kTellFaintTexts = R"js(
  const levels = (color) => (color.match(/[\d.]+/g) ?? [0, 0, 0, 0]).map(Number);
  const light = (color) => [0.2126, 0.7152, 0.0722].reduce((sum, share, i) => {
    const level = levels(color)[i] / 255;
    return sum + share * (level <= 0.04045 ? level / 12.92 : ((level + 0.055) / 1.055) ** 2.4);
  }, 0);
  const under = (one) => {
    for (; one; one = one.parentElement) {
      const color = getComputedStyle(one).backgroundColor, [, , , alpha = 1] = levels(color);
      if (alpha === 1) return color;
      if (alpha > 0 || one.querySelector(":scope > canvas")) return null;
    }
    return null;
  };
  let looked = 0;
  const faint = () => [...document.body.querySelectorAll("*")].flatMap((one) => {
    const texts = [...one.childNodes].filter((node) => node.nodeType === 3);
    const text = texts.map((node) => node.data).join("").trim();
    const exempt = !one.checkVisibility() || one.closest("#told, script, :disabled");
    const ground = text && !exempt ? under(one) : null;
    if (!ground) return [];
    ++looked;
    const [high, low] = [light(getComputedStyle(one).color), light(ground)].sort((a, b) => b - a);
    const contrast = (high + 0.05) / (low + 0.05);
    return contrast < 4.5 ? [`${text}: ${contrast.toFixed(2)}`] : [];
  });
  const look = () => tell(faint().join());
  look();
  const before = getComputedStyle(document.body).backgroundColor;
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule.media?.mediaText.includes("scheme: dark")) rule.media.mediaText = "all";
  look();
  tell(looked > 12 && getComputedStyle(document.body).backgroundColor !== before);
)js";

inline std::string told(const Opened& opened) {
    const std::string mark = "<pre id=\"told\">";
    const std::size_t begin = opened.dom.find(mark);
    if (begin == std::string::npos) return "nothing was reported";
    const std::size_t text = begin + mark.size();
    return opened.dom.substr(text, opened.dom.find("</pre>", text) - text);
}

struct Rect {
    double left, top, width, height;  // pixels of the screenshot
};

inline Rect toldRect(const Opened& opened) {
    std::istringstream numbers(told(opened).substr(1));
    Rect rect{};
    numbers >> rect.left >> rect.top >> rect.width >> rect.height;
    return rect;
}

}  // namespace support
