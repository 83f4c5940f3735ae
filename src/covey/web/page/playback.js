// Which game is shown, and at which time.

import { Film } from "./film.js";

const BEHIND = 0.035; // seconds: a game in play is shown late, so that two pictures can be interpolated
const STEP = 0.05;

export class Playback {
  constructor() {
    this.live = null; // the person's game, as far as it has come
    this.film = null; // what is shown: `live`, or a whole game
    this.time = 0;
    this.running = false;
    this.pace = 1;
    this.speed = 0; // of the game's time, as pictures arrive
    this.arrived = 0;
  }

  get isLive() {
    return this.film === this.live;
  }

  begin(cast, picture) {
    this.live = this.film = new Film(cast, [picture]);
    this.time = picture.time;
    this.running = false;
    this.speed = 0;
  }

  // A picture of the game in play, which arrived at `now`, in seconds.
  add(picture, now) {
    const lasted = now - this.arrived;
    if (this.speed === 0 || lasted > 0.5) this.speed = this.pace;
    else this.speed += 0.1 * ((picture.time - this.live.end) / Math.max(lasted, 0.004) - this.speed);
    this.arrived = now;
    this.live.add(picture);
  }

  // Show a whole game from its beginning.
  load(cast, pictures) {
    this.film = new Film(cast, pictures);
    this.time = pictures[0].time;
    this.running = true;
    // A record may be in any unit of time. A game of 1 to 120 units is played with seconds as units.
    const length = this.film.end - this.time;
    this.unit = length >= 1 && length <= 120 ? 1 : length / 10 || 1;
  }

  showLive() {
    this.film = this.live;
    this.time = this.live.end;
    this.running = false;
  }

  // Advance by `seconds` of real time.
  advance(seconds) {
    if (this.isLive) this.followLive(seconds);
    else if (this.running) this.time += seconds * this.pace * this.unit;
    if (this.time >= this.film.end) {
      this.time = this.film.end;
      if (!this.isLive) this.running = false;
    }
  }

  followLive(seconds) {
    const newest = this.live.end;
    if (!this.running) {
      const left = newest - this.time;
      this.time = left < 0.005 * this.pace ? newest : this.time + left * Math.min(1, 12 * seconds);
      return;
    }
    const wanted = newest - BEHIND * this.speed;
    this.time += seconds * this.speed + (wanted - this.time) * Math.min(1, 4 * seconds);
    this.time = Math.max(this.time, this.live.pictures[0].time);
  }

  step() {
    this.running = false;
    this.time = Math.min(this.time + STEP * this.unit, this.film.end);
  }

  seek(time) {
    this.running = false;
    this.time = Math.min(time, this.film.end);
  }

  get ended() {
    return !this.isLive && this.time >= this.film.end;
  }

  get moment() {
    return this.film.at(this.time);
  }
}
