// The page: sends the choices and the steering to the server, and shows what the server plays.

import { Board } from "./board.js";
import { Camera } from "./camera.js";
import { Card } from "./card.js";
import { Choices } from "./choices.js";
import { Connection } from "./connection.js";
import { Playback } from "./playback.js";
import { forgetResults, keepResult, showResults } from "./results.js";
import { Steering, steers } from "./steering.js";
import { followTheme } from "./theme.js";
import { Timeline, difference, short } from "./timeline.js";

const at = (id) => document.getElementById(id);
const PLAY = "M8 5v14l11-7z";
const PAUSE = "M7 5h4v14H7zM13 5h4v14h-4z";
const STEER_EVERY = 1000 / 70; // ms: below the server's rate limit

const camera = new Camera();
const board = new Board(at("board"), camera);
const card = new Card(at("card"));
const playback = new Playback();
const timeline = new Timeline(at("fill"), at("marks"), at("scrub"), (time) => playback.seek(time));
const choices = new Choices(at("choices"), newGame);
const steering = new Steering(at("board"), camera, pressed);
const connection = new Connection(received, saveFile, connected);

// `game`, the person's game: "none", "ready", "live", "over". `watching`: the whole game that is shown instead.
const state = { game: "none", reference: null, assurance: null, score: null, watching: null, watchedTime: null, best: false, updateTime: 1 };
let drawnAt = performance.now();
let steeredAt = 0;
let toastTimer = 0;

at("board").camera = camera; // for scripts that play: it maps the plane to the screen

// The person's game.

function newGame() {
  choices.writeAddress();
  state.game = "none";
  state.watching = null;
  card.waiting("The team is planning …");
  connection.send({ type: "new", choices: choices.values });
}

function anotherGame() {
  choices.anotherStart();
  newGame();
}

function run() {
  state.game = "live";
  playback.running = true;
  card.hide();
  steering.reset();
  connection.send({ type: "run", pace: playback.pace });
}

function pause() {
  playback.running = false;
  if (playback.isLive) connection.send({ type: "pause" });
}

function pressed() {
  if (playback.isLive && (state.game === "ready" || (state.game === "live" && !playback.running))) run();
}

function playOrPause() {
  if (!playback.film) return;
  if (playback.running) pause();
  else if (!playback.isLive) {
    if (playback.ended) playback.time = 0;
    card.hide();
    playback.running = true;
  } else if (state.game === "over") newGame();
  else if (state.game !== "none") run();
}

function step() {
  if (!playback.film) return;
  if (!playback.isLive) playback.step();
  else if (state.game === "ready" || state.game === "live") {
    state.game = "live";
    playback.running = false;
    card.hide();
    steer();
    connection.send({ type: "step" });
  }
}

function steer() {
  const message = steering.message();
  if (message) connection.send(message);
}

// What comes from the server.

function received(message) {
  const handlers = { game: gameIsSet, reference: referenceIsKnown, frame: framePlayed, over: gameIsOver, film: filmCame, error: failed };
  handlers[message.type](message);
}

function gameIsSet({ cast, picture, update_time: updateTime }) {
  Object.assign(state, { game: "ready", reference: null, assurance: null, score: null, watching: null, best: false, updateTime });
  playback.begin(cast, picture);
  card.ready(cast);
  camera.cut(positions(playback.moment), insets());
  board.heading = Math.PI / 2;
  say(`Game ready. ${cast.sure ? "The team is sure to survive for" : "The team's first plan is worth"} ${short(cast.guarantee)}.`);
}

function referenceIsKnown({ survival_time: time, assurance }) {
  Object.assign(state, { reference: time, assurance });
}

function framePlayed(picture) {
  if (state.game === "none") return;
  const before = playback.live.pictures.at(-1).captured.length;
  playback.add(picture, performance.now() / 1000);
  if (picture.captured.length > before && playback.isLive) {
    const [i, when] = picture.captured.at(-1);
    board.flash(picture.evaders[i][0], picture.evaders[i][1], performance.now());
    say(`Captured at ${short(when)}, ${picture.sequence.length} left.`);
  }
  showRate(picture.rate);
}

