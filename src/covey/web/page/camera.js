// Which part of the plane is shown: everybody in the game, and a margin.

const ROOM = 1.5;
const SECONDS = 0.35; // time constant of the view
const LEAST_SHARE = 0.45; // of the first view: a limit on how far the last chase is magnified

export class Camera {
  constructor() {
    this.x = 0;
    this.y = 0;
    this.half = 1;
    this.least = 0;
    this.width = 1;
    this.height = 1;
    this.insets = { top: 0, right: 0, bottom: 0, left: 0 };
    this.reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
  }

  resize(width, height) {
    Object.assign(this, { width, height });
  }

  // Pixels per length.
  get scale() {
    const { top, right, bottom, left } = this.insets;
    return Math.max(Math.min(this.width - left - right, this.height - top - bottom), 50) / (2 * this.half);
  }

  toScreen(x, y) {
    const { top, right, bottom, left } = this.insets;
    return [
      (this.width + left - right) / 2 + (x - this.x) * this.scale,
      (this.height + top - bottom) / 2 - (y - this.y) * this.scale,
    ];
  }

  toPlane(screenX, screenY) {
    const { top, right, bottom, left } = this.insets;
    return [
      this.x + (screenX - (this.width + left - right) / 2) / this.scale,
      this.y - (screenY - (this.height + top - bottom) / 2) / this.scale,
    ];
  }

  // Show these positions at once. `insets`: pixels at each side that are covered.
  cut(positions, insets) {
    this.insets = { ...insets };
    this.least = 0;
    const wanted = this.wanted(positions);
    this.least = LEAST_SHARE * wanted.half;
    Object.assign(this, wanted);
  }

  follow(positions, insets, seconds) {
    const wanted = this.wanted(positions);
    if (this.reducedMotion.matches) {
      if (!this.holds(positions)) Object.assign(this, wanted, { half: 1.3 * wanted.half });
      return;
    }
    const share = 1 - Math.exp(-seconds / SECONDS);
    for (const side of Object.keys(insets)) this.insets[side] += share * (insets[side] - this.insets[side]);
    for (const key of ["x", "y", "half"]) this[key] += share * (wanted[key] - this[key]);
  }

  wanted(positions) {
    const [left, right] = range(positions.map(([x]) => x));
    const [low, high] = range(positions.map(([, y]) => y));
    const wide = (this.width - this.insets.left - this.insets.right) / (this.height - this.insets.top - this.insets.bottom);
    // The narrower side of the view is 2 * half long.
    const half = (ROOM / 2) * Math.max((right - left) / Math.max(wide, 1), (high - low) * Math.min(wide, 1));
    return { x: (left + right) / 2, y: (low + high) / 2, half: Math.max(half, this.least) || 1 };
  }

  holds(positions) {
    return positions.every(([x, y]) => {
      const [screenX, screenY] = this.toScreen(x, y);
      return screenX > 20 && screenY > 20 && screenX < this.width - 20 && screenY < this.height - 90;
    });
  }
}

function range(values) {
  return values.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
}
