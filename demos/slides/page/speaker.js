// A second window for the speaker: the same file, as #speaker. The two windows communicate by
// postMessage, which also works between files on a disk, each of which is its own origin.

let speaker = null;           // used in the talk's window
const clock = { began: Date.now() };

function openSpeaker() {
  if (speaks) return;
  speaker = window.open(location.href.replace(/#.*/, "") + "#speaker", "impulse-speaker", "width=1200,height=800");
  if (!speaker) say("the browser blocked the speaker's window: allow pop-ups for this page", 6000);
}

function tellSpeaker() {
  if (speaks || !speaker || speaker.closed) return;
  const film = filmNow();
  speaker.postMessage({ impulse: "state", at: view.at, part: view.part, black: !byId("black").hidden,
    film: film && { time: film.currentTime, paused: film.paused, waits: waits(film), speed: view.speed } }, "*");
}

const tellTalk = (message) => window.opener?.postMessage({ impulse: "speaker", ...message }, "*");

/// Accepts messages only from the window that this one has opened, even if this one was reloaded.
function hearSpeaker(event) {
  if (event.data?.impulse !== "speaker" || event.source?.opener !== window) return;
  speaker = event.source;
  if (event.data.key) press(event.data.key, Boolean(event.data.shift));
  tellSpeaker();
}

function hearTalk(event) {
  if (event.data?.impulse !== "state" || event.source !== window.opener) return;
  const { at, part, film, black } = event.data;
  if (at !== view.at || !leafNow().classList.contains("seen")) show(at, part);
  showParts(part);
  byId("black").hidden = !black;
  document.body.dataset.heard = at + 1;
  const mine = filmNow();
  if (!mine || !film) return;
  setWaiting(mine, film.waits);
  mine.playbackRate = film.speed;
  if (Math.abs(mine.currentTime - film.time) > 0.1 || film.paused) mine.currentTime = film.time;
  if (film.paused) mine.pause();
  else mine.play().catch(() => {});
}

function showNext() {
  const next = leaves[view.at + 1];
  if (!next) {
    const end = document.createElement("p");
    end.textContent = "the end";
    byId("next").replaceChildren(end);
    return;
  }
  const copy = slideOf(next).cloneNode(true);
  for (const film of copy.querySelectorAll("video")) film.remove();
  byId("next").replaceChildren(copy);
}

function showClock() {
  const seconds = Math.floor((Date.now() - clock.began) / 1000);
  const two = (n) => String(n).padStart(2, "0");
  byId("elapsed").textContent = `${Math.floor(seconds / 60)}:${two(seconds % 60)}`;
  const now = new Date();
  byId("of-day").textContent = `${two(now.getHours())}:${two(now.getMinutes())}`;
}

function becomeSpeaker() {
  document.body.classList.add("speaks");
  byId("desk").hidden = byId("notes").hidden = false;
  byId("restart").addEventListener("click", () => { clock.began = Date.now(); showClock(); });
  window.addEventListener("message", hearTalk);
  document.title += " \u2013 speaker";
  showClock();
  setInterval(() => { showClock(); tellTalk({}); }, 1000);  // reconnects after the talk is reloaded
  tellTalk({});
  if (!window.opener) say("opened without the talk: press s in the talk's window instead", 0);
}
