// The search of all pages: their texts are in search.js, which is loaded when they are first needed.

const kMost = 30;  // results shown
let asking = null;
let results = [], chosen = -1;

/// Loads search.js once; its rows are [address, page, heading, text].
function texts() {
  asking ??= new Promise((done) => {
    const script = make("script", { src: "search.js" });
    script.addEventListener("load", () => done(window.impulseTexts));
    script.addEventListener("error", () => done(null));
    document.head.append(script);
  });
  return asking;
}

/// How well a row answers: 0, not at all. Every word must be in it; words in headings count more.
function worthOf([, page, heading, text], words) {
  const head = `${heading} ${heading ? "" : page}`.toLowerCase();
  const all = `${page} ${heading} ${text}`.toLowerCase();
  let worth = 0;
  for (const word of words) {
    if (!all.includes(word)) return 0;
    const whole = head.split(/[^\w.]+/).includes(word) || head.split(".").includes(word);
    worth += whole ? 12 : head.includes(word) ? 6 : 1;
  }
  return worth;
}

/// The text with its words marked.
function marked(text, words) {
  const parts = [];
  const pattern = words.map((word) => word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&")).join("|");
  for (const [i, part] of text.split(new RegExp(`(${pattern})`, "gi")).entries())
    if (part) parts.push(i % 2 ? make("mark", {}, part) : part);
  return parts;
}

/// A piece of the text around the first word.
function excerpt(text, words) {
  const kLength = 150, low = text.toLowerCase();
  const at = Math.min(...words.map((word) => low.indexOf(word)).filter((place) => place >= 0), text.length);
  const from = at < 60 || at === text.length ? 0 : text.lastIndexOf(" ", at - 40) + 1;
  const piece = text.slice(from, from + kLength);
  return (from > 0 ? "\u2026 " : "") + piece + (from + kLength < text.length ? " \u2026" : "");
}

function resultOf([address, page, heading, text], words, i) {
  const title = heading || page;
  return make("a", { href: address, role: "option", id: `found-${i}`, tabindex: "-1", "aria-selected": "false" },
    make("b", {}, ...marked(title, words)), heading ? make("i", {}, page) : null,
    make("span", {}, ...marked(excerpt(text, words), words)));
}

function choose(place) {
  chosen = place;
  [...byId("found").querySelectorAll("a")].forEach((link, i) => {
    link.classList.toggle("chosen", i === place);
    link.setAttribute("aria-selected", String(i === place));
    if (i === place) link.scrollIntoView({ block: "nearest" });
  });
  if (place >= 0) byId("search").setAttribute("aria-activedescendant", `found-${place}`);
  else byId("search").removeAttribute("aria-activedescendant");
}

function showFound(open) {
  byId("found").hidden = !open;
  byId("search").setAttribute("aria-expanded", String(open));
}

async function search() {
  const asked = byId("search").value.trim();
  if (!asked) return showFound(false);
  const rows = await texts();
  if (asked !== byId("search").value.trim()) return;
  const words = asked.toLowerCase().split(/\s+/);
  results = (rows ?? []).map((row) => [worthOf(row, words), row]).filter(([worth]) => worth > 0)
    .sort((a, b) => b[0] - a[0]).slice(0, kMost).map(([, row]) => row);
  const none = rows ? `Nothing has \u201c${asked}\u201d.` : "search.js is missing: it belongs beside this page.";
  byId("found").replaceChildren(...(results.length > 0
    ? results.map((row, i) => resultOf(row, words, i)) : [make("p", {}, none)]));
  byId("found").dataset.asked = asked;
  choose(results.length > 0 ? 0 : -1);
  showFound(true);
}

function onSearchKey(event) {
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (step && results.length > 0) {
    event.preventDefault();
    choose((chosen + step + results.length) % results.length);
  } else if (event.key === "Enter" && chosen >= 0 && !byId("found").hidden) {
    byId(`found-${chosen}`).click();
    showFound(false);
  } else if (event.key === "Escape") {
    byId("search").value = "";
    showFound(false);
    byId("search").blur();
  }
}

function listenToSearch() {
  const box = byId("search");
  box.addEventListener("focus", texts, { once: true });
  box.addEventListener("focus", search);
  box.addEventListener("input", search);
  box.addEventListener("keydown", onSearchKey);
  document.addEventListener("click", (event) => {
    if (!byId("search-box").contains(event.target) || event.target.closest("#found a")) showFound(false);
  });
  document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || document.activeElement === box) return;
    event.preventDefault();
    box.focus();
    box.select();
  });
}
