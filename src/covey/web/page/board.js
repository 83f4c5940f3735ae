// Draws one moment of a game. Sizes are in CSS pixels, positions in the game's lengths.

import { ahead } from "./film.js";

const TAU = 2 * Math.PI;
const NAMES = ["board", "ink", "soft", "grid", "team", "captured", "pursuer", "disk", "disk-edge", "panel"];

export class Board {
  constructor(canvas, camera) {
    this.canvas = canvas;
    this.camera = camera;
    this.context = canvas.getContext("2d");
    this.palette = {};
    this.heading = Math.PI / 2;
    this.flashes = [];
    this.readPalette();
  }

  readPalette() {
    const style = getComputedStyle(document.documentElement);
    for (const name of NAMES) this.palette[name] = style.getPropertyValue(`--${name}`).trim();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas;
    const density = Math.min(devicePixelRatio || 1, 2.5);
    this.canvas.width = Math.round(clientWidth * density);
    this.canvas.height = Math.round(clientHeight * density);
    this.context.setTransform(density, 0, 0, density, 0, 0);
    this.camera.resize(clientWidth, clientHeight);
  }

  // A ring that spreads from a capture, unless the system asks for reduced motion.
  flash(x, y, now) {
    if (!this.camera.reducedMotion.matches) this.flashes.push({ x, y, since: now });
  }

  draw(film, moment, { beliefs, target, now }) {
    const context = this.context;
    context.clearRect(0, 0, this.camera.width, this.camera.height);
    context.lineCap = "round";
    context.lineJoin = "round";
    this.drawGrid();
    if (film.cast.sensing === "hidden") this.drawDisk(moment.disk);
    this.drawTrails(film, moment);
    if (beliefs) this.drawPlans(film.cast, moment);
    this.drawCaptured(moment);
    this.drawEvaders(moment);
    if (target) this.drawTarget(moment.pursuer, target);
    this.drawPursuer(film.cast, moment);
    this.drawFlashes(now);
  }

  // The side of a square of the grid.
  get gridStep() {
    return niceStep(70 / this.camera.scale);
  }

  drawGrid() {
    const { width, height } = this.camera;
    const step = this.gridStep;
    const [left, top] = this.camera.toPlane(0, 0);
    const [right, bottom] = this.camera.toPlane(width, height);
    this.stroke(this.palette.grid, 1);
    for (let x = Math.ceil(left / step) * step; x < right; x += step) this.line([[x, bottom], [x, top]]);
    for (let y = Math.ceil(bottom / step) * step; y < top; y += step) this.line([[left, y], [right, y]]);
  }

  drawDisk([x, y, radius]) {
    this.circle(x, y, radius * this.camera.scale);
    this.context.fillStyle = this.palette.disk;
    this.context.fill();
    this.stroke(this.palette["disk-edge"], 1.5, [2, 5]);
    this.context.stroke();
    this.stroke(this.palette["disk-edge"], 1.5);
    for (const [a, b] of [[5, 0], [0, 5]]) {
      const [centerX, centerY] = this.camera.toScreen(x, y);
      this.context.beginPath();
      this.context.moveTo(centerX - a, centerY - b);
      this.context.lineTo(centerX + a, centerY + b);
      this.context.stroke();
    }
  }

  drawTrails(film, moment) {
    const stride = Math.max(1, Math.floor(moment.index / 400));
    const rows = [];
    for (let k = 0; k <= moment.index; k += stride) rows.push(film.pictures[k]);
    this.context.globalAlpha = 0.38;
    this.stroke(this.palette.team, 3.5);
    moment.evaders.forEach((evader, i) => this.line([...rows.map((row) => row.evaders[i]), evader]));
    this.context.globalAlpha = 0.6;
    this.stroke(this.palette.pursuer, 1.5);
    this.line([...rows.map((row) => row.pursuer), moment.pursuer]);
    this.context.globalAlpha = 1;
  }

  drawPlans(cast, moment) {
    const passed = moment.time - moment.plannedAt;
    const places = moment.sequence.map((i, k) => {
      const wait = Math.max(moment.expected[k] - moment.plannedAt, passed);
      const path = [];
      for (let part = 0; part <= 40; part += 1) {
        const when = passed + ((wait - passed) * part) / 40;
        path.push(ahead(moment.planned[i], cast.speeds[i], cast.turn_rates[i], when));
      }
      this.stroke(this.palette.team, 2, [6, 6]);
      this.line(path);
      return path[40];
    });
    const [x, y, radius] = moment.disk;
    if (places.length) {
      const distance = Math.hypot(places[0][0] - x, places[0][1] - y) || 1;
      const share = Math.min(1, radius / distance);
      const begin = [x + share * (places[0][0] - x), y + share * (places[0][1] - y)];
      this.stroke(this.palette.soft, 1.2, [1, 5]);
      this.line([begin, ...places]);
    }
    places.forEach(([placeX, placeY], k) => this.drawExpected(placeX, placeY, moment.sequence[k]));
  }

