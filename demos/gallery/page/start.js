// The page as a whole.

/// Which group is at the top, in the row of groups.
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

function showNumbers() {
  const scenes = gallery.scenes;
  const films = scenes.filter((scene) => scene.film);
  const total = films.reduce((sum, scene) => sum + scene.seconds, 0);
  const parts = [plural(scenes.length, "scene"),
    `${scenes.reduce((sum, scene) => sum + scene.bodies, 0)} bodies`];
  if (films.length > 0)
    parts.push(`${Math.floor(total / 60)} min ${Math.round(total % 60)} s of film; ` +
      `${matchMedia("(hover: none)").matches ? "tap" : "point at"} a picture to play it`);
  byId("numbers").textContent = parts.join(" \u00b7 ");
  byId("machine").textContent = [`impulse ${gallery.version}`, gallery.renderer].join(" \u00b7 ");
}

/// "#q=pendulum" is a search; "#stack" is found by the browser once the cards are there.
function openLink() {
  const link = decodeURIComponent(location.hash.slice(1));
  if (link.startsWith("q=")) byId("search").value = link.slice(2);
  else byId(link)?.scrollIntoView();
  search();
}

showNumbers();
showCards();
watchGroups();
byId("search").addEventListener("input", search);
document.addEventListener("keydown", onKey);
window.addEventListener("hashchange", openLink);
openLink();
document.body.dataset.ready = "1";
