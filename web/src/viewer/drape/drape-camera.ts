/** The camera of a drape: its orbit, its home, and its motion. */
import {
  facing,
  fieldOfView,
  keyTurn,
  movedBy,
  nearer,
  nearestPreset,
  onTheWay,
  presetOrbit,
  turned,
  type CameraPreset,
  type Orbit,
} from './camera.js';
import type {Box3, Vector} from './space.js';

/** Move for an arrow key with Shift. [heights of the picture] */
const keyPan = 0.1;

const arrows: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Box in view, and aspect ratio of the picture. */
interface Room {
  /** Undefined without a garment. */
  readonly box: Box3 | undefined;
  readonly aspect: number;
}

export class DrapeCamera {
  readonly #room: () => Room;
  readonly #changed: () => void;
  readonly #flight: Flight;
  #preset: CameraPreset = 'front';
  #orbit: Orbit | undefined;
  /**
   * The user has not moved the camera since it was placed, so it is fitted again when the room
   * changes.
   */
  #isFitted = true;

  /** @param changed called after each move except the steps of a flight */
  constructor(room: () => Room, isQuiet: () => boolean, changed: () => void) {
    this.#room = room;
    this.#changed = changed;
    this.#flight = new Flight(isQuiet);
  }

  /** Undefined without a garment. */
  get orbit(): Orbit | undefined {
    return this.#orbit;
  }

  /** Orbit of the preset. */
  get home(): Orbit | undefined {
    const {box, aspect} = this.#room();
    return box && presetOrbit(this.#preset, box, aspect);
  }

  /** Preset nearest to the orbit. */
  get preset(): CameraPreset {
    return this.#orbit ? nearestPreset(this.#orbit) : this.#preset;
  }

  get isMoving(): boolean {
    return this.#flight.isMoving;
  }

  get isTurning(): boolean {
    return this.#flight.isTurning;
  }

  /** Fits the camera to another box or room, unless the user has moved it. */
  fit(): void {
    if (this.#orbit && !this.#isFitted) return;
    if (!this.#flight.isTurning || !this.#orbit) this.#orbit = this.home;
    else this.#orbit = {...(this.home ?? this.#orbit), azimuth: this.#orbit.azimuth};
    this.#changed();
  }

  /** Flies to a preset, which becomes the camera's home. */
  look(preset = this.#preset): void {
    this.#preset = preset;
    if (this.home) this.#fly(this.home);
    this.#isFitted = true;
  }

  /** Flies to face a direction. */
  face(way: Vector): void {
    if (!this.#orbit) return;
    this.#fly(facing(this.#orbit, way));
    this.#isFitted = false;
  }

  /** Turns around the garment and stops a turntable. [radians] */
  turn(azimuth: number, elevation = 0): void {
    this.#steer((orbit) => turned(orbit, azimuth, elevation));
  }

  zoomBy(factor: number): void {
    const {box, aspect} = this.#room();
    if (box)
      this.#steer((orbit) =>
        nearer(orbit, factor, presetOrbit(this.#preset, box, aspect).distance),
      );
  }

  /** Starts or stops the turntable; it never starts if the user prefers reduced motion. */
  setTurntable(isTurning: boolean): void {
    if (isTurning === this.#flight.isTurning) return;
    this.#flight.turn(isTurning, performance.now());
    this.#changed();
  }

  stop(): void {
    this.#flight.stop();
  }

  /**
   * Moves the garment in the plane of the picture.
   * @param height height of the picture, in the unit of the move
   */
  pan(right: number, up: number, height: number): void {
    const {box} = this.#room();
    if (!box) return;
    this.#steer((orbit) => {
      const scale = (2 * orbit.distance * Math.tan(fieldOfView / 2)) / height;
      return movedBy(orbit, box, -scale * right, -scale * up);
    });
  }

  /**
   * Handles an arrow key: turns the garment, or moves it with Shift.
   * @returns true for arrow keys
   */
  key(key: string, isShifted: boolean): boolean {
    const way = arrows[key];
    if (!way) return false;
    const [right, up] = way;
    if (isShifted) this.pan(keyPan * right, keyPan * up, 1);
    else this.turn(keyTurn * right, keyTurn * up);
    return true;
  }

  /** Advances a motion to now, for the picture that is being drawn. */
  advance(): Orbit | undefined {
    if (this.#orbit) this.#orbit = this.#flight.at(this.#orbit, performance.now());
    return this.#orbit;
  }

  #fly(to: Orbit): void {
    this.#orbit = this.#flight.begin(this.#orbit ?? to, to, performance.now());
    this.#changed();
  }

  #steer(change: (orbit: Orbit) => Orbit): void {
    if (!this.#orbit) return;
    this.#flight.stop();
    this.#orbit = change(this.#orbit);
    this.#isFitted = false;
    this.#changed();
  }
}

// Automatic camera motion: a flight to another orbit, or a turntable.

/** Duration of a flight. [ms] */
const flightTime = 400;
/** Duration of one turn. [ms] */
const turnTime = 12_000;

class Flight {
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
