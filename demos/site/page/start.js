document.body.classList.add("scripted");
byId("menu").addEventListener("click", () => openMenu(byId("menu").getAttribute("aria-expanded") !== "true"));
addCopyButtons();
watchHeadings();
listenToSearch();
document.body.dataset.ready = "1";
