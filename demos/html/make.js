// The beginning of every page's script.

const byId = (id) => document.getElementById(id);

/// An element with attributes and children; text is always text, never markup.
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "onclick") element.addEventListener("click", value);
    else if (value !== false && value !== null) element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

const plural = (count, one, many) => `${count} ${count === 1 ? one : many}`;

/// Shows a line for a moment, on pages with an element for it.
function tell(text) {
  byId("told").textContent = text;
  byId("told").classList.add("shown");
  clearTimeout(tell.end);
  tell.end = setTimeout(() => byId("told").classList.remove("shown"), 1600);
}

async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {  // a page from a file, in some browsers
    const field = make("textarea", { readonly: true, style: "position:fixed;opacity:0" });
    field.value = text;
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }
}
