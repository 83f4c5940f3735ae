// The best results, kept in this browser.

import { addressOf } from "./choices.js";

const KEY = "covey-chase-results";
const MOST = 8;

export function readResults() {
  try {
    const results = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    return Array.isArray(results) ? results.filter(({ share, choices }) => share > 0 && choices) : [];
  } catch {
    return []; // there is no storage, or it holds something else
  }
}

// Returns whether this result is the best so far with the same choices.
export function keepResult(result) {
  const address = addressOf(result.choices);
  const results = readResults();
  const before = results.find(({ choices }) => addressOf(choices) === address);
  if (before && before.share >= result.share) return false;
  const kept = [...results.filter((each) => each !== before), result];
  write(kept.sort((a, b) => b.share - a.share).slice(0, MOST));
  return true;
}

export function forgetResults() {
  write([]);
}

function write(results) {
  try {
    localStorage.setItem(KEY, JSON.stringify(results));
  } catch {
    // Without storage there are no best results, and the game goes on.
  }
}

export function showResults(list, none, forget) {
  const results = readResults();
  list.replaceChildren(
    ...results.map(({ share, time, choices }) => {
      const link = document.createElement("a");
      link.href = addressOf(choices);
      const parts = [
        ["b", percent(share)],
        ["span", `${choices.evaders} ${choices.sensing}, ${choices.start === "fig3" ? "Fig. 3" : `${choices.start} ${choices.seed}`}`],
        ["span", time.toFixed(2)],
      ];
      link.append(
        ...parts.map(([tag, text]) => Object.assign(document.createElement(tag), { textContent: text })),
      );
      const item = document.createElement("li");
      item.append(link);
      return item;
    }),
  );
  none.hidden = results.length > 0;
  forget.hidden = results.length === 0;
}

export function percent(share) {
  return `${Math.round(100 * share)} %`;
}