  drawExpected(x, y, number) {
    const context = this.context;
    this.circle(x, y, 9);
    context.fillStyle = this.palette.board;
    context.fill();
    this.stroke(this.palette.captured, 1.5);
    context.stroke();
    this.text(x, y, number, this.palette.captured);
  }

  drawCaptured(moment) {
    moment.captured.forEach(([i]) => {
      const [x, y] = moment.evaders[i];
      this.circle(x, y, 9);
      this.context.fillStyle = this.palette.captured;
      this.context.fill();
      this.text(x, y, i, this.palette.board);
    });
  }

  drawEvaders(moment) {
    for (const i of moment.sequence) {
      const [x, y, heading] = moment.evaders[i];
      const [screenX, screenY] = this.camera.toScreen(x, y);
      const context = this.context;
      context.save();
      context.translate(screenX, screenY);
      context.rotate(-heading);
      context.beginPath();
      context.moveTo(16, 0);
      context.lineTo(3.6, 7.2);
      context.arc(0, 0, 8, 1.1, TAU - 1.1);
      context.closePath();
      context.fillStyle = this.palette.team;
      context.fill();
      this.stroke(this.palette.board, 1.5);
      context.stroke();
      context.restore();
      this.text(x, y, i, this.palette.board);
    }
  }

  drawTarget([x, y], [goalX, goalY]) {
    this.context.globalAlpha = 0.5;
    this.stroke(this.palette.pursuer, 1, [3, 5]);
    this.line([[x, y], [goalX, goalY]]);
    this.stroke(this.palette.pursuer, 1.2);
    this.circle(goalX, goalY, 6);
    this.context.stroke();
    this.context.globalAlpha = 1;
  }

  drawPursuer(cast, moment) {
    const [dx, dy] = moment.flight;
    if (dx !== 0 || dy !== 0) this.heading = Math.atan2(dy, dx);
    const [x, y] = moment.pursuer;
    const context = this.context;
    this.stroke(this.palette.pursuer, 1.2);
    this.circle(x, y, Math.max(cast.capture_radius * this.camera.scale, 1));
    context.globalAlpha = 0.12;
    context.fillStyle = this.palette.pursuer;
    context.fill();
    context.globalAlpha = 0.8;
    context.stroke();
    context.globalAlpha = 1;
    const [screenX, screenY] = this.camera.toScreen(x, y);
    context.save();
    context.translate(screenX, screenY);
    context.rotate(-this.heading);
    context.beginPath();
    context.moveTo(15, 0);
    context.lineTo(-9, 9.5);
    context.lineTo(-5, 0);
    context.lineTo(-9, -9.5);
    context.closePath();
    context.fillStyle = this.palette.pursuer;
    context.fill();
    this.stroke(this.palette.board, 1.5);
    context.stroke();
    context.restore();
  }

  drawFlashes(now) {
    this.flashes = this.flashes.filter(({ since }) => now - since < 700);
    for (const { x, y, since } of this.flashes) {
      const share = (now - since) / 700;
      this.context.globalAlpha = 1 - share;
      this.stroke(this.palette.captured, 3 * (1 - share) + 0.5);
      this.circle(x, y, 10 + 46 * share);
      this.context.stroke();
    }
    this.context.globalAlpha = 1;
  }

  stroke(color, width, dashes = []) {
    this.context.strokeStyle = color;
    this.context.lineWidth = width;
    this.context.setLineDash(dashes);
  }

  line(places) {
    this.context.beginPath();
    for (const [x, y] of places) this.context.lineTo(...this.camera.toScreen(x, y));
    this.context.stroke();
  }

  circle(x, y, pixels) {
    this.context.beginPath();
    this.context.arc(...this.camera.toScreen(x, y), pixels, 0, TAU);
  }

  text(x, y, text, color) {
    const [screenX, screenY] = this.camera.toScreen(x, y);
    this.context.fillStyle = color;
    this.context.font = '600 11px system-ui, "DejaVu Sans", sans-serif';
    this.context.textAlign = "center";
    this.context.textBaseline = "middle";
    this.context.fillText(String(text), screenX, screenY + 0.5);
  }
}

// 1, 2 or 5 times a power of ten, at least `least`.
function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find((factor) => factor * power >= least * 0.999);
}
