// A card's picture: its poster, and over it the film, which is loaded when it is first played.

const calm = matchMedia("(prefers-reduced-motion: reduce)");
let playingNow = null;  // the screen whose film runs

/// The video of a screen, created at its first use.
function filmOf(screen) {
  const known = screen.querySelector("video");
  if (known) return known;
  const video = make("video", {
    src: screen.dataset.film, preload: "none", playsinline: true, "aria-hidden": "true",
    tabindex: "-1",
  });
  video.muted = video.loop = true;
  video.addEventListener("playing", () => screen.classList.add("playing"));
  video.addEventListener("timeupdate", () => {
    const way = video.duration > 0 ? video.currentTime / video.duration : 0;
    screen.querySelector(".way").style.transform = `scaleX(${way})`;
  });
  screen.insertBefore(video, screen.querySelector(".sign"));
  return video;
}

function stop(screen) {
  if (playingNow === screen) playingNow = null;
  screen.classList.remove("playing");
  screen.setAttribute("aria-pressed", "false");
  const video = screen.querySelector("video");
  if (!video) return;
  video.pause();
  video.currentTime = 0;
}

async function play(screen) {
  if (playingNow === screen) return;
  if (playingNow) stop(playingNow);
  playingNow = screen;
  screen.setAttribute("aria-pressed", "true");
  try {
    await filmOf(screen).play();
  } catch (error) {
    // AbortError: the pointer left before the film began. Other errors are reported.
    if (error.name !== "AbortError" && playingNow === screen) {
      stop(screen);
      tell(`${screen.dataset.film} does not play here`);
    }
  }
}

/// Hover and focus play it, leaving stops it, a tap toggles it; with reduced motion only a tap.
function listenToScreen(screen) {
  let touched = false;
  screen.addEventListener("pointerenter", (event) => {
    touched = event.pointerType === "touch";
    if (!touched && !calm.matches) play(screen);
  });
  screen.addEventListener("pointerleave", (event) => {
    if (event.pointerType !== "touch" && !calm.matches) stop(screen);
  });
  screen.addEventListener("focus", () => {
    if (!calm.matches && screen.matches(":focus-visible")) play(screen);
  });
  screen.addEventListener("blur", () => stop(screen));
  screen.addEventListener("click", (event) => {
    const hovering = !touched && !calm.matches && event.detail > 0;
    if (playingNow !== screen) play(screen);
    else if (!hovering) stop(screen);
  });
}
