// A game as a sequence of pictures, and the state at any time between two pictures.

export class Film {
  constructor(cast, pictures) {
    this.cast = cast;
    this.pictures = pictures;
  }

  get end() {
    return this.pictures[this.pictures.length - 1].time;
  }

  add(picture) {
    this.pictures.push(picture);
  }

  // Number of the last picture that is not after `time`.
  indexAt(time) {
    let low = 0;
    let high = this.pictures.length - 1;
    while (low < high) {
      const middle = Math.ceil((low + high) / 2);
      if (this.pictures[middle].time <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  // The state at `time`: positions are interpolated; plans and times are the earlier picture's.
  at(time) {
    const index = this.indexAt(time);
    const a = this.pictures[index];
    const b = this.pictures[Math.min(index + 1, this.pictures.length - 1)];
    const span = b.time - a.time;
    const share = span > 0 ? Math.min(Math.max((time - a.time) / span, 0), 1) : 0;
    const mix = (from, to) => from + share * (to - from);
    const evaders = a.evaders.map(([x, y, heading, turn], i) => {
      const [nextX, nextY, nextHeading] = b.evaders[i];
      const bend = Math.atan2(Math.sin(nextHeading - heading), Math.cos(nextHeading - heading));
      return [mix(x, nextX), mix(y, nextY), heading + share * bend, turn];
    });
    const pursuer = a.pursuer.map((value, k) => mix(value, b.pursuer[k]));
    // At a capture the disk collapses at once, so a shrinking disk isn't interpolated.
    const grows = b.disk[2] >= a.disk[2] && a.captured.length === b.captured.length;
    const disk = a.disk.map((value, k) => (grows ? mix(value, b.disk[k]) : value));
    const flight = [b.pursuer[0] - a.pursuer[0], b.pursuer[1] - a.pursuer[1]];
    return { ...a, index, time: mix(a.time, b.time), planned: a.evaders, plannedAt: a.time, evaders, pursuer, disk, flight };
  }
}

// Position of an evader on its plan, `wait` after a picture: it turns, then flies straight.
export function ahead([x, y, heading, turn], speed, turnRate, wait) {
  const turning = turnRate === null || turnRate === 0 ? 0 : Math.min(wait, Math.abs(turn) / turnRate);
  if (turnRate === null) heading += turn;
  if (turning > 0) {
    const radius = (Math.sign(turn) * speed) / turnRate;
    const after = heading + Math.sign(turn) * turnRate * turning;
    x += radius * (Math.sin(after) - Math.sin(heading));
    y -= radius * (Math.cos(after) - Math.cos(heading));
    heading = after;
  }
  const straight = speed * (wait - turning);
  return [x + straight * Math.cos(heading), y + straight * Math.sin(heading)];
}
