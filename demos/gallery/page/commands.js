// The commands of a card, to be copied into a shell.

/// Quoted so that a POSIX shell reads it as one word.
const quoted = (word) =>
  (/^[\w./=,:+@%-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/// [purpose, command] of a scene, with the options that the gallery was made with.
function commandsOf(scene) {
  const command = (...words) => ["impulse", ...words].map(quoted).join(" ");
  const read = scene.file || scene.name, { run, picture } = gallery.options;
  return [
    ["film", command("render", read, ...run, ...picture, "-o", `${scene.name}.mp4`)],
    scene.file ? ["checks", command("sim", read, ...run)] : ["file", command("list", read, "--print")],
    ["replay", command("export", read, ...run, "-o", `${scene.name}.html`)],
  ];
}

const copySign = "M6 5.5V3.2c0-.7.5-1.2 1.2-1.2h5.6c.7 0 1.2.5 1.2 1.2v5.6c0 .7-.5 1.2-1.2 1.2h-2.3" +
  "M3.2 6h5.6c.7 0 1.2.5 1.2 1.2v5.6c0 .7-.5 1.2-1.2 1.2H3.2C2.5 14 2 13.5 2 12.8V7.2C2 6.5 2.5 6 3.2 6z";
const doneSign = "M3 8.5l3.2 3.2L13 5";

function commandRow([purpose, command]) {
  const row = make("button", { class: "command", type: "button", title: `copy: ${command}` },
    make("span", {}, purpose), make("code", {}, command), sign(copySign));
  row.addEventListener("click", async () => {
    await copyText(command);
    tell(`Copied: ${command}`);
    row.classList.add("copied");
    row.querySelector("path").setAttribute("d", doneSign);
    setTimeout(() => {
      row.classList.remove("copied");
      row.querySelector("path").setAttribute("d", copySign);
    }, 1600);
  });
  return row;
}
