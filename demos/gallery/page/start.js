// The page as a whole.

/// Marks the group at the top of the page in the row of groups.
function watchGroups() {
  const links = [...byId("groups").children];
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const link = links.find((l) => l.dataset.group === entry.target.dataset.group);
      link.classList.toggle("here", entry.isIntersecting);
    }
  }, { rootMargin: "-25% 0px -74% 0px" });
  for (const section of document.querySelectorAll("section")) seen.observe(section);
}

/// "2 min 0 s", "23 s"
function timeText(seconds) {
  const whole = Math.round(seconds), minutes = Math.floor(whole / 60);
  return (minutes > 0 ? `${minutes} min ` : "") + `${whole % 60} s`;
}

function showNumbers() {
  const scenes = gallery.scenes;
  const films = scenes.filter((scene) => scene.film);
  const total = films.reduce((sum, scene) => sum + scene.seconds, 0);
  const parts = [plural(scenes.length, "scene", "scenes"),
    plural(scenes.reduce((sum, scene) => sum + scene.bodies, 0), "body", "bodies")];
  if (films.length > 0)
    parts.push(`${timeText(total)} of film; ` +
      `${matchMedia("(hover: none)").matches ? "tap" : "point at"} a picture to play it`);
  byId("numbers").textContent = parts.join(" \u00b7 ");
  byId("machine").textContent = [`impulse ${gallery.version}`, gallery.renderer].join(" \u00b7 ");
}

/// The link's text; as it is if it is not percent-encoded ("100%").
function linkNow() {
  const link = location.hash.slice(1);
  try {
    return decodeURIComponent(link);
  } catch {
    return link;
  }
}

/// "#q=pendulum" is a search; "#scene-stack", or "#stack" for short, a card.
function openLink() {
  const link = linkNow();
  if (link.startsWith("q=")) byId("search").value = link.slice(2);
  else (byId(cardId(link)) ?? byId(link))?.scrollIntoView();
  search();
}

/// Links to the other pages, if it is a part of a site.
function showSite() {
  byId("site").hidden = gallery.links.length === 0;
  byId("site").append(...gallery.links.map(([text, address]) => make("a", { href: address }, text)));
}

showSite();
showNumbers();
showCards();
watchGroups();
byId("search").addEventListener("input", search);
document.addEventListener("keydown", onKey);
window.addEventListener("hashchange", openLink);
openLink();
document.body.dataset.ready = "1";
