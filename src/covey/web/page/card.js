// The card over the board: what to do next, and the result of a game.

import { percent } from "./results.js";
import { difference, short } from "./timeline.js";

export class Card {
  constructor(root) {
    this.root = root;
    this.part = (name) => root.querySelector(`#card-${name}`);
  }

  hide() {
    this.root.hidden = true;
  }

  get isReady() {
    return !this.root.hidden && this.root.classList.contains("ready");
  }

  show({ title, text = "", score = "", figures = [], actions = [], ready = false }) {
    this.root.hidden = false;
    this.root.classList.toggle("ready", ready);
    this.part("title").textContent = title;
    this.part("text").textContent = text;
    this.part("score").textContent = score;
    this.part("score").hidden = !score;
    this.part("figures").hidden = figures.length === 0;
    this.part("figures").replaceChildren(...figures.map(figure));
    this.part("actions").replaceChildren(...actions.map(button));
  }

  waiting(text) {
    this.show({ title: text, ready: true });
  }

  ready(cast) {
    const many = cast.evaders === 1 ? "One evader is" : `${cast.evaders} evaders are`;
    this.show({
      title: "Press on the board to start",
      text: cast.sure
        ? `${many} sure to last for ${short(cast.guarantee)}, whatever you do. How close do you get?`
        : `Nothing is sure: the first plan is worth ${short(cast.guarantee)}, and may be given up.`,
      ready: true,
    });
  }

  over({ time, share }, { guarantee, sure, reference, assurance, best }, actions) {
    if (time === null) {
      const text = "The game was stopped at its time limit with evaders alive.";
      this.show({ title: "They got away", text, actions });
      return;
    }
    this.show({
      title: best ? "Your best at this game" : "All captured",
      score: percent(share),
      text: sure
        ? `as quick as the best pursuer known, and ${difference(time, guarantee)} above what the team was sure of.`
        : "as quick as the best pursuer known.",
      figures: [
        ["you", "You", short(time)],
        ["reference", "Best known", short(reference)],
        ["guaranteed", sure ? "Guaranteed" : "First plan", short(guarantee)],
        ["assured", "Assured", short(assurance)],
      ],
      actions,
    });
  }

  watched(which, time, unit, actions) {
    const titles = { reference: "The best pursuer known", yours: "Your game", opened: "The record" };
    const text = time === null ? "Not everybody was captured." : `The last was captured at ${short(time, unit)}.`;
    this.show({ title: titles[which], text, actions, ready: true });
  }
}

function figure([kind, name, value]) {
  const box = document.createElement("div");
  box.className = kind;
  box.append(
    Object.assign(document.createElement("dt"), { textContent: name }),
    Object.assign(document.createElement("dd"), { textContent: value }),
  );
  return box;
}

function button([text, onClick], index) {
  const element = Object.assign(document.createElement("button"), { textContent: text });
  if (index === 0) element.className = "primary";
  element.addEventListener("click", onClick);
  return element;
}
