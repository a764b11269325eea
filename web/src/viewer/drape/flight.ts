/** Automatic camera motion: a flight to another orbit, or a turntable. */
import {onTheWay, turned, type Orbit} from './camera.js';

/** Duration of a flight. [ms] */
const flightTime = 400;
/** Duration of one turn. [ms] */
const turnTime = 12_000;

export class Flight {
  /** Returns whether the user prefers reduced motion. */
  readonly #isQuiet: () => boolean;
  #way: {readonly from: Orbit; readonly to: Orbit; readonly begun: number} | undefined;
  /** Time of the turntable's last update. [ms] */
  #turned: number | undefined;

  constructor(isQuiet: () => boolean) {
    this.#isQuiet = isQuiet;
  }

  get isMoving(): boolean {
    return this.#way !== undefined || this.#turned !== undefined;
  }

  get isTurning(): boolean {
    return this.#turned !== undefined;
  }

  /** @returns the camera's orbit right after the start */
  begin(from: Orbit, to: Orbit, now: number): Orbit {
    this.stop();
    if (this.#isQuiet()) return to;
    this.#way = {from, to, begun: now};
    return from;
  }

  turn(isTurning: boolean, now: number): void {
    this.stop();
    if (isTurning && !this.#isQuiet()) this.#turned = now;
  }

  stop(): void {
    this.#way = undefined;
    this.#turned = undefined;
  }

  /** Returns the camera's orbit at a time. */
  at(orbit: Orbit, now: number): Orbit {
    if (this.#turned !== undefined) {
      const passed = Math.min(100, now - this.#turned); // no leap after a tab was hidden
      this.#turned = now;
      return turned(orbit, (2 * Math.PI * passed) / turnTime);
    }
    if (!this.#way) return orbit;
    const {from, to, begun} = this.#way;
    const share = Math.min(1, Math.max(0, (now - begun) / flightTime));
    if (share === 1) this.#way = undefined;
    return onTheWay(from, to, share * share * (3 - 2 * share));
  }
}