function gameIsOver(score) {
  if (state.game === "none") return;
  state.game = "over";
  state.score = score;
  playback.running = false;
  if (score.time !== null) {
    state.best = keepResult({ share: score.share, time: score.time, choices: choices.values });
    showBest();
  }
  showOver();
  say(score.time === null ? "Time is up." : `Game over: survival time ${short(score.time)}, ${Math.round(100 * score.share)} percent of the best pursuer known.`);
}

function showOver() {
  const { guarantee, sure } = playback.live.cast;
  const figures = { guarantee, sure, reference: state.reference, assurance: state.assurance, best: state.best };
  card.over(state.score, figures, [
    ["Play again", newGame],
    ["Another start", anotherGame],
    ["Watch the best pursuer", () => watch("reference")],
    ["Replay yours", () => watch("yours")],
  ]);
}

function filmCame({ game, cast, pictures, survival_time: time }) {
  Object.assign(state, { watching: game, watchedTime: time });
  playback.load(cast, pictures);
  card.hide();
  camera.cut(positions(playback.moment), insets());
  scrollTo(0, 0); // on a phone the button may be far below the board
}

function failed({ text }) {
  toast(text);
  if (state.game === "none") card.waiting("This game can't be played");
}

function connected(open, reason) {
  if (open) {
    newGame();
    return;
  }
  state.game = "none";
  playback.running = false;
  card.waiting(reason || "The server is gone; trying again …");
}

// Whole games, and their records.

function watch(which) {
  if (state.game === "none") return;
  pause();
  connection.send({ type: "film", game: which });
}

function backToGame() {
  if (!playback.live) {
    newGame();
    return;
  }
  state.watching = null;
  playback.showLive();
  camera.cut(positions(playback.moment), insets());
  if (state.game === "ready") card.ready(playback.live.cast);
  else if (state.game === "over") showOver();
  else card.hide();
}

function saveFile(content) {
  const { sensing, start, seed } = choices.values;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type: "application/vnd.apache.parquet" }));
  link.download = `chase-${sensing}-${start}-${seed}.parquet`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

async function openFile(file) {
  if (!file) return;
  pause();
  if (!connection.sendFile(await file.arrayBuffer())) toast(`${file.name} is too large to be shown; use covey draw`);
}

// Positions to show: everybody in the game and, when it is over, all that was flown.

function positions({ evaders, sequence, pursuer }) {
  const alive = sequence.map((i) => evaders[i]);
  const flown = sequence.length ? [] : playback.film.pictures.map((picture) => picture.pursuer);
  return [...(sequence.length ? alive : evaders), ...flown, pursuer];
}

// Pixels at each side of the board that are covered by other elements.
function insets() {
  const small = innerWidth <= 820;
  const room = { top: small ? 76 : 40, bottom: 90, left: 24, right: 24 };
  if (card.isReady) room.bottom = at("board").getBoundingClientRect().bottom - at("card").getBoundingClientRect().top + 16;
  else if (!at("card").hidden && small) room.bottom = 100 + at("card").offsetHeight;
  else if (!at("card").hidden) room.left = 410;
  return room;
}

function draw(now) {
  const seconds = Math.min((now - drawnAt) / 1000, 0.1);
  drawnAt = now;
  if (playback.film) {
    const wasRunning = playback.running;
    playback.advance(seconds);
    if (wasRunning && playback.ended) filmEnded();
    if (playback.isLive && playback.running && now - steeredAt > STEER_EVERY) {
      steeredAt = now;
      steer();
    }
    drawMoment(playback.moment, now, seconds);
  }
  requestAnimationFrame(draw);
}

