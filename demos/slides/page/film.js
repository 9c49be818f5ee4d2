// The film of a slide. Frames are counted, and seeks go to the middle of a frame, so that rounding
// of the browser's clock never reaches another frame.

const fps = (film) => Number(film.dataset.fps);
const frames = (film) => Number(film.dataset.frames);
const frameOf = (film) => within(Math.floor(film.currentTime * fps(film) + 1e-4), 0, frames(film) - 1);
const ended = (film) => film.ended || (film.paused && frameOf(film) === frames(film) - 1);

/// The run's time at a frame, s; it may pass faster or slower than the film's.
const runTime = (film, frame) => Number(film.dataset.first) + frame * Number(film.dataset.step);

function whereIs(film) {
  const frame = frameOf(film);
  return `frame ${frame + 1} of ${frames(film)}, t = ${runTime(film, frame).toFixed(3)} s`;
}

/// Loads the films of this slide and its neighbours; others release their decoders.
function loadFilms() {
  leaves.forEach((leaf, i) => {
    const film = filmOf(leaf);
    if (!film) return;
    const near = Math.abs(i - view.at) <= 1;
    if (near && !film.src) film.src = film.dataset.film;
    if (!near && film.src) {
      film.removeAttribute("src");
      film.load();
    }
  });
}

function setWaiting(film, waits) { film.closest(".frame").classList.toggle("waits", waits); }
const waits = (film) => Boolean(film) && film.closest(".frame").classList.contains("waits");

function play(film) {
  setWaiting(film, false);
  film.playbackRate = film.defaultPlaybackRate = view.speed;
  film.play().catch((error) => {  // a browser that blocks autoplay
    if (error.name === "NotAllowedError") setWaiting(film, true);
  });
}

function stopFilms() {
  for (const leaf of leaves) filmOf(leaf)?.pause();
}

/// Shows the first frame; plays at once unless the film waits.
function enterFilm() {
  const film = filmNow();
  if (!film) return;
  seek(film, 0);
  const later = film.dataset.pause === "1" || calm.matches || speaks;
  setWaiting(film, later);
  if (!later) play(film);
}

function seek(film, frame) {
  film.pause();
  film.currentTime = (within(frame, 0, frames(film) - 1) + 0.5) / fps(film);
}

function seekAndSay(film, frame) {
  setWaiting(film, false);
  seek(film, frame);
  say(whereIs(film), 0);
}

function stepFilm(by) {
  const film = filmNow();
  if (film) seekAndSay(film, frameOf(film) + by);
}

function rewindFilm() {
  const film = filmNow();
  if (film) seekAndSay(film, 0);
}

function toggleFilm() {
  const film = filmNow();
  if (!film) return;
  if (film.paused) {
    if (ended(film)) seek(film, 0);
    say("");
    play(film);
  } else {
    film.pause();
    say(whereIs(film), 0);
  }
}

const kSpeeds = [0.1, 0.25, 0.5, 1, 1.5, 2, 4];
function changeSpeed(by) {
  view.speed = kSpeeds[within(kSpeeds.indexOf(view.speed) + by, 0, kSpeeds.length - 1)];
  const film = filmNow();
  if (film) film.playbackRate = film.defaultPlaybackRate = view.speed;
  say(`speed ${view.speed}`);
}

function showRun(film) {
  const bar = film.closest(".frame").querySelector(".run > i");
  bar.style.width = `${100 * (frameOf(film) + 1) / frames(film)}%`;
}

function listenToFilms() {
  const follow = (film) => {
    showRun(film);
    if (!film.paused) requestAnimationFrame(() => follow(film));
  };
  for (const film of leaves.map(filmOf).filter(Boolean)) {
    film.muted = true;  // for autoplay the attribute alone is not enough in every browser
    film.addEventListener("play", () => { follow(film); tellSpeaker(); });
    for (const event of ["pause", "seeked", "ended"]) film.addEventListener(event, () => { showRun(film); tellSpeaker(); });
    film.addEventListener("error", () => { if (film.src) film.classList.add("failed"); });
  }
}
