// Mouse, touch and keys, as a point to fly to or a direction to fly in.

const DIRECTIONS = {
  ArrowUp: [0, 1], KeyW: [0, 1], ArrowDown: [0, -1], KeyS: [0, -1],
  ArrowLeft: [-1, 0], KeyA: [-1, 0], ArrowRight: [1, 0], KeyD: [1, 0],
};

export class Steering {
  constructor(canvas, camera, onPress) {
    this.camera = camera;
    this.pointer = null; // in pixels: the view may move under it
    this.keys = new Set();
    this.sent = "";
    const move = (event) => {
      const box = canvas.getBoundingClientRect();
      this.pointer = [event.clientX - box.left, event.clientY - box.top];
      this.keys.clear();
    };
    // Also over elements on the board: in a chase nobody looks at the pointer.
    canvas.parentElement.addEventListener("pointermove", move);
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      move(event);
      onPress();
    });
    document.addEventListener("keydown", (event) => {
      if (!DIRECTIONS[event.code] || !steers(event)) return;
      event.preventDefault();
      this.keys.add(event.code);
      this.pointer = null;
      onPress();
    });
    document.addEventListener("keyup", (event) => this.keys.delete(event.code));
    addEventListener("blur", () => this.keys.clear());
  }

  reset() {
    this.sent = "";
  }

  // The point that is flown to, in the plane.
  get target() {
    return this.pointer && this.camera.toPlane(...this.pointer);
  }

  // The message that steers, or null if nothing has changed since the last message.
  message() {
    const message = { type: "steer" };
    if (this.pointer) message.target = this.target.map((value) => Number(value.toFixed(5)));
    let [x, y] = [0, 0];
    for (const key of this.keys) {
      x += DIRECTIONS[key][0];
      y += DIRECTIONS[key][1];
    }
    if (!this.pointer && (x || y)) message.heading = Math.atan2(y, x);
    const text = JSON.stringify(message);
    if (text === this.sent) return null;
    this.sent = text;
    return message;
  }
}

// Whether a key is meant for the game, and not for a field or, like Space, for a button.
export function steers(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const within = (kinds) => event.target.closest?.(kinds);
  return !within("input, select") && !(event.code === "Space" && within("button, summary"));
}