function drawMoment(moment, now, seconds) {
  camera.follow(positions(moment), insets(), seconds);
  const target = playback.isLive && state.game === "live" ? steering.target : null;
  board.draw(playback.film, moment, { beliefs: at("beliefs").checked, target, now });
  const { cast } = playback.film;
  at("clock").textContent = short(moment.time || 0, cast.units.time);
  at("left-chip").textContent = `${moment.sequence.length} of ${cast.evaders} alive`;
  at("mode-chip").textContent = `${cast.sensing} pursuer`;
  at("clock-label").textContent = label(moment.time, cast);
  at("legend-disk").hidden = cast.sensing !== "hidden";
  at("legend-grid").hidden = !cast.units.length;
  at("grid-step").textContent = `${Number(board.gridStep.toPrecision(1))} ${cast.units.length} wide`;
  at("back").hidden = at("rate-chip").hidden = true;
  at(state.watching ? "back" : "rate-chip").hidden = false;
  timeline.show({
    time: moment.time,
    captures: moment.captured,
    guarantee: cast.guarantee,
    sure: cast.sure,
    reference: state.watching === "opened" ? null : state.reference,
    end: playback.isLive ? null : playback.film.end,
    unit: cast.units.time,
  });
  showButtons();
}

function label(time, { guarantee, sure, units }) {
  const what = { reference: "the best pursuer known", yours: "replay of your game", opened: "record" }[state.watching];
  return `${what ?? "survival time"}${time > guarantee ? `, ${difference(time, guarantee, units.time)} above the ${sure ? "guarantee" : "first plan"}` : ""}`;
}

function showButtons() {
  const { running } = playback;
  at("play-shape").setAttribute("d", running ? PAUSE : PLAY);
  at("play").setAttribute("aria-label", running ? "Pause" : state.game === "ready" || playback.ended ? "Start" : "Go on");
  at("save").disabled = state.watching === "opened" || (state.watching !== "reference" && state.game !== "over");
  at("step").disabled = playback.isLive && state.game === "over";
}

function filmEnded() {
  card.watched(state.watching, state.watchedTime, playback.film.cast.units.time, [
    ["Play yourself", () => (state.game === "over" ? newGame() : backToGame())],
    ["Watch again", playOrPause],
  ]);
}

function showRate(rate) {
  const wanted = playback.pace / state.updateTime;
  const slow = rate > 0 && rate < 0.85 * wanted;
  at("rate-chip").textContent = rate > 0 ? `${Math.round(rate)} updates a second${slow ? ", slowed down" : ""}` : "–";
  at("rate-chip").classList.toggle("slow", slow);
}

function showBest() {
  showResults(at("best"), at("best-none"), at("forget"));
}

function say(text) {
  at("said").textContent = text;
}

function toast(text) {
  at("toast").textContent = text;
  at("toast").hidden = false;
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => (at("toast").hidden = true), 6000);
}

async function share() {
  try {
    await navigator.clipboard.writeText(location.href);
    say("The link is copied.");
    at("share").textContent = "Copied";
  } catch {
    prompt("The address of this game:", location.href); // no clipboard without https or localhost
  }
  setTimeout(() => (at("share").textContent = "Copy link"), 2000);
}

// Buttons and keys.

const KEYS = {
  Space: playOrPause,
  Period: step,
  KeyR: newGame,
  KeyN: anotherGame,
  KeyP: () => at("beliefs").click(),
};

document.addEventListener("keydown", (event) => {
  const action = KEYS[event.code];
  if (!action || !steers(event) || event.repeat) return;
  event.preventDefault();
  action();
});
document.addEventListener("visibilitychange", () => document.hidden && playback.running && pause());
addEventListener("resize", () => board.resize());
at("play").addEventListener("click", playOrPause);
at("step").addEventListener("click", step);
at("again").addEventListener("click", newGame);
at("back").addEventListener("click", backToGame);
at("dice").addEventListener("click", anotherGame);
at("watch").addEventListener("click", () => watch("reference"));
at("save").addEventListener("click", () => connection.send({ type: "save", game: state.watching === "reference" ? "reference" : "yours" }));
at("open").addEventListener("change", ({ target }) => {
  openFile(target.files[0]);
  target.value = "";
});
at("share").addEventListener("click", share);
at("forget").addEventListener("click", () => {
  forgetResults();
  showBest();
});
at("pace").addEventListener("change", ({ target }) => {
  playback.pace = Number(target.value);
  if (playback.isLive && playback.running) connection.send({ type: "run", pace: playback.pace });
});

at("pace").value = "0.5";
playback.pace = 0.5;
followTheme(at("theme"), () => board.readPalette());
board.resize();
showBest();
requestAnimationFrame(draw);
