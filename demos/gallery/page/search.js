// The search box: a card's texts must contain every word.

const textOfScene = (scene) =>
  [scene.name, scene.title, scene.purpose, groupName(scene)].join(" ").toLowerCase();

function isFound(scene, words) {
  const text = textOfScene(scene);
  return words.every((word) => text.includes(word));
}

function search() {
  const asked = byId("search").value;
  const words = asked.toLowerCase().split(/\s+/).filter(Boolean);
  let shown = 0;
  for (const [name, scenes] of groups) {
    const found = new Set(scenes.filter((scene) => isFound(scene, words)).map((s) => s.name));
    const section = byId(groupId(name));
    for (const card of section.querySelectorAll(".card"))
      card.hidden = !found.has(card.dataset.scene);
    section.hidden = found.size === 0;
    section.querySelector("small").textContent = String(found.size);
    for (const link of byId("groups").children)
      if (link.dataset.group === name) link.classList.toggle("empty", found.size === 0);
    shown += found.size;
  }
  byId("nothing").hidden = shown > 0;
  byId("nothing").textContent = words.length === 0 ? "There are no scenes here." : `No scene has \u201c${asked.trim()}\u201d in its name or purpose.`;
}

function onKey(event) {
  const box = byId("search");
  if (event.key === "/" && document.activeElement !== box) {
    event.preventDefault();
    box.focus();
    box.select();
  } else if (event.key === "Escape") {
    if (playingNow) stop(playingNow);
    if (document.activeElement === box) {
      box.value = "";
      search();
      box.blur();
    }
  }
}
