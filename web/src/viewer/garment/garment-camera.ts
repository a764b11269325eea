/** The camera of a worn garment: where it is, where it comes home to, and how it gets there. */
import {
  facing,
  fieldOfView,
  keyTurn,
  movedBy,
  nearer,
  nearestPreset,
  presetOrbit,
  turned,
  type CameraPreset,
  type Orbit,
} from './camera.js';
import {Flight} from './flight.js';
import type {Box3, Vector} from './space.js';

/** Of an arrow key with Shift. [heights of the picture] */
const keyPan = 0.1;

const arrows: Readonly<Record<string, readonly [right: number, up: number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** What it looks at, and in which proportions. */
interface Room {
  /** Undefined while nothing is there. */
  readonly box: Box3 | undefined;
  readonly aspect: number;
}

export class GarmentCamera {
  readonly #room: () => Room;
  readonly #changed: () => void;
  readonly #flight: Flight;
  #preset: CameraPreset = 'front';
  #orbit: Orbit | undefined;
  /** Nobody has moved it since it was placed: it stays so when the room changes. */
  #isFitted = true;

  /** @param changed called after every move but those on its way */
  constructor(room: () => Room, isQuiet: () => boolean, changed: () => void) {
    this.#room = room;
    this.#changed = changed;
    this.#flight = new Flight(isQuiet);
  }

  /** Undefined while nothing is there to look at. */
  get orbit(): Orbit | undefined {
    return this.#orbit;
  }

  /** Where it comes home to. */
  get home(): Orbit | undefined {
    const {box, aspect} = this.#room();
    return box && presetOrbit(this.#preset, box, aspect);
  }

  /** The preset that it is nearest to. */
  get preset(): CameraPreset {
    return this.#orbit ? nearestPreset(this.#orbit) : this.#preset;
  }

  get isMoving(): boolean {
    return this.#flight.isMoving;
  }

  get isTurning(): boolean {
    return this.#flight.isTurning;
  }

  /** Another box or another room: placed anew, unless somebody has moved it. */
  fit(): void {
    if (this.#orbit && !this.#isFitted) return;
    if (!this.#flight.isTurning || !this.#orbit) this.#orbit = this.home;
    else this.#orbit = {...(this.home ?? this.#orbit), azimuth: this.#orbit.azimuth};
    this.#changed();
  }

  /** Goes there, and comes home to it from now on. */
  look(preset = this.#preset): void {
    this.#preset = preset;
    if (this.home) this.#fly(this.home);
    this.#isFitted = true;
  }

  /** Goes to where a direction points to. */
  face(way: Vector): void {
    if (!this.#orbit) return;
    this.#fly(facing(this.#orbit, way));
    this.#isFitted = false;
  }

  /** About the garment; a turntable stops. [radians] */
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

  /** Turns round and round, or not any more; never for who wants no motion. */
  setTurntable(isTurning: boolean): void {
    if (isTurning === this.#flight.isTurning) return;
    this.#flight.turn(isTurning, performance.now());
    this.#changed();
  }

  stop(): void {
    this.#flight.stop();
  }

  /** Moves what is seen in the plane of the picture. @param height of the picture, in the unit of the move */
  pan(right: number, up: number, height: number): void {
    const {box} = this.#room();
    if (!box) return;
    this.#steer((orbit) => {
      const scale = (2 * orbit.distance * Math.tan(fieldOfView / 2)) / height;
      return movedBy(orbit, box, -scale * right, -scale * up);
    });
  }

  /** What an arrow key means to it: it turns the garment, or with Shift moves it. @returns whether it means anything */
  key(key: string, isShifted: boolean): boolean {
    const way = arrows[key];
    if (!way) return false;
    const [right, up] = way;
    if (isShifted) this.pan(keyPan * right, keyPan * up, 1);
    else this.turn(keyTurn * right, keyTurn * up);
    return true;
  }

  /** Moves on, for a picture that is drawn now. */
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
