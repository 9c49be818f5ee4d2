// A card for each scene, by group.

function screenOf(scene, place) {
  const image = make("img", {
    src: beside(scene, "png"), alt: scene.title || scene.name, width: scene.width,
    height: scene.height, loading: place < 6 ? "eager" : "lazy", decoding: "async",
  });
  if (!scene.film) return make("div", { class: "screen" }, image);
  const screen = make("button", {
    class: "screen", type: "button", "data-film": beside(scene, "mp4"), "aria-pressed": "false",
    "aria-label": `film of ${scene.name}, ${shortNumber(scene.seconds)} s`,
  }, image, make("i", { class: "sign" }, sign("M3.5 2v12L13.5 8z")), make("i", { class: "way" }));
  screen.style.aspectRatio = `${scene.width} / ${scene.height}`;
  listenToScreen(screen);
  return screen;
}

function factsOf(scene) {
  const fact = (value, word) => make("span", {}, make("b", {}, value), ` ${word}`);
  const counted = (count, word, words) => fact(String(count), count === 1 ? word : words);
  return make("div", { class: "facts" },
    counted(scene.bodies, "body", "bodies"),
    scene.joints > 0 ? counted(scene.joints, "joint", "joints") : null,
    fact(shortNumber(scene.seconds), "s"), fact(String(scene.hz), "steps/s"),
    scene.replay ? make("a", { class: "replay", href: beside(scene, "html") }, "step through it") : null);
}

/// The title is the scene's; its name is in the commands.
function cardOf(scene, place) {
  const title = make("h3", {}, make("a", { href: `#${encodeURIComponent(cardId(scene.name))}` },
    scene.title || scene.name));
  const card = make("article", { class: "card", id: cardId(scene.name), "data-scene": scene.name },
    screenOf(scene, place),
    make("div", { class: "words" }, title,
      scene.purpose ? make("p", { class: "purpose" }, scene.purpose) : null, factsOf(scene),
      make("div", { class: "commands" }, ...commandsOf(scene).map(commandRow))));
  return card;
}

function showCards() {
  let place = 0;
  for (const [name, scenes] of groups) {
    byId("groups").append(make("a", { href: `#${groupId(name)}`, "data-group": name }, name));
    byId("scenes").append(make("section", { id: groupId(name), "data-group": name },
      make("h2", {}, name, make("small", {}, String(scenes.length))),
      make("div", { class: "cards" }, ...scenes.map((scene) => cardOf(scene, place++)))));
  }
}
