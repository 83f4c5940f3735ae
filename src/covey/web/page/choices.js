// The form of choices. The page's address holds the choices, so a game can be shared.

const MOST_EVADERS = 10, MOST_ANSWERING = 8; // of a team that answers captures

const DEFAULTS = {
  evaders: 5, speed: 0.25, pursuer_speed: 1, turn_rate: 1.57, capture_radius: 0.03,
  sensing: "visible", team: "iterative-open-loop", start: "random", seed: 1,
};

export class Choices {
  constructor(form, onChange) {
    this.form = form;
    this.show({ ...DEFAULTS, ...fromAddress(location.search) });
    form.addEventListener("input", () => this.label());
    form.addEventListener("change", () => onChange());
    form.addEventListener("submit", (event) => event.preventDefault());
    addEventListener("popstate", () => {
      this.show({ ...DEFAULTS, ...fromAddress(location.search) });
      onChange();
    });
  }

  get values() {
    const data = Object.fromEntries(new FormData(this.form));
    const values = {};
    for (const [name, standard] of Object.entries(DEFAULTS)) {
      const value = data[name] ?? standard;
      values[name] = typeof standard === "number" ? Number(value) : value;
    }
    values.turn_rate = Number(values.turn_rate.toFixed(2));
    if (values.start === "fig3") values.evaders = 5;
    return values;
  }

  show(values) {
    this.limitEvaders(values.team);
    for (const [name, value] of Object.entries(values)) {
      const field = this.form.elements[name];
      if (field) field.value = value;
    }
    this.label();
  }

  limitEvaders(team) {
    this.form.elements.evaders.max = team === "contingent" ? MOST_ANSWERING : MOST_EVADERS;
  }

  // Numbers beside their sliders; Fig. 3 has five evaders and no seed to place them.
  label() {
    this.limitEvaders(this.form.elements.team.value);
    const fig3 = this.form.elements.start.value === "fig3";
    if (fig3) this.form.elements.evaders.value = 5;
    this.form.elements.evaders.disabled = fig3;
    for (const slider of this.form.querySelectorAll(".slider")) {
      const value = Number(slider.querySelector("input").value);
      slider.querySelector(".value").textContent = String(Number(value.toFixed(2)));
    }
  }

  // Fig. 3 is one start only.
  anotherStart() {
    if (this.form.elements.start.value === "fig3") this.form.elements.start.value = "random";
    this.label();
    this.form.elements.seed.value = Math.floor(Math.random() * 10000);
  }

  writeAddress() {
    history.replaceState(null, "", addressOf(this.values));
  }
}

export function addressOf(values) {
  return `?${new URLSearchParams(values)}`;
}

function fromAddress(search) {
  const given = new URLSearchParams(search);
  return Object.fromEntries([...given].filter(([name]) => name in DEFAULTS));
}
