// Time as a line: now, the captures, the guarantee, the survival time with the best pursuer known.

const WORDS = { guaranteed: 104, reference: 110 }; // pixels

export class Timeline {
  constructor(fill, marks, scrub, onScrub) {
    Object.assign(this, { fill, marks, scrub, drawn: "" });
    scrub.addEventListener("input", () => onScrub(Number(scrub.value)));
  }

  // `end` of a film that can be scrubbed through, or null during a game.
  show({ time, captures, guarantee, sure, reference, end, unit }) {
    const known = [guarantee, reference ?? 0, end ?? 0];
    const span = Math.max(1.2 * Math.max(...known), end === null ? 1.02 * time : 0) || 1;
    this.fill.style.width = `${(100 * time) / span}%`;
    this.scrub.hidden = end === null;
    this.scrub.max = span;
    if (end !== null) {
      this.scrub.value = time;
      this.scrub.setAttribute("aria-valuetext", `time ${short(time)} of ${short(end, unit)}`);
    }
    const width = this.marks.clientWidth;
    const key = [span.toFixed(3), guarantee, sure, reference, captures.length, width].join();
    if (key === this.drawn) return;
    this.drawn = key;
    const marks = [mark("guaranteed", guarantee / span, `${nameOf(sure)} ${short(guarantee, unit)}`)];
    if (reference !== null) {
      const early = Math.min(guarantee, reference) / span;
      const late = Math.max(guarantee, reference) / span;
      marks.push(mark("reference", reference / span, `best known ${short(reference, unit)}`));
      // The words are outside of the two marks or, without room there, at the ends; in a tight
      // line the later word is below.
      const [first, last] = guarantee <= reference ? ["guaranteed", "reference"] : ["reference", "guaranteed"];
      const roomy = width * early > WORDS[first] && width * (1 - late) > WORDS[last];
      marks.forEach((each, k) => each.classList.add((k === 0) === (guarantee <= reference) ? "left-of" : "right-of"));
      this.marks.classList.toggle("narrow", !roomy);
      this.marks.classList.toggle("tight", width < WORDS.guaranteed + WORDS.reference);
    }
    marks.push(...captures.map(([, when]) => mark("capture", when / span, "")));
    this.marks.replaceChildren(...marks);
  }
}

function mark(kind, share, text) {
  const element = document.createElement("div");
  element.className = `mark ${kind}`;
  element.style.setProperty("--share", `${100 * share}%`);
  if (text) element.append(Object.assign(document.createElement("span"), { textContent: text }));
  return element;
}

// Only some teams always survive as long as their first plan guarantees (`sure`).
export function nameOf(sure) {
  return sure ? "guaranteed" : "first plan";
}

// Of two times as they are shown: 5.23 is 0.39 above 4.84, whatever further digits say.
export function difference(time, earlier, unit) {
  return short(Math.max(Number(short(time)) - Number(short(earlier)), 0), unit);
}

// `unit` is "" where the game names none.
export function short(time, unit = "") {
  const number = (time >= 0.01 && time < 10000) || time === 0 ? time.toFixed(2) : time.toPrecision(3);
  return unit ? `${number} ${unit}` : number;
}
