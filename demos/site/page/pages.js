// The list of pages on a phone, blocks to copy, and the heading that is being read.

function openMenu(open) {
  byId("pages").classList.toggle("open", open);
  byId("menu").setAttribute("aria-expanded", String(open));
}

async function copy(text) {
  await copyText(text);
  tell("Copied");
}

function addCopyButtons() {
  for (const block of document.querySelectorAll("main pre")) {
    const around = make("div", { class: "block" });
    block.replaceWith(around);
    around.append(block, make("button", {
      class: "copy", type: "button", onclick: () => copy(block.textContent.replace(/\n$/, "")),
    }, "copy"));
  }
}

/// Marks the heading at the top of the window in the list of headings.
function watchHeadings() {
  const links = [...document.querySelectorAll("#headings a")];
  const headings = links.map((link) => byId(decodeURIComponent(link.hash.slice(1))));
  const mark = () => {
    const passed = headings.filter((heading) => heading.getBoundingClientRect().top < 110).length;
    links.forEach((link, i) => link.classList.toggle("here", i === Math.max(passed - 1, 0)));
  };
  if (links.length === 0) return;
  addEventListener("scroll", mark, { passive: true });
  mark();
}
